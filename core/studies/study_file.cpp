// How results and parts of a study are written, and parts read again.

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "case-file/case_file.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/json_text.h"
#include "case-file/object_reader.h"
#include "case-file/sha256.h"
#include "studies/study_run.h"

namespace nlohmann {

/// An empty one is null.
template <>
struct adl_serializer<std::optional<double>> {
    static void to_json(ravnoves::Json& json, const std::optional<double>& value) {
        json = value ? ravnoves::Json(*value) : ravnoves::Json();
    }
};

}  // namespace nlohmann

namespace ravnoves::studies {

namespace {

constexpr std::string_view study_format = "ravnoves-study";
constexpr int study_version = 1;

Json write_linear(const Part& part, const Taylor& expansion,
                  const std::optional<Taylor::Propagated>& linear) {
    Json derivatives = Json::object();
    Json contributions = Json::object();
    for (std::size_t j = 0; j < part.study.vary.size(); ++j) {
        const std::string& input = part.study.vary[j].pointer;
        const auto& slope = expansion.slopes[j];
        derivatives[input] =
            slope ? Json{{"value", slope->value}, {"error", slope->error}} : Json(nullptr);
        if (linear) {
            contributions[input] = linear->shares[j];
        }
    }
    return {{"standard_deviation", linear ? Json(linear->deviation) : Json(nullptr)},
            {"contributions", linear ? std::move(contributions) : Json(nullptr)},
            {"standard_deviation_error", linear ? Json(linear->deviation_error) : Json(nullptr)},
            {"derivatives", std::move(derivatives)}};
}

void write_sensitivities(const Study& study, const char* key,
                         const std::vector<std::optional<Estimate>>& found, Json& json) {
    Json& values = json[key] = Json::object();
    Json errors = Json::object();
    for (std::size_t j = 0; j < found.size(); ++j) {
        const std::string& input = study.vary[j].pointer;
        values[input] = found[j] ? Json(found[j]->value) : Json(nullptr);
        errors[input] = found[j] ? Json(found[j]->error) : Json(nullptr);
    }
    json[std::string(key) + "_error"] = std::move(errors);
}

Json write_watched(const Part& part, std::size_t w) {
    const Study& study = part.study;
    const auto [linear, found] = found_of(part, w);
    Json json = {{"nominal", part.basis.nominal[w]}};
    for (const char* key : {"mean", "standard_deviation", "min", "max", "percentiles"}) {
        json[key] = nullptr;
    }
    if (found) {
        json["mean"] = found->mean;
        if (study.method == Method::linear || part.tally.solved() >= 2) {
            json["standard_deviation"] = found->deviation;
        }
        json["min"] = found->min;
        json["max"] = found->max;
        Json& percentiles = json["percentiles"] = Json::object();
        for (std::size_t i = 0; i < percent_points.size(); ++i) {
            percentiles[format_number(percent_points[i])] = found->percentiles[i];
        }
        if (study.watch[w].min || study.watch[w].max) {
            json["within"] = {
                {"share", found->share}, {"low", found->share_low}, {"high", found->share_high}};
        }
    }
    json["linear"] = write_linear(part, part.basis.expansions[w], linear);
    if (found && is_sampled(study.method)) {
        write_sensitivities(study, "first_order", found->first_order, json);
        write_sensitivities(study, "total", found->total, json);
    }
    return json;
}

/// The linear answer of a value against samples that try it.
std::optional<Message> note_of_linear(const Part& part, std::size_t w,
                                      const Taylor::Propagated& linear) {
    const double distance = part.basis.distances[w];
    // A tenth of the deviation moves a mean by some hundredths of it at most.
    const double minimum =
        std::max(0.1 * linear.deviation, 1e-9 * std::abs(*part.basis.expansions[w].value)) +
        3.0 * linear.deviation_error;
    if (!(distance > minimum)) {
        return std::nullopt;
    }
    return Message{
        Text::tr("The linear answer fails for %1: the samples deviate from it by %2 (RMS), "
                 "standard deviation %3."),
        part.study.watch[w].pointer, Number{distance, {}, 4}, Number{linear.deviation, {}, 4}};
}

/// Where sensitivities are vague, their largest standard error.
std::optional<double> vague_sensitivities(const Statistics& found) {
    constexpr double large = 0.1;
    double maximum = 0.0;
    for (const auto* list : {&found.first_order, &found.total}) {
        for (const auto& each : *list) {
            maximum = each ? std::max(maximum, each->error) : maximum;
        }
    }
    return maximum > large ? std::optional(maximum) : std::nullopt;
}

}  // namespace

Found found_of(const Part& part, std::size_t watched) {
    const Taylor& expansion = part.basis.expansions[watched];
    Found found{.linear = expansion.propagated(part.basis.laws)};
    const bool is_linear = part.study.method == Method::linear;
    if (part.tally.solved() > 0 && (!is_linear || found.linear)) {
        found.statistics = part.tally.statistics(watched, part.blocks);
    }
    if (is_linear && found.statistics) {
        found.statistics->mean = *expansion.value;
        found.statistics->deviation = found.linear->deviation;
        found.statistics->first_order.clear();
        found.statistics->total.clear();
    }
    return found;
}

std::vector<Note> noted(const Part& part) {
    std::vector<Note> notes;
    for (const Message& note : part.file_notes) {
        notes.push_back({note});
    }
    const Basis& basis = part.basis;
    for (std::size_t j = 0; j < basis.laws.size(); ++j) {
        if (!scatters(basis.laws[j])) {
            notes.push_back({{Text::tr("%1 does not scatter and has no derivative: its tolerance "
                                       "is below the rounding of its value."),
                              part.study.vary[j].pointer}});
        }
    }
    const bool linear_study = part.study.method == Method::linear;
    if (part.study.method == Method::grid) {
        return notes;
    }
    if (linear_study && !basis.rejections.empty()) {
        notes.push_back(
            {{Text::tr(
                  "%1 of %2 trial samples cannot be solved; the linear answer does not show that."),
              std::to_string(count_of(basis.rejections)), std::to_string(tried_samples)}});
    }
    if (!linear_study && part.tally.solved() < 2) {
        notes.push_back({Text::tr("A standard deviation needs two solved samples.")});
        return notes;
    }
    for (std::size_t w = 0; w < part.study.watch.size(); ++w) {
        const std::string& name = part.study.watch[w].pointer;
        const auto [linear, found] = found_of(part, w);
        const auto maximum = found ? vague_sensitivities(*found) : std::nullopt;
        if (maximum) {
            notes.push_back({{Text::tr("The samples are too few for the sensitivities of %1: "
                                       "standard errors up to %2."),
                              name, Number{*maximum, {}, 2}}});
        }
        if (!linear) {
            notes.push_back({{Text::tr("%1 has no linear answer: a derivative does not exist at "
                                       "the inputs' means."),
                              name},
                             w});
        } else if (const auto fails = note_of_linear(part, w, *linear)) {
            notes.push_back({*fails, w});
        }
    }
    return notes;
}

std::vector<Rejection> rejections_of(const Part& part) {
    const bool linear = part.study.method == Method::linear;
    std::vector<Rejection> list;
    for (const auto& [kind, rejection] : linear ? part.basis.rejections : part.tally.rejections()) {
        list.push_back(rejection);
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const Rejection& a, const Rejection& b) { return a.count > b.count; });
    return list;
}

