#include "workshop/plugs/model/v8_text.h"

#include "v8-plugs/presets.h"

namespace ravnoves::v8_text {

using namespace v8_plugs;

QString thread(const Words& words, const Thread& thread) {
    return QStringLiteral("M%1×%2").arg(words.plain(thread.diameter / units::mm, 2),
                                        words.plain(thread.pitch / units::mm, 2));
}

QString engineName(const Words& words, const std::string& name) {
    if (name.empty()) {
        return words.text(field::engine.placeholder);
    }
    QString text = QString::fromStdString(name);
    if (find_preset(name) == nullptr || !text.endsWith(QLatin1String(" l"))) {
        return text;
    }
    return words.plain(text.chopped(2).toDouble(), 2) + QChar(0x00A0) +
           words.translate("V8", "l", "litre");
}

}  // namespace ravnoves::v8_text
