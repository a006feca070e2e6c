// How parts and results of a study are written, and parts read again.

#include <algorithm>
#include <cmath>

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
    static void from_json(const ravnoves::Json& json, std::optional<double>& value) {
        value = json.is_null() ? std::nullopt : std::optional(json.get<double>());
    }
};

}  // namespace nlohmann

namespace ravnoves::studies {

namespace {

constexpr std::string_view study_format = "ravnoves-study";
constexpr std::string_view part_format = "ravnoves-study-part";
constexpr int study_version = 1;
constexpr int part_version = 2;

Json write_files(const Origin& origin) {
    Json files = Json::object();
    for (const auto& [name, sum] : origin.files_sha256) {
        files[name] = sum;
    }
    return files;
}

Json write_basis(const Basis& basis) {
    Json json = {{"laws", Json::array()},
                 {"values", Json::array()},
                 {"distances", basis.distances},
                 {"refused", write_rejections(basis.rejections)}};
    for (const Law& law : basis.laws) {
        json["laws"].push_back({law.normal, law.mean, law.deviation, law.low, law.high});
    }
    for (std::size_t w = 0; w < basis.nominal.size(); ++w) {
        Json value = {{"nominal", basis.nominal[w]}};
        if (w < basis.plan.size()) {
            const CountingPlan& plan = basis.plan[w];
            const Taylor& expansion = basis.expansions[w];
            Json slopes = Json::array();
            for (const auto& slope : expansion.slopes) {
                slopes.push_back(slope ? Json::array({slope->value, slope->error}) : Json(nullptr));
            }
            value["expansion"] = expansion.value;
            value["slopes"] = std::move(slopes);
            value["plan"] = {plan.low, plan.width, plan.centre, plan.period};
        }
        json["values"].push_back(std::move(value));
    }
    return json;
}

Basis read_basis(const Json& json, const Study& study) {
    Basis basis;
    basis.distances = json.at("distances").get<std::vector<double>>();
    basis.rejections = read_rejections(json.at("refused"));
    const bool grid = study.method == Method::grid;
    for (std::size_t j = 0; j < study.vary.size() && !grid; ++j) {
        const Json& law = json.at("laws").at(j);
        basis.laws.push_back({law.at(0).get<bool>(), law.at(1).get<double>(),
                              law.at(2).get<double>(), law.at(3).get<double>(),
                              law.at(4).get<double>()});
    }
    for (std::size_t w = 0; w < study.watch.size(); ++w) {
        const Json& value = json.at("values").at(w);
        basis.nominal.push_back(value.at("nominal").get<std::optional<double>>());
        if (grid) {
            continue;
        }
        Taylor expansion{.value = value.at("expansion").get<std::optional<double>>(), .slopes = {}};
        for (std::size_t j = 0; j < study.vary.size(); ++j) {
            const Json& slope = value.at("slopes").at(j);
            expansion.slopes.emplace_back();
            if (!slope.is_null()) {
                expansion.slopes.back() = {slope.at(0).get<double>(), slope.at(1).get<double>()};
            }
        }
        basis.expansions.push_back(std::move(expansion));
        const Json& plan = value.at("plan");
        basis.plan.push_back({plan.at(0).get<double>(), plan.at(1).get<double>(),
                              plan.at(2).get<double>(), plan.at(3).get<double>(),
                              study.watch[w].min, study.watch[w].max});
    }
    if (!grid) {
        basis.distances.resize(study.watch.size());
    }
    return basis;
}

Json write_block(const Block& block) {
    Json json = {block.done - block.from};
    for (const Sums& each : block.sums) {
        json.push_back(each.n == 0.0
                           ? Json(nullptr)
                           : Json{each.n, each.sum, each.squares, each.versines, each.sines});
    }
    return json;
}

void read_block(const Json& json, Block& block) {
    block.done = block.from +
                 std::min(static_cast<std::uint64_t>(whole_of(json.at(0))), block.to - block.from);
    for (std::size_t i = 0; i < block.sums.size(); ++i) {
        const Json& from = json.at(i + 1);
        if (!from.is_null()) {
            block.sums[i] = {from.at(0).get<double>(), from.at(1).get<double>(),
                             from.at(2).get<double>(), from.at(3).get<double>(),
                             from.at(4).get<double>()};
        }
    }
}

std::string sum_of(const Json& part) {
    return sha256(json_text(part, JsonLayout::one_line));
}

Json write_linear(const Study& study, const Taylor& expansion, std::span<const Law> laws) {
    Json derivatives = Json::object();
    Json contributions = Json::object();
    const auto linear = expansion.propagated(laws);
    for (std::size_t j = 0; j < laws.size(); ++j) {
        const std::string& input = study.vary[j].pointer;
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
    const Basis& basis = part.basis;
    const bool sampled = is_sampled(study.method);
    const Taylor& expansion = basis.expansions[w];
    const auto linear = expansion.propagated(basis.laws);
    Json json = {{"nominal", basis.nominal[w]}};
    if (part.tally.solved() == 0 || (!sampled && !linear)) {
        for (const char* key : {"mean", "standard_deviation", "min", "max", "percentiles"}) {
            json[key] = nullptr;
        }
        json["linear"] = write_linear(study, expansion, basis.laws);
        return json;
    }
    const Statistics found = part.tally.statistics(w, part.blocks);
    json["mean"] = sampled ? found.mean : *expansion.value;
    json["standard_deviation"] = !sampled                   ? Json(linear->deviation)
                                 : part.tally.solved() >= 2 ? Json(found.deviation)
                                                            : Json(nullptr);
    json["min"] = found.min;
    json["max"] = found.max;
    Json& percentiles = json["percentiles"] = Json::object();
    for (std::size_t i = 0; i < percent_points.size(); ++i) {
        percentiles[format_number(percent_points[i])] = found.percentiles[i];
    }
    if (study.watch[w].min || study.watch[w].max) {
        json["within"] = {
            {"share", found.share}, {"low", found.share_low}, {"high", found.share_high}};
    }
    json["linear"] = write_linear(study, expansion, basis.laws);
    if (sampled) {
        write_sensitivities(study, "first_order", found.first_order, json);
        write_sensitivities(study, "total", found.total, json);
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

bool same_basis(const Basis& one, const Basis& other) {
    return write_basis(one) == write_basis(other);
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
        const auto linear = basis.expansions[w].propagated(basis.laws);
        const auto maximum = linear_study
                                 ? std::nullopt
                                 : vague_sensitivities(part.tally.statistics(w, part.blocks));
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

Json write_part(const Part& part) {
    Json json = {{"format", part_format},
                 {"version", part_version},
                 {"program", part.origin.program},
                 {"scene", part.origin.scene},
                 {"title", part.origin.title},
                 {"case_sha256", part.origin.case_sha256},
                 {"files_sha256", write_files(part.origin)},
                 {"shard", part.shard},
                 {"shards", part.shards},
                 {"study", write_study(part.study)},
                 {"basis", write_basis(part.basis)},
                 {"blocks", Json::array()},
                 {"counts", part.tally.write()},
                 {"rows", part.rows},
                 {"file_notes", Json::array()}};
    for (const Block& block : part.blocks) {
        json["blocks"].push_back(write_block(block));
    }
    for (const Message& note : part.file_notes) {
        json["file_notes"].push_back(note.english());
    }
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
    try {
        Part part;
        part.origin = {json.at("scene").get<std::string>(),
                       json.at("title").get<std::string>(),
                       json.at("case_sha256").get<std::string>(),
                       {},
                       json.at("program").get<std::string>()};
        for (const auto& [name, file_sum] : json.at("files_sha256").items()) {
            part.origin.files_sha256.emplace_back(name, file_sum.get<std::string>());
        }
        part.study = read_study(json.at("study"));
        part.shards = std::clamp<std::uint64_t>(
            static_cast<std::uint64_t>(whole_of(json.at("shards"))), 1, max_blocks);
        part.shard = std::clamp<std::uint64_t>(
            static_cast<std::uint64_t>(whole_of(json.at("shard"))), 1, part.shards);
        part.basis = read_basis(json.at("basis"), part.study);
        part.blocks = blocks_of(part.study, part.shard, part.shards);
        for (std::size_t b = 0; b < part.blocks.size(); ++b) {
            part.blocks[b].sums.resize(part.basis.plan.size() * replicates);
            read_block(json.at("blocks").at(b), part.blocks[b]);
        }
        part.tally = Tally::read(json.at("counts"), part.basis.plan, part.study.vary.size());
        auto solved = static_cast<double>(part.tally.solved() * part.basis.plan.size());
        for (const Block& block : part.blocks) {
            for (const Sums& each : block.sums) {
                solved -= each.n;
            }
        }
        if (solved != 0.0) {
            throw InputError("/counts", not_ours);
        }
        for (std::uint64_t i = 0; part.study.method == Method::grid && i < part.size(); ++i) {
            part.rows.push_back(json.at("rows").at(i).get<Row>());
        }
        for (const Json& note : json.at("file_notes")) {
            part.file_notes.emplace_back(note.get<std::string>());
        }
        return part;
    } catch (const Json::exception&) {
        throw InputError("", not_ours);
    }
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
    const std::uint64_t samples = study.method == Method::linear ? tried_samples : part.done();
    Json json = {{"format", study_format},
                 {"version", study_version},
                 {"scene", part.origin.scene},
                 {"title", part.origin.title},
                 {"case_sha256", part.origin.case_sha256}};
    if (!part.origin.files_sha256.empty()) {
        json["files_sha256"] = write_files(part.origin);
    }
    json["method"] = method_words()[static_cast<std::size_t>(study.method)].word;
    json["samples"] = samples;
    Json reasons = Json::array();
    for (const Rejection& rejection : rejections_of(part)) {
        rejected += rejection.count;
        reasons.push_back(
            {{"reason", rejection.reason.message().english()}, {"count", rejection.count}});
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

}  // namespace ravnoves::studies