Json write_results(const Part& part) {
    const Study& study = part.study;
    const bool grid = study.method == Method::grid;
    std::uint64_t rejected = 0;
    const std::uint64_t samples = study.method == Method::linear ? tried_samples : part.size();
    Json json = {{"format", study_format},
                 {"version", study_version},
                 {"scene", part.origin.scene},
                 {"title", part.origin.title},
                 {"case_sha256", part.origin.case_sha256}};
    for (const auto& [name, sum] : part.origin.files_sha256) {
        json["files_sha256"][name] = sum;
    }
    json["method"] = method_words()[static_cast<std::size_t>(study.method)].word;
    json["samples"] = samples;
    Json reasons = Json::array();
    for (const Rejection& rejection : rejections_of(part)) {
        rejected += rejection.count;
        reasons.push_back({{"reason", rejection.reason.english()}, {"count", rejection.count}});
    }
    json["solved"] = samples - rejected;
    json["refused"] = std::move(reasons);
    if (is_sampled(study.method)) {
        json["seed"] = study.seed;
    }
    if (grid) {
        json["columns"] = Json::array();
        for (const Varied& varied : study.vary) {
            json["columns"].push_back(varied.pointer);
        }
        for (const Watched& watched : study.watch) {
            json["columns"].push_back(watched.pointer);
        }
        json["table"] = part.rows;
    } else {
        json["watched"] = Json::object();
        for (std::size_t w = 0; w < study.watch.size(); ++w) {
            json["watched"][study.watch[w].pointer] = write_watched(part, w);
        }
    }
    Json notes = Json::array();
    for (const Note& note : noted(part)) {
        notes.push_back(note.text.english());
    }
    if (!grid || !notes.empty()) {
        json["notes"] = std::move(notes);
    }
    return json;
}

