#include "studies/model/band_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case-file/input_error.h"
#include "case-file/key_units.h"
#include "studies/sampler.h"
#include "studies/taylor.h"

namespace ravnoves {

namespace {

constexpr std::uint64_t mostBandSamples = 1024;
constexpr std::uint64_t fewestBandSamples = 64;
constexpr std::size_t mostKeptNumbers = 8'000'000;
/// Of the whole work: what is left is finding out why slopes fail.
constexpr double shareOfSamples = 0.9;

/// The work was stopped.
struct BandsStopped {};

class BandFinder {
  public:
    BandFinder(const BandTask& task, const BandValues& values,
               const std::function<bool(double)>& progress)
        : task_(task), values_(values), progress_(progress), size_(task.nominal.size()) {
        deviation_.resize(size_);
        for (const BandTask::Source& source : task_.sources) {
            for (std::size_t v = 0; v < size_; ++v) {
                deviation_[v] += source.slopes[v] * source.slopes[v];
            }
        }
        for (float& each : deviation_) {
            each = std::sqrt(each);
        }
        squares_.resize(size_);
        counts_.resize(size_);
    }

    BandAnswer find(const std::function<void(BandAnswer)>& found) {
        const bool sampled = studies::is_sampled(task_.study.method);
        const std::uint64_t room = mostKeptNumbers / std::max<std::size_t>(size_, 1);
        answer_.of = sampled ? std::min({task_.study.samples, mostBandSamples,
                                         std::max(room, fewestBandSamples)})
                             : fewestBandSamples;
        studies::Sampler sampler(sampled ? task_.study.method : studies::Method::sobol,
                                 sampled ? task_.study.points() : answer_.of, task_.study.seed,
                                 task_.study.vary.size());
        std::vector<double> u(task_.study.vary.size());
        std::uint64_t next = fewestBandSamples;
        for (std::uint64_t i = 0; i < answer_.of; ++i) {
            sampler.point(i, u);
            solve(u, sampled);
            const auto done = static_cast<double>(i + 1) / static_cast<double>(answer_.of);
            if (!progress_(shareOfSamples * done)) {
                throw BandsStopped{};
            }
            if (sampled && answer_.samples == next && i + 1 < answer_.of) {
                next *= 2;
                setPercentiles();
                found(answer_);
            }
        }
        if (sampled) {
            setPercentiles();
        }
        judge();
        return std::move(answer_);
    }

  private:
    void solve(const std::vector<double>& u, bool keeps) {
        Json input = task_.input;
        std::vector<double> standard;
        for (const BandTask::Source& source : task_.sources) {
            const double x = source.law.at(u[source.input]);
            input[source.place] = x;
            standard.push_back((x - source.law.mean) / source.law.deviation);
        }
        std::optional<std::vector<double>> there;
        try {
            there = values_(input);
        } catch (const InputError&) {
            ++answer_.refused;
            return;
        }
        if (!there) {
            throw BandsStopped{};
        }
        ++answer_.samples;
        for (std::size_t v = 0; v < size_; ++v) {
            double off = (*there)[v] - task_.nominal[v];
            if (task_.periods[v] > 0.0) {
                off = std::remainder(off, task_.periods[v]);
            }
            if (keeps) {
                kept_.push_back(static_cast<float>(off));
            }
            if (!std::isfinite(off)) {
                continue;
            }
            double expected = task_.shift[v];
            for (std::size_t j = 0; j < standard.size(); ++j) {
                expected += task_.sources[j].slopes[v] * standard[j];
            }
            const auto distance = static_cast<float>(off - expected);
            squares_[v] += distance * distance;
            ++counts_[v];
        }
    }

    void setPercentiles() {
        constexpr float none = std::numeric_limits<float>::quiet_NaN();
        answer_.below.assign(size_, none);
        answer_.above.assign(size_, none);
        std::vector<float> column;
        for (std::size_t v = 0; v < size_; ++v) {
            column.clear();
            for (std::size_t i = v; i < kept_.size(); i += size_) {
                if (std::isfinite(kept_[i])) {
                    column.push_back(kept_[i]);
                }
            }
            constexpr double enough = 0.9;
            constexpr std::size_t few = 32;
            if (column.size() < few || static_cast<double>(column.size()) <
                                           enough * static_cast<double>(answer_.samples)) {
                continue;
            }
            answer_.below[v] = -at(column, 0.05);
            answer_.above[v] = at(column, 0.95);
        }
    }

    /// Between order statistics.
    static float at(std::vector<float>& values, double share) {
        const double rank = share * static_cast<double>(values.size() - 1);
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
        std::nth_element(values.begin(), place, values.end());
        const float low = *place;
        const float high =
            place + 1 == values.end() ? low : *std::min_element(place + 1, values.end());
        return std::lerp(low, high, static_cast<float>(rank - std::floor(rank)));
    }

    float distance(std::size_t v) const {
        return counts_[v] > 0 ? std::sqrt(squares_[v] / static_cast<float>(counts_[v])) : 0.0F;
    }

