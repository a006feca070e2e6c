#include "shop/model/verdict.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

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
const QString stopped = QStringLiteral("stopped");

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

namespace {

struct KnownVerdict {
    QString word;
    VerdictKind kind;
    const char* text;
};

/// All of them, with what page, card and journal say.
const std::array<KnownVerdict, 7>& knownVerdicts() {
    using Kind = VerdictKind;
    static const std::array<KnownVerdict, 7> all{{
        {QStringLiteral("passes"), Kind::Pass, QT_TRANSLATE_NOOP("Workshop", "PASS")},
        {QStringLiteral("fails"), Kind::Fail, QT_TRANSLATE_NOOP("Workshop", "FAIL")},
        {QStringLiteral("fails-then-passes"), Kind::Open,
         QT_TRANSLATE_NOOP("Workshop", "FAIL → drill, then PASS")},
        {QStringLiteral("fails-then-fails"), Kind::Fail,
         QT_TRANSLATE_NOOP("Workshop", "FAIL → drill, still FAIL")},
        {otherBobWeight, Kind::Open, QT_TRANSLATE_NOOP("Workshop", "another bob weight")},
        {otherCrankshaft, Kind::Open, QT_TRANSLATE_NOOP("Workshop", "another crankshaft")},
        {stopped, Kind::Open, QT_TRANSLATE_NOOP("Workshop", "STOP")},
    }};
    return all;
}

const KnownVerdict* knownVerdict(const QString& verdict) {
    const auto& all = knownVerdicts();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const KnownVerdict& each) { return each.word == verdict; });
    return found == all.end() ? nullptr : found;
}

}  // namespace

VerdictKind verdictKind(const QString& verdict) {
    const KnownVerdict* known = knownVerdict(verdict);
    return known != nullptr ? known->kind : VerdictKind::None;
}

QString verdictText(const Words& words, const QString& verdict) {
    const KnownVerdict* known = knownVerdict(verdict);
    return known != nullptr ? words.translate("Workshop", known->text) : QString();
}

QString refusedNote(const Words& words, const QStringList& refused) {
    return refused.isEmpty()
               ? QString()
               : words.translate("JobCard", "Not up to date, for these entries are refused: %1")
                     .arg(refused.join(QLatin1Char(' ')));
}

}  // namespace ravnoves