std::string case_of_results(const Json& json) {
    const auto text = [&](const char* key) {
        const bool is_there = json.is_object() && json.contains(key) && json.at(key).is_string();
        return is_there ? json.at(key).get<std::string>() : std::string();
    };
    return text("format") == study_format ? text("case_sha256") : std::string();
}

namespace {

constexpr std::string_view part_format = "ravnoves-study-part";
constexpr int part_version = 4;

}  // namespace

/// The values of a part one behind the other: each is written to the end of a list, or read from it
/// in the same order.
class PartValues {
  public:
    PartValues() = default;
    explicit PartValues(Json written) : values_(std::move(written)), is_reading_(true) {}

    const Json& written() const { return values_; }

    /// A vector has as many values as there are in it.
    template <typename... Values>
    void operator()(Values&... values) {
        (one(values), ...);
    }
    void operator()(Part& part) {
        list(part.origin.files_sha256);
        list(part.file_notes);
        (*this)(part.origin.program, part.origin.scene, part.origin.title, part.origin.case_sha256,
                part.basis, part.blocks);
        for (Row& row : part.rows) {
            list(row);
        }
        if (is_reading_) {
            part.tally = Tally(part.basis.plan, part.study.vary.size());
        }
        part.tally.pass(*this);
    }

  private:
    /// Of any number.
    template <typename Each>
    void list(std::vector<Each>& all) {
        std::uint64_t count = all.size();
        one(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            one(is_reading_ ? all.emplace_back() : all[i]);
        }
    }
    template <typename Value>
    requires(std::is_arithmetic_v<Value> ||
             std::is_same_v<Value, std::string>) void one(Value& value) {
        if (!is_reading_) {
            values_.push_back(value);
        } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
            // A float beyond its range would have no conversion.
            value = static_cast<Value>(values_.at(at_++).get_ref<const Json::number_integer_t&>());
        } else {
            value = values_.at(at_++).get<Value>();
        }
    }
    template <typename Each>
    void one(std::vector<Each>& all) {
        std::for_each(all.begin(), all.end(), [&](Each& each) { one(each); });
    }
    template <typename Value>
    void one(std::optional<Value>& value) {
        bool is_there = value.has_value();
        one(is_there);
        if (is_there) {
            one(value ? *value : value.emplace());
        }
    }
    /// Of counts those that are not 0, each behind how many others.
    void one(std::vector<std::int64_t>& counts) {
        for (auto at = counts.begin();; ++at) {
            const auto is_count = [](std::int64_t count) { return count != 0; };
            std::int64_t others = is_reading_ ? 0 : std::find_if(at, counts.end(), is_count) - at;
            one(others);
            if (others < 0 || others > counts.end() - at) {
                throw InputError("/values", not_ours);
            }
            at += others;
            if (at == counts.end()) {
                return;
            }
            one(*at);
        }
    }
    void one(Message& message) {
        std::string text = message.english();
        one(text);
        message = text;
    }
    void one(Rejections& rejections) {
        std::vector<std::pair<std::string, Rejection>> all(rejections.begin(), rejections.end());
        list(all);
        rejections = Rejections(all.begin(), all.end());
    }
    void one(Block& block) {
        std::uint64_t samples = block.to - block.from;
        (*this)(samples, block.sums);
        if (samples != block.to - block.from) {
            throw InputError("/values", not_ours);
        }
    }
    void one(std::pair<std::string, std::string>& two) { (*this)(two.first, two.second); }
    void one(std::pair<std::string, Rejection>& two) {
        (*this)(two.second.count, two.second.first, two.first, two.second.reason);
    }
    void one(Law& x) { (*this)(x.normal, x.mean, x.deviation, x.low, x.high); }
    void one(Taylor::Slope& x) { (*this)(x.value, x.error); }
    void one(Taylor& x) { (*this)(x.value, x.slopes); }
    void one(CountingPlan& x) { (*this)(x.low, x.width, x.centre, x.period, x.min, x.max); }
    void one(Sums& x) {
        one(x.n);
        if (x.n != 0.0) {
            (*this)(x.sum, x.squares, x.versines, x.sines);
        }
    }
    void one(Basis& x) {
        (*this)(x.laws, x.nominal, x.expansions, x.plan, x.distances, x.rejections);
    }

    Json values_ = Json::array();
    std::size_t at_ = 0;
    bool is_reading_ = false;
};

