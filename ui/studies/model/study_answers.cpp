#include "studies/model/study_answers.h"

#include <algorithm>
#include <cmath>

#include "text/number_text.h"

namespace ravnoves {

namespace {

constexpr std::size_t bars = 48;

StudyAnswer answerOf(const studies::Part& part, std::size_t place) {
    const studies::Watched& watched = part.study.watch[place];
    const auto [linear, found] = studies::found_of(part, place);
    StudyAnswer answer;
    answer.pointer = watched.pointer;
    answer.nominal = part.basis.nominal[place];
    if (linear) {
        answer.linearDeviation = linear->deviation;
    }
    if (!found || part.tally.solved() < 2) {
        return answer;
    }
    answer.mean = found->mean;
    answer.deviation = found->deviation;
    static_assert(studies::percent_points[2] == 5.0 && studies::percent_points[6] == 95.0);
    answer.low = found->percentiles[2];
    answer.high = found->percentiles[6];
    if (watched.min || watched.max) {
        answer.within = found->share;
        answer.withinLow = found->share_low;
        answer.withinHigh = found->share_high;
    }
    for (std::size_t j = 0; j < part.study.vary.size(); ++j) {
        const auto reported = [j](const std::vector<std::optional<studies::Estimate>>& all,
                                  double otherwise) {
            // A share within its own error is noise.
            return j < all.size() && all[j] && all[j]->value > 2.0 * all[j]->error ? all[j]->value
                                                                                   : otherwise;
        };
        const double alone = reported(found->first_order, linear ? linear->shares[j] : 0.0);
        answer.shares.push_back(
            {part.study.vary[j].pointer, alone, std::max(alone, reported(found->total, alone))});
    }
    const double low = found->percentiles.front();
    const double high = found->percentiles.back();
    if (studies::is_sampled(part.study.method) && high > low) {
        const auto counts = part.tally.histogram(place, low, high, bars);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            answer.middles.push_back(std::lerp(low, high, (static_cast<double>(i) + 0.5) / bars));
            answer.heights.push_back(static_cast<double>(counts[i]) /
                                     static_cast<double>(part.tally.solved()));
        }
    }
    return answer;
}

}  // namespace

QString StudyAnswer::text(const std::optional<double>& number, double factor) const {
    if (!number) {
        return QStringLiteral("–");
    }
    const double spread = factor * deviation.value_or(linearDeviation.value_or(0.0));
    constexpr double rounding = 1e-10;  // of numbers that do not scatter
    if (!(spread > rounding * std::abs(factor * nominal.value_or(0.0)))) {
        constexpr int digits = 7;
        return shownFormNumber(factor * *number, QLocale(), digits);
    }
    constexpr int maximum = 12;
    const int decimals =
        std::clamp(1 - static_cast<int>(std::floor(std::log10(spread))), 0, maximum);
    return fixedDecimals(factor * *number, decimals, QLocale());
}

QString StudyAnswer::withinText() const {
    if (!within) {
        return QStringLiteral("–");
    }
    const auto shown = [](const std::optional<double>& share) {
        return fixedDecimals(100.0 * share.value_or(0.0), 1, QLocale());
    };
    return QStringLiteral("%1 (%2 … %3)")
        .arg(percentText(*within), shown(withinLow), shown(withinHigh));
}

StudyAnswers answersOf(const studies::Part& part, std::size_t watched) {
    StudyAnswers answers{.values = {},
                         .solved = part.tally.solved(),
                         .rejected = studies::rejections_of(part),
                         .notes = {}};
    for (std::size_t place = 0; place < watched; ++place) {
        answers.values.push_back(answerOf(part, place));
    }
    if (watched < part.study.watch.size() && answers.solved > 0) {
        answers.feasible = part.tally.statistics(watched, part.blocks).mean;
    }
    for (const studies::Note& note : studies::noted(part)) {
        if (note.fails && *note.fails >= watched) {
            continue;
        }
        answers.notes.push_back(note.text);
        if (note.fails) {
            answers.values[*note.fails].fails = note.text;
        }
    }
    return answers;
}

}  // namespace ravnoves
