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

QString verdictText(const Words& words, const QString& verdict) {
    const QString passes = words.translate("BobWeights", "passes");
    const QString fails = words.translate("BobWeights", "fails");
    const QString then = QStringLiteral(" → ");
    return verdict == QLatin1String("passes")              ? passes
           : verdict == QLatin1String("fails")             ? fails
           : verdict == QLatin1String("fails-then-passes") ? fails + then + passes
           : verdict == QLatin1String("fails-then-fails")  ? fails + then + fails
                                                           : QString();
}

}  // namespace ravnoves
