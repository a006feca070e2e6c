#include "v8-plugs/plug_sizes_sheet.h"

#include "case-file/input_error.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

/// The thread that a text means; nothing where it means none.
std::optional<Thread> readThread(const QString& text) {
    try {
        return parse_thread(text.toStdString(), {});
    } catch (const InputError&) {
        return std::nullopt;
    }
}

QString nameOf(const std::optional<Thread>& thread) {
    return thread ? QString::fromStdString(thread_name(*thread)) : QString();
}

/// As a drawing has it, in the language of the program.
QString shownName(const QString& name) {
    const auto thread = readThread(name);
    return thread ? v8_text::thread(Words(), *thread) : QString();
}

}  // namespace

PlugSizesSheet::PlugSizesSheet(V8PlugsModel* model, QWidget* parent) : V8Sheet(model, parent) {
    section(tr("Plug"));
    addThread();
    for (const char* size : {"/plug/height_mm", "/plug/bore_diameter_mm", "/plug/bore_depth_mm"}) {
        number(size);
    }
    line(Theme::baseSize, [this] { return model_->plugWeightText(); });
    section(tr("Boring"));
    for (const char* size :
         {"/plug/cutter_diameter_mm", "/plug/minimum_wall_mm", "/plug/minimum_bottom_mm"}) {
        number(size);
    }
    section(tr("Density"));
    number("/plug/steel_density_kg_m3");
    number("/plug/aluminium_density_kg_m3");
    finish();
}

void PlugSizesSheet::addThread() {
    checked(field::thread, {[](const QString& typed) { return nameOf(readThread(typed)); },
                            [](const QString& typed) {
                                return tr("“%1” is no metric thread with its pitch, like %2.")
                                    .arg(typed, shownName(QStringLiteral("M22x1.5")));
                            },
                            [this] {
                                const auto& sheet = model_->input().plug;
                                return sheet ? nameOf(sheet->thread) : QString();
                            },
                            [this](const QString& step, const QString& name) {
                                model_->edit(step, [&](Input& input) {
                                    if (!input.plug) {
                                        input.plug.emplace();
                                    }
                                    input.plug->thread = readThread(name);
                                });
                            },
                            shownName});
}

}  // namespace ravnoves
