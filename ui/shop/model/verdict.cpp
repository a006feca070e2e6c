#include "shop/model/verdict.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

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

namespace {

struct KnownVerdict {
    const char* word;
    VerdictKind kind;
    const char* text;
};

/// All of them, with what page, card and journal say.
constexpr KnownVerdict knownVerdicts[] = {
    {"passes", VerdictKind::Pass, QT_TRANSLATE_NOOP("Workshop", "PASS")},
    {"passes-with-warnings", VerdictKind::Pass,
     QT_TRANSLATE_NOOP("Workshop", "PASS, but see the warnings")},
    {"fails", VerdictKind::Fail, QT_TRANSLATE_NOOP("Workshop", "FAIL")},
    {"fails-then-passes", VerdictKind::Open,
     QT_TRANSLATE_NOOP("Workshop", "FAIL → drill, then PASS")},
    {"fails-then-fails", VerdictKind::Fail,
     QT_TRANSLATE_NOOP("Workshop", "FAIL → drill, still FAIL")},
    {"fails-without-hole", VerdictKind::Fail,
     QT_TRANSLATE_NOOP("Workshop", "FAIL: no hole is possible")},
    {"other-bob-weight", VerdictKind::Open, QT_TRANSLATE_NOOP("Workshop", "another bob weight")},
    {"other-crankshaft", VerdictKind::Open, QT_TRANSLATE_NOOP("Workshop", "another crankshaft")},
    {"stopped", VerdictKind::Fail, QT_TRANSLATE_NOOP("Workshop", "STOP")},
};

const KnownVerdict* knownVerdict(const QString& verdict) {
    const auto* found = std::ranges::find_if(knownVerdicts, [&](const KnownVerdict& each) {
        return verdict == QLatin1String(each.word);
    });
    return found == std::end(knownVerdicts) ? nullptr : found;
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

}  // namespace ravnoves
