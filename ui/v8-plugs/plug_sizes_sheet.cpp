#include "v8-plugs/plug_sizes_sheet.h"

#include <QLabel>
#include <QVBoxLayout>

#include "case-file/input_error.h"
#include "theme/theme.h"
#include "v8-plugs/checked_field.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "widgets/form_section.h"

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

/// The sizes of the plug, made where there are none yet.
v8_plugs::PlugSheet& sizes(v8_plugs::Input& input) {
    if (!input.plug) {
        input.plug.emplace();
    }
    return *input.plug;
}

}  // namespace

PlugSizesSheet::PlugSizesSheet(V8PlugsModel* model, QWidget* parent) : SheetForm(model, parent) {
    using namespace v8_plugs;
    auto* plug = new FormSection(tr("Plug"), this);
    addThread(plug);
    addSize(plug, tr("&Height h"), plug_height_field, &v8_plugs::PlugSheet::height,
            tr("Of the whole plug."));
    addSize(plug, tr("&Bore diameter"), bore_diameter_field, &v8_plugs::PlugSheet::bore_diameter,
            tr("Of the bore that is there. Empty: a solid plug."));
    addSize(plug, tr("Bore de&pth"), bore_depth_field, &v8_plugs::PlugSheet::bore_depth,
            tr("From the outer face. Empty: a solid plug."));
    column_->addWidget(plug);
    QLabel* weight = wrapped(this, Theme::baseSize);
    column_->addWidget(weight);
    column_->addSpacing(Theme::space);
    follow([this, weight] { weight->setText(model_->plugWeightText()); });

    auto* boring = new FormSection(tr("Boring"), this);
    addSize(boring, tr("&Cutter diameter"), cutter_diameter_field,
            &v8_plugs::PlugSheet::cutter_diameter, tr("Empty: no boring is planned."));
    addSize(boring, tr("&Wall that must stay"), minimum_wall_field,
            &v8_plugs::PlugSheet::minimum_wall,
            tr("Between the bore and the root of the thread. Empty: no limit."));
    addSize(boring, tr("B&ottom that must stay"), minimum_bottom_field,
            &v8_plugs::PlugSheet::minimum_bottom,
            tr("Between the bore and the inner face. Empty: no limit."));
    column_->addWidget(boring);

    auto* material = new FormSection(tr("Density"), this);
    addDensity(material, tr("&Steel"), steel_density_field, &v8_plugs::PlugSheet::steel_density,
               steel_density, tr("Carbon steel 7850 kg/m³."));
    addDensity(material, tr("&Aluminium"), aluminium_density_field,
               &v8_plugs::PlugSheet::aluminium_density, aluminium_density,
               tr("Wrought alloys 2640 to 2850 kg/m³."));
    column_->addWidget(material);
    column_->addStretch();
}

void PlugSizesSheet::addThread(FormSection* section) {
    const auto nameOf = [](const std::optional<v8_plugs::Thread>& thread) {
        return thread ? QString::fromStdString(thread_name(*thread)) : QString();
    };
    CheckedField* field =
        checked(section, tr("&Thread"), QStringLiteral("thread"),
                tr("Metric thread with its pitch, like M22x1.5."),
                {[nameOf](const QString& typed) { return nameOf(readThread(typed)); },
                 [](const QString& typed) {
                     return tr("“%1” is no metric thread with its pitch, like M22x1.5.").arg(typed);
                 },
                 [this, nameOf] {
                     const auto& plug = model_->input().plug;
                     return plug ? nameOf(plug->thread) : QString();
                 },
                 [](v8_plugs::Input& input, const QString& name) {
                     sizes(input).thread = readThread(name);
                 }});
    field->setPlaceholderText(QStringLiteral("M22x1.5"));
}

void PlugSizesSheet::addSize(FormSection* section, const QString& label, const FieldSpec& spec,
                             std::optional<double> v8_plugs::PlugSheet::*member,
                             const QString& hint) {
    number(
        section, label, spec, hint,
        [this, spec, member]() -> std::optional<double> {
            const auto& sheet = model_->input().plug;
            if (!sheet || !((*sheet).*member)) {
                return std::nullopt;
            }
            return v8_plugs::in_unit(((*sheet).*member).value(), spec);
        },
        [spec, member](v8_plugs::Input& input, std::optional<double> value) {
            sizes(input).*member = value ? std::optional(*value * spec.to_si) : std::nullopt;
        });
}

void PlugSizesSheet::addDensity(FormSection* section, const QString& label, const FieldSpec& spec,
                                double v8_plugs::PlugSheet::*member, double usual,
                                const QString& hint) {
    number(
        section, label, spec, hint,
        [this, member, usual]() -> std::optional<double> {
            const auto& sheet = model_->input().plug;
            return sheet ? (*sheet).*member : usual;
        },
        [member, usual](v8_plugs::Input& input, std::optional<double> value) {
            sizes(input).*member = value.value_or(usual);
        });
}

}  // namespace ravnoves
