#include "workshop/plugs/model/v8_names.h"

#include <QStringList>

#include "text/capital.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/presets.h"

namespace ravnoves::v8_names {

using namespace v8_plugs;

namespace {

// In the order of their enumerations.
constexpr const char* shortOptions[] = {
    QT_TRANSLATE_NOOP("V8", "steel"), QT_TRANSLATE_NOOP("V8", "aluminium"),
    QT_TRANSLATE_NOOP("V8", "new: steel"), QT_TRANSLATE_NOOP("V8", "new: its own"),
    QT_TRANSLATE_NOOP("V8", "new: aluminium")};

}  // namespace

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

QString optionName(const Words& words, OptionId option) {
    return words.text(option_word(option).label);
}

QString shortOption(const Words& words, OptionId option) {
    return words.translate("V8", shortOptions[static_cast<std::size_t>(option)]);
}

QStringList missing(const Words& words, const Input& input, bool withBobWeight) {
    QStringList names;
    for (const EngineField* each : missing_fields(input.engine, withBobWeight)) {
        names << inSentence(words.name(each->field));
    }
    if (!input.changes_known()) {
        names << words.translate("V8",
                                 "changes of mass (sheet 2) or masses of the parts (sheet 3)");
    }
    return names;
}

}  // namespace ravnoves::v8_names
