#include "workshop/model/verdict.h"

namespace ravnoves {

QString verdictWord(const std::optional<bool>& measured, const std::optional<bool>& corrected) {
    if (!measured) {
        return {};
    }
    if (*measured) {
        return QStringLiteral("passes");
    }
    return !corrected   ? QStringLiteral("fails")
           : *corrected ? QStringLiteral("fails-then-passes")
                        : QStringLiteral("fails-then-fails");
}

const QString otherBobWeight = QStringLiteral("other-bob-weight");
const QString otherCrankshaft = QStringLiteral("other-crankshaft");

QString otherBobWeightText(const Words& words, double then, double now) {
    return words
        .translate("BobWeights",
                   "The readings were taken with another bob weight: %1 then, %2 now. Take them "
                   "again, or say on the sheet of the machine that they hold.")
        .arg(words.number(then, units::gram, 1), words.number(now, units::gram, 1));
}

QString otherCrankshaftText(const Words& words, const std::string& then, const std::string& now) {
    return words
        .translate("BobWeights",
                   "The readings are of another crankshaft: number %1 then, %2 now. Take them "
                   "again, or say on the sheet of the machine that they hold.")
        .arg(QString::fromStdString(then), QString::fromStdString(now));
}

QString verdictText(const Words& words, const QString& verdict) {
    const QString passes = words.translate("BobWeights", "passes");
    const QString fails = words.translate("BobWeights", "fails");
    const QString then = QStringLiteral(" → ");
    return verdict == QLatin1String("passes")              ? passes
           : verdict == QLatin1String("fails")             ? fails
           : verdict == QLatin1String("fails-then-passes") ? fails + then + passes
           : verdict == QLatin1String("fails-then-fails")  ? fails + then + fails
           : verdict == otherBobWeight  ? words.translate("BobWeights", "another bob weight")
           : verdict == otherCrankshaft ? words.translate("BobWeights", "another crankshaft")
                                        : QString();
}

}  // namespace ravnoves