namespace {

/// @param what  a copy: what is written is passed as it is read
template <typename What>
Json written(What what) {
    PartValues values;
    values(what);
    return values.written();
}

std::string sum_of(const Json& part) {
    return sha256(json_text(part, JsonLayout::one_line));
}

}  // namespace

void Tally::pass(PartValues& values) {
    values(solved_, rejections_, slice_counts_, pair_counts_);
    for (Value& value : values_) {
        values(value.bins, value.min, value.max, value.within, value.slices, value.pairs);
        // Each solved sample is in one bin, and lies within the limits or not.
        std::uint64_t counted = 0;
        bool holds = value.within >= 0 && (solved_ == 0 || value.min <= value.max) &&
                     static_cast<std::uint64_t>(value.within) <= solved_;
        for (const std::int64_t bin : value.bins) {
            holds = holds && bin >= 0 && static_cast<std::uint64_t>(bin) <= solved_;
            counted += static_cast<std::uint64_t>(bin);
        }
        if (!holds || counted != solved_) {
            throw InputError("/values", not_ours);
        }
    }
}

bool same_basis(const Basis& one, const Basis& other) {
    return written(one) == written(other);
}

Json write_part(const Part& part) {
    Json json = {
        {"format", part_format}, {"version", part_version},          {"shard", part.shard},
        {"shards", part.shards}, {"study", write_study(part.study)}, {"values", written(part)}};
    json["sha256"] = sum_of(json);
    return json;
}

Part read_part(Json json) {
    ObjectReader reader(json, "");
    constexpr Word formats[]{{part_format}};
    reader.choice("format", formats);
    if (reader.raw("version") != part_version) {
        throw InputError("/version",
                         {Text::tr("must be %1; run the parts of other versions again"),
                          std::to_string(part_version)},
                         show(json["version"]));
    }
    const std::string sum = reader.text("sha256");
    json.erase("sha256");
    if (sum != sum_of(json)) {
        throw InputError(
            "/sha256",
            Text::tr("is not the checksum of the part: the part was changed; run it again"));
    }
    const std::uint64_t shards = reader.whole("shards", 1, max_blocks);
    const std::uint64_t shard = reader.whole("shard", 1, shards);
    try {
        Part part = empty_part(read_study(reader.raw("study")), shard, shards);
        PartValues values(reader.raw("values"));
        values(part);
        auto solved = static_cast<double>(part.tally.solved() * part.basis.plan.size());
        for (const Block& block : part.blocks) {
            for (const Sums& each : block.sums) {
                solved -= each.n;
            }
        }
        if (solved != 0.0) {
            throw InputError("/values", not_ours);
        }
        return part;
    } catch (const Json::exception&) {
        throw InputError("", not_ours);
    }
}

}  // namespace ravnoves::studies
