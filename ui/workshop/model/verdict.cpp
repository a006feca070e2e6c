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
        .translate("Workshop",
                   "The readings were taken with another bob weight: %1 then, %2 now. Take them "
                   "again, or say on the sheet of the machine that they hold.")
        .arg(words.number(then, units::gram, 1), words.number(now, units::gram, 1));
}

namespace {

constexpr qsizetype longestNumber = 32;  ///< letters that an answer has room for

QString inTheMiddleShort(const std::string& text) {
    const QString all = QString::fromStdString(text);
    constexpr qsizetype half = longestNumber / 2;
    return all.size() <= longestNumber ? all : all.left(half - 1) + QChar(0x2026) + all.right(half);
}

}  // namespace

QString longNumbersTip(const std::string& then, const std::string& now) {
    const QStringList both{QString::fromStdString(then), QString::fromStdString(now)};
    return both[0].size() > longestNumber || both[1].size() > longestNumber
               ? both.join(QLatin1Char('\n'))
               : QString();
}

QString otherCrankshaftText(const Words& words, const std::string& then, const std::string& now) {
    return words
        .translate("Workshop",
                   "The readings are of another crankshaft: number %1 then, %2 now. Take them "
                   "again, or say on the sheet of the machine that they hold.")
        .arg(inTheMiddleShort(then), inTheMiddleShort(now));
}

QString verdictText(const Words& words, const QString& verdict) {
    const QString passes = words.translate("Workshop", "passes");
    const QString fails = words.translate("Workshop", "fails");
    const QString then = QStringLiteral(" → ");
    return verdict == QLatin1String("passes")              ? passes
           : verdict == QLatin1String("fails")             ? fails
           : verdict == QLatin1String("fails-then-passes") ? fails + then + passes
           : verdict == QLatin1String("fails-then-fails")  ? fails + then + fails
           : verdict == otherBobWeight  ? words.translate("Workshop", "another bob weight")
           : verdict == otherCrankshaft ? words.translate("Workshop", "another crankshaft")
                                        : QString();
}

QString refusedNote(const Words& words, const QStringList& refused) {
    return refused.isEmpty()
               ? QString()
               : words.translate("JobCard", "Not up to date, for these entries are refused: %1")
                     .arg(refused.join(QLatin1Char(' ')));
}

}  // namespace ravnoves
