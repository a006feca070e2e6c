#include "case-file/input_error.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "widgets/entry_field.h"
#include "workshop/plugs/model/v8_text.h"
#include "workshop/sheets.h"

namespace ravnoves {

namespace {

/// The thread that a text means; nothing where it means none.
std::optional<v8_plugs::Thread> readThread(const QString& text) {
    try {
        return v8_plugs::parse_thread(text.toStdString(), {});
    } catch (const InputError&) {
        return std::nullopt;
    }
}

QString nameOf(const std::optional<v8_plugs::Thread>& thread) {
    return thread ? QString::fromStdString(v8_plugs::thread_name(*thread)) : QString();
}

/// As a drawing has it, in the language of the program.
QString shownName(const QString& name) {
    const auto thread = readThread(name);
    return thread ? v8_text::thread(Words(), *thread) : QString();
}

}  // namespace

PlugsSheet::PlugsSheet(WorkshopModel* model, QWidget* parent) : WorkshopSheet(model, parent) {
    plugsSection(false, {});
    line(Theme::baseSize, [this] {
        return model_->mayHavePlugs()
                   ? tr("No plugs: tick “The crankpins have sludge-trap plugs” on the sheet Job.")
                   : tr("Only a V-8 at 90° with two rods on a crankpin has sludge-trap plugs.");
    });
    plugsSection(true, tr("Crankshaft and present plugs"));
    addName();
    engineValues(v8_plugs::EngineGroup::basic);
    line(Theme::smallSize, [this] {
        return model_->hasPlugs() ? tr("All plugs are treated as equal: enter the mean mass. Match "
                                       "plugs that differ by more than 0.5 g.")
                                  : QString();
    });
    plugsSection(true, tr("Sizes of the present plug"));
    addThread();
    for (const char* size :
         {"height_mm", "bore_diameter_mm", "bore_depth_mm", "cutter_diameter_mm", "minimum_wall_mm",
          "minimum_bottom_mm", "steel_density_kg_m3", "aluminium_density_kg_m3"}) {
        number((std::string("/plugs/plug/") + size).c_str());
    }
    line(Theme::baseSize, [this] { return model_->plugWeightText(); });
    addPlugs(tr("There are &aluminium plugs"), QStringLiteral("has_aluminium_plug"),
             tr("Options include aluminium plugs instead of steel plugs."),
             v8_plugs::EngineGroup::aluminium_plug, &v8_plugs::Engine::has_aluminium_plug);
    addPlugs(tr("There are plugs of the new &design"), QStringLiteral("has_new_plug"),
             tr("Options include plugs of the new design, for a crankshaft made for them."),
             v8_plugs::EngineGroup::new_plug, &v8_plugs::Engine::has_new_plug);
    plugsSection(true, {});
    // Below the fields: they must not move while one types.
    line(Theme::smallSize, [this] { return model_->engineNote(); });
    finish();
}

/// An engine that has a name is found by it in the journal.
void PlugsSheet::addName() {
    static constexpr Field description{
        .key = "engine_name",
        .label = Text::tr("&Name of the engine"),
        .hint = Text::tr("The journal finds the jobs of an engine by its name: “Copy as new job” "
                         "takes engine and plugs from them.")};
    EntryField* name = checked(description, {[](const QString& typed) { return typed; },
                                             {},
                                             [this] { return model_->ownEngineName(); },
                                             [this](const QString& /*step*/, const QString& typed) {
                                                 model_->nameEngine(typed);
                                             },
                                             {},
                                             false});
    limitLength(name, 80);
    follow([this, name] {
        name->setPlaceholderText(model_->engineNames().value(model_->engineIndex()));
    });
}

void PlugsSheet::addThread() {
    checked(v8_plugs::field::thread,
            {[](const QString& typed) { return nameOf(readThread(typed)); },
             [](const QString& typed) {
                 return tr("“%1” is not a metric thread with pitch; example: %2.")
                     .arg(typed, shownName(QStringLiteral("M22x1.5")));
             },
             [this] {
                 const auto& plugs = model_->input().plugs;
                 return plugs && plugs->plug ? nameOf(plugs->plug->thread) : QString();
             },
             [this](const QString& step, const QString& name) {
                 model_->editPlugs(step, [&](v8_plugs::Input& plugs) {
                     if (!plugs.plug) {
                         plugs.plug.emplace();
                     }
                     plugs.plug->thread = readThread(name);
                 });
             },
             shownName});
}

void PlugsSheet::addPlugs(const QString& label, const QString& name, const QString& hint,
                          v8_plugs::EngineGroup group, bool v8_plugs::Engine::*member) {
    plugsSection(true, {});
    box(
        name, label, hint,
        [this, member] { return model_->hasPlugs() && model_->input().plugs->engine.*member; },
        [this, step = QString(label).remove(QLatin1Char('&')), group](bool on) {
            model_->setPlugs(step, group, on);
        })
        ->setFont(Theme::font(Theme::baseSize, true));
    engineValues(group);
}

}  // namespace ravnoves
