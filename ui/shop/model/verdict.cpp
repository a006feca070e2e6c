#include "shop/model/verdict.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace ravnoves {

QString verdictWord(const std::optional<bool>& measured, const std::optional<bool>& corrected,
                    bool isPlanned) {
    if (!measured) {
        return {};
    }
    if (*measured) {
        return QStringLiteral("passes");
    }
    return !corrected   ? QStringLiteral("fails")
           : *corrected ? QStringLiteral("fails-then-passes")
           : isPlanned  ? QStringLiteral("fails-then-fails")
                        : QStringLiteral("fails-without-hole");
}

const QString otherBobWeight = QStringLiteral("other-bob-weight");
const QString otherCrankshaft = QStringLiteral("other-crankshaft");
const QString stopped = QStringLiteral("stopped");
const QString passesWithWarnings = QStringLiteral("passes-with-warnings");

namespace {

struct KnownVerdict {
    QString word;
    VerdictKind kind;
    const char* text;
};

/// All of them, with what page, card and journal say.
const std::array<KnownVerdict, 9>& knownVerdicts() {
    using Kind = VerdictKind;
    static const std::array<KnownVerdict, 9> all{{
        {QStringLiteral("passes"), Kind::Pass, QT_TRANSLATE_NOOP("Workshop", "PASS")},
        {passesWithWarnings, Kind::Pass,
         QT_TRANSLATE_NOOP("Workshop", "PASS, but see the warnings")},
        {QStringLiteral("fails"), Kind::Fail, QT_TRANSLATE_NOOP("Workshop", "FAIL")},
        {QStringLiteral("fails-then-passes"), Kind::Open,
         QT_TRANSLATE_NOOP("Workshop", "FAIL → drill, then PASS")},
        {QStringLiteral("fails-then-fails"), Kind::Fail,
         QT_TRANSLATE_NOOP("Workshop", "FAIL → drill, still FAIL")},
        {QStringLiteral("fails-without-hole"), Kind::Fail,
         QT_TRANSLATE_NOOP("Workshop", "FAIL: no hole is possible")},
        {otherBobWeight, Kind::Open, QT_TRANSLATE_NOOP("Workshop", "another bob weight")},
        {otherCrankshaft, Kind::Open, QT_TRANSLATE_NOOP("Workshop", "another crankshaft")},
        {stopped, Kind::Fail, QT_TRANSLATE_NOOP("Workshop", "STOP")},
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

QString rejectedNote(const Words& words, const QStringList& rejected) {
    return rejected.isEmpty()
               ? QString()
               : words.translate("JobCard", "Result outdated: entries not accepted: %1")
                     .arg(rejected.join(QLatin1Char(' ')));
}

}  // namespace ravnoves
