#include "studies/model/study_answers.h"

#include <algorithm>
#include <cmath>

#include "case-file/json.h"
#include "text/number_text.h"

namespace ravnoves {

using studies::Varied;
using studies::Watched;

namespace {

constexpr std::size_t bars = 48;

std::optional<double> numberAt(const Json& json, const char* key) {
    return json.contains(key) && json[key].is_number() ? std::optional(json[key].get<double>())
                                                       : std::nullopt;
}

StudyAnswer answerOf(const Watched& watched, std::size_t place, const Json& found,
                     const studies::Part& part) {
    StudyAnswer answer;
    answer.pointer = watched.pointer;
    answer.nominal = numberAt(found, "nominal");
    answer.mean = numberAt(found, "mean");
    answer.deviation = numberAt(found, "standard_deviation");
    if (found.contains("percentiles") && found["percentiles"].is_object()) {
        answer.low = numberAt(found["percentiles"], "5");
        answer.high = numberAt(found["percentiles"], "95");
    }
    if (found.contains("within") && found["within"].is_object()) {
        answer.within = numberAt(found["within"], "share");
        answer.withinLow = numberAt(found["within"], "low");
        answer.withinHigh = numberAt(found["within"], "high");
    }
    const auto object = [&](const char* key) {
        return found.contains(key) && found[key].is_object() ? found[key] : Json::object();
    };
    const Json linear = object("linear");
    answer.linearDeviation = numberAt(linear, "standard_deviation");
    const Json contributions =
        linear.contains("contributions") ? linear["contributions"] : Json::object();
    const Json first = object("first_order");
    const Json total = object("total");
    for (const Varied& varied : part.study.vary) {
        const char* key = varied.pointer.c_str();
        answer.shares.push_back({varied.pointer, numberAt(contributions, key), numberAt(first, key),
                                 numberAt(total, key)});
    }
    if (studies::is_sampled(part.study.method) && part.tally.solved() > 1) {
        const studies::Statistics statistics = part.tally.statistics(place, part.blocks);
        const double low = statistics.percentiles.front();
        const double high = statistics.percentiles.back();
        if (high > low) {
            const auto counts = part.tally.histogram(place, low, high, bars);
            const double width = (high - low) / static_cast<double>(counts.size());
            for (std::size_t i = 0; i < counts.size(); ++i) {
                answer.middles.push_back(low + (static_cast<double>(i) + 0.5) * width);
                answer.heights.push_back(static_cast<double>(counts[i]) /
                                         static_cast<double>(part.tally.solved()));
            }
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
    constexpr int most = 12;
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(spread))), 0, most);
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

StudyAnswers answersOf(const studies::Part& part) {
    const Json results = studies::write_results(part);
    StudyAnswers answers;
    answers.solved = results.value("solved", std::uint64_t{0});
    answers.refused = studies::refusals_of(part);
    const std::vector<studies::Note> notes = studies::noted(part);
    for (const studies::Note& note : notes) {
        answers.notes.push_back(note.text);
    }
    if (!results.contains("watched")) {
        return answers;  // a grid is a table, nothing scatters
    }
    const Json& watched = results.at("watched");
    for (std::size_t i = 0; i < part.study.watch.size(); ++i) {
        const Watched& each = part.study.watch[i];
        if (watched.contains(each.pointer)) {
            answers.values.push_back(answerOf(each, i, watched[each.pointer], part));
            for (const studies::Note& note : notes) {
                if (note.fails == i) {
                    answers.values.back().fails = note.text;
                }
            }
        }
    }
    return answers;
}

}  // namespace ravnoves
