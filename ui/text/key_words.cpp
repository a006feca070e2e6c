#include "text/key_words.h"

#include <QCoreApplication>

#include "case-file/key_units.h"

namespace ravnoves {

namespace {

/// For the translators; a test compares them with the fields.
[[maybe_unused]] constexpr const char* words[]{
    QT_TRANSLATE_NOOP("Keys", "angle"),
    QT_TRANSLATE_NOOP("Keys", "angular speed"),
    QT_TRANSLATE_NOOP("Keys", "articulated"),
    QT_TRANSLATE_NOOP("Keys", "axial position"),
    QT_TRANSLATE_NOOP("Keys", "balance shafts"),
    QT_TRANSLATE_NOOP("Keys", "balancing"),
    QT_TRANSLATE_NOOP("Keys", "bank angle"),
    QT_TRANSLATE_NOOP("Keys", "correction"),
    QT_TRANSLATE_NOOP("Keys", "counterweights"),
    QT_TRANSLATE_NOOP("Keys", "crank angle"),
    QT_TRANSLATE_NOOP("Keys", "crankpin angle"),
    QT_TRANSLATE_NOOP("Keys", "crankshaft number"),
    QT_TRANSLATE_NOOP("Keys", "customer"),
    QT_TRANSLATE_NOOP("Keys", "cycle"),
    QT_TRANSLATE_NOOP("Keys", "cylinder"),
    QT_TRANSLATE_NOOP("Keys", "cylinder numbering"),
    QT_TRANSLATE_NOOP("Keys", "cylinders"),
    QT_TRANSLATE_NOOP("Keys", "date"),
    QT_TRANSLATE_NOOP("Keys", "distance"),
    QT_TRANSLATE_NOOP("Keys", "drill"),
    QT_TRANSLATE_NOOP("Keys", "drilled"),
    QT_TRANSLATE_NOOP("Keys", "drilled counting otherwise"),
    QT_TRANSLATE_NOOP("Keys", "drilled by"),
    QT_TRANSLATE_NOOP("Keys", "earlier runs"),
    QT_TRANSLATE_NOOP("Keys", "enabled"),
    QT_TRANSLATE_NOOP("Keys", "engine"),
    QT_TRANSLATE_NOOP("Keys", "engine number"),
    QT_TRANSLATE_NOOP("Keys", "engine overrides"),
    QT_TRANSLATE_NOOP("Keys", "envelope"),
    QT_TRANSLATE_NOOP("Keys", "factor"),
    QT_TRANSLATE_NOOP("Keys", "file"),
    QT_TRANSLATE_NOOP("Keys", "flywheel"),
    QT_TRANSLATE_NOOP("Keys", "format"),
    QT_TRANSLATE_NOOP("Keys", "free length"),
    QT_TRANSLATE_NOOP("Keys", "front read of"),
    QT_TRANSLATE_NOOP("Keys", "gears"),
    QT_TRANSLATE_NOOP("Keys", "guide radius at zero"),
    QT_TRANSLATE_NOOP("Keys", "guide search"),
    QT_TRANSLATE_NOOP("Keys", "inertia"),
    QT_TRANSLATE_NOOP("Keys", "input"),
    QT_TRANSLATE_NOOP("Keys", "job"),
    QT_TRANSLATE_NOOP("Keys", "kept"),
    QT_TRANSLATE_NOOP("Keys", "knuckle angle"),
    QT_TRANSLATE_NOOP("Keys", "knuckle mass"),
    QT_TRANSLATE_NOOP("Keys", "knuckle radius"),
    QT_TRANSLATE_NOOP("Keys", "layout"),
    QT_TRANSLATE_NOOP("Keys", "machine"),
    QT_TRANSLATE_NOOP("Keys", "map"),
    QT_TRANSLATE_NOOP("Keys", "mass"),
    QT_TRANSLATE_NOOP("Keys", "mass changes"),
    QT_TRANSLATE_NOOP("Keys", "masses"),
    QT_TRANSLATE_NOOP("Keys", "master"),
    QT_TRANSLATE_NOOP("Keys", "matching"),
    QT_TRANSLATE_NOOP("Keys", "method"),
    QT_TRANSLATE_NOOP("Keys", "motion"),
    QT_TRANSLATE_NOOP("Keys", "name"),
    QT_TRANSLATE_NOOP("Keys", "nominal"),
    QT_TRANSLATE_NOOP("Keys", "notes"),
    QT_TRANSLATE_NOOP("Keys", "offset"),
    QT_TRANSLATE_NOOP("Keys", "parts"),
    QT_TRANSLATE_NOOP("Keys", "permitted spread"),
    QT_TRANSLATE_NOOP("Keys", "pin"),
    QT_TRANSLATE_NOOP("Keys", "piston"),
    QT_TRANSLATE_NOOP("Keys", "piston sets"),
    QT_TRANSLATE_NOOP("Keys", "place limits"),
    QT_TRANSLATE_NOOP("Keys", "planes"),
    QT_TRANSLATE_NOOP("Keys", "plug"),
    QT_TRANSLATE_NOOP("Keys", "plugs"),
    QT_TRANSLATE_NOOP("Keys", "pressure"),
    QT_TRANSLATE_NOOP("Keys", "read of"),
    QT_TRANSLATE_NOOP("Keys", "readings"),
    QT_TRANSLATE_NOOP("Keys", "rear read of"),
    QT_TRANSLATE_NOOP("Keys", "reciprocating mass"),
    QT_TRANSLATE_NOOP("Keys", "reciprocating masses"),
    QT_TRANSLATE_NOOP("Keys", "relieved shaft"),
    QT_TRANSLATE_NOOP("Keys", "rings"),
    QT_TRANSLATE_NOOP("Keys", "rod"),
    QT_TRANSLATE_NOOP("Keys", "rod big end"),
    QT_TRANSLATE_NOOP("Keys", "rod counterweight"),
    QT_TRANSLATE_NOOP("Keys", "rod hinge spring"),
    QT_TRANSLATE_NOOP("Keys", "rod length"),
    QT_TRANSLATE_NOOP("Keys", "rod sets"),
    QT_TRANSLATE_NOOP("Keys", "rod small end"),
    QT_TRANSLATE_NOOP("Keys", "samples"),
    QT_TRANSLATE_NOOP("Keys", "scene"),
    QT_TRANSLATE_NOOP("Keys", "seed"),
    QT_TRANSLATE_NOOP("Keys", "shaft angle"),
    QT_TRANSLATE_NOOP("Keys", "shells"),
    QT_TRANSLATE_NOOP("Keys", "slug"),
    QT_TRANSLATE_NOOP("Keys", "solve"),
    QT_TRANSLATE_NOOP("Keys", "speed band"),
    QT_TRANSLATE_NOOP("Keys", "speeds"),
    QT_TRANSLATE_NOOP("Keys", "spring"),
    QT_TRANSLATE_NOOP("Keys", "step"),
    QT_TRANSLATE_NOOP("Keys", "stiffness"),
    QT_TRANSLATE_NOOP("Keys", "study"),
    QT_TRANSLATE_NOOP("Keys", "technician"),
    QT_TRANSLATE_NOOP("Keys", "title"),
    QT_TRANSLATE_NOOP("Keys", "tolerance"),
    QT_TRANSLATE_NOOP("Keys", "torque"),
    QT_TRANSLATE_NOOP("Keys", "unbalance"),
    QT_TRANSLATE_NOOP("Keys", "variants"),
    QT_TRANSLATE_NOOP("Keys", "vary"),
    QT_TRANSLATE_NOOP("Keys", "version"),
    QT_TRANSLATE_NOOP("Keys", "watch"),
    QT_TRANSLATE_NOOP("Keys", "weigh in"),
    QT_TRANSLATE_NOOP("Keys", "weight"),
    QT_TRANSLATE_NOOP("Keys", "weights"),
};

}  // namespace

Unit takeUnit(QString& key) {
    const KeyUnit found = unit_of_key(key.toStdString());
    key.chop(static_cast<qsizetype>(found.length));
    return found.unit;
}

QString keyInWords(const std::string& key) {
    if (key == "csv") {
        return QCoreApplication::translate("Keys", "file");
    }
    QString words = QString::fromStdString(key);
    takeUnit(words);
    words.replace(QLatin1Char('_'), QLatin1Char(' '));
    return QCoreApplication::translate("Keys", words.toUtf8().constData());
}

QString caseText(const std::string& text) {
    constexpr std::size_t digits = 64;
    constexpr qsizetype enough = 12;
    const bool isSum =
        text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
    const QString all = QString::fromStdString(text);
    return isSum ? all.left(enough) + QChar(0x2026) : all;
}

}  // namespace ravnoves