    /// A group that fails, by its worst number.
    struct Failure {
        std::size_t group = 0;
        std::size_t worst = 0;
        double distance = 0.0;
    };

    std::vector<Failure> failures() const {
        std::vector<Failure> found;
        for (std::size_t g = 0; g < task_.groups.size(); ++g) {
            const BandTask::Group& group = task_.groups[g];
            Failure failure{g, group.from};
            double spread = 0.0;
            double size = 0.0;
            bool isMissing = false;
            for (std::size_t v = group.from; v < group.from + group.count; ++v) {
                if (!std::isfinite(task_.nominal[v])) {
                    continue;
                }
                spread = std::max(spread, static_cast<double>(deviation_[v]));
                size = std::max(size, std::abs(task_.nominal[v]));
                if (distance(v) > failure.distance) {
                    failure = {g, v, distance(v)};
                }
                isMissing = isMissing || (group.count == 1 && counts_[v] < answer_.samples);
            }
            // As where a study judges its expansions; floats keep seven digits.
            constexpr double rounding = 1e-6;
            if (isMissing || failure.distance > std::max(0.1 * spread, rounding * size)) {
                found.push_back(failure);
            }
        }
        return found;
    }

    void judge() {
        const std::vector<Failure> all = failures();
        for (const Failure& each : all) {
            chosen_.push_back(each.worst);
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            answer_.fails.emplace(
                all[i].group,
                studies::distance_text(task_.groups[all[i].group].name, all[i].distance,
                                       deviation_[all[i].worst], why(i, all[i].distance)));
        }
    }

    /// The chosen numbers at an input, or why it is refused.
    struct Solved {
        std::vector<double> numbers;
        Reason refusal;
    };

    /// One number of the page in the place of a study's response.
    class OneNumber final : public Response {
      public:
        OneNumber(BandFinder& finder, std::size_t number) : finder_(finder), number_(number) {}

        bool evaluate(std::span<const double> x, std::span<double> y) override {
            const Solved& all = finder_.solvedAt(x);
            reason_ = all.refusal;
            y[0] = all.numbers.empty() ? std::numeric_limits<double>::quiet_NaN()
                                       : all.numbers[number_];
            return std::isfinite(y[0]);
        }

      private:
        BandFinder& finder_;
        std::size_t number_;
    };

    /// What was solved once is known: reasons of many numbers are looked for at the same places.
    const Solved& solvedAt(std::span<const double> x) {
        const auto [place, isNew] = solved_.try_emplace(std::vector<double>(x.begin(), x.end()));
        if (isNew) {
            Json input = task_.input;
            for (std::size_t j = 0; j < x.size(); ++j) {
                input[task_.sources[j].place] = x[j];
            }
            try {
                const auto there = values_(input);
                if (!there || !progress_(shareOfSamples)) {
                    throw BandsStopped{};
                }
                for (const std::size_t v : chosen_) {
                    place->second.numbers.push_back((*there)[v]);
                }
            } catch (const InputError& error) {
                place->second.refusal = {error.where_message(), error.allowed_message()};
            }
        }
        return place->second;
    }

    /// @param chosen  place among the chosen numbers
    Message why(std::size_t chosen, double distance) {
        const std::size_t v = chosen_[chosen];
        std::vector<studies::Law> laws;
        studies::Taylor expansion{.value = task_.nominal[v] + static_cast<double>(task_.shift[v]),
                                  .slopes = {},
                                  .curvatures = {},
                                  .crossed = {}};
        for (const BandTask::Source& source : task_.sources) {
            laws.push_back(source.law);
            expansion.slopes.emplace_back(studies::Taylor::Slope{
                static_cast<double>(source.slopes[v]) / source.law.deviation, 0.0});
        }
        OneNumber number(*this, chosen);
        constexpr double reach = 3.0;
        const auto departures = studies::find_departures(number, laws, std::span(&expansion, 1),
                                                         std::span(&task_.periods[v], 1), reach);
        const studies::Departure& departure = departures.front();
        const BandTask::Source& source = task_.sources[departure.input];
        return studies::departure_text(departure, source.law, source.name,
                                       unit_at(source.place.to_string()), distance);
    }

    const BandTask& task_;
    const BandValues& values_;
    const std::function<bool(double)>& progress_;
    std::size_t size_;
    BandAnswer answer_;
    std::vector<float> kept_;       ///< off the nominal numbers, row by row
    std::vector<float> deviation_;  ///< by slopes
    std::vector<float> squares_;    ///< of the distances from what slopes say
    std::vector<std::uint64_t> counts_;
    std::vector<std::size_t> chosen_;
    std::map<std::vector<double>, Solved> solved_;
};

}  // namespace

std::optional<BandAnswer> findBands(const BandTask& task, const BandValues& values,
                                    const std::function<bool(double)>& progress,
                                    const std::function<void(BandAnswer)>& found) {
    try {
        return BandFinder(task, values, progress).find(found);
    } catch (const BandsStopped&) {
        return std::nullopt;
    }
}

}  // namespace ravnoves
