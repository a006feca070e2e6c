// How parts and results of a study are written, and parts read again.

#include <algorithm>
#include <cmath>

#include "case-file/case_file.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/key_units.h"
#include "case-file/object_reader.h"
#include "studies/study_run.h"

namespace ravnoves::studies {

namespace {

constexpr std::string_view study_format = "ravnoves-study";
constexpr std::string_view part_format = "ravnoves-study-part";
constexpr int study_version = 1;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json write_files(const Origin& origin) {
    Json files = Json::object();
    for (const auto& [name, sum] : origin.files_sha256) {
        files[name] = sum;
    }
    return files;
}

Json write_basis(const Basis& basis) {
    Json json = {{"evaluations", basis.evaluations},
                 {"refused", write_refusals(basis.refusals)},
                 {"tried", basis.tried},
                 {"tried_refused", basis.tried_refused},
                 {"laws", Json::array()},
                 {"values", Json::array()}};
    for (const Law& law : basis.laws) {
        json["laws"].push_back({{"normal", law.normal},
                                {"mean", law.mean},
                                {"deviation", law.deviation},
                                {"fourth_moment", law.fourth_moment},
                                {"low", law.low},
                                {"high", law.high}});
    }
    for (std::size_t w = 0; w < basis.nominal.size(); ++w) {
        Json value = {{"nominal", or_null(basis.nominal[w])}, {"period", basis.periods[w]}};
        if (w < basis.expansions.size()) {
            const Taylor& expansion = basis.expansions[w];
            Json slopes = Json::array();
            for (const auto& slope : expansion.slopes) {
                slopes.push_back(slope ? Json::array({slope->value, slope->error}) : Json(nullptr));
            }
            value["expansion"] = {{"value", or_null(expansion.value)},
                                  {"slopes", std::move(slopes)},
                                  {"curvatures", expansion.curvatures},
                                  {"crossed", expansion.crossed}};
        }
        if (w < basis.departures.size()) {
            const Departure& departure = basis.departures[w];
            value["departure"] = {
                {"kind", static_cast<int>(departure.kind)},
                {"input", departure.input},
                {"at", departure.at},
                {"size", std::isfinite(departure.size) ? Json(departure.size) : Json(nullptr)},
                {"reason", departure.reason.message().english()}};
        }
        if (w < basis.distances.size()) {
            value["distance"] = basis.distances[w];
        }
        if (w < basis.plan.size()) {
            value["low"] = basis.plan[w].low;
            value["width"] = basis.plan[w].width;
            value["centre"] = basis.plan[w].centre;
        }
        json["values"].push_back(std::move(value));
    }
    return json;
}

/// @throws Json::exception where it is not what write_basis() writes
Basis read_basis(const Json& json, const Study& study) {
    const auto optional = [](const Json& value) {
        return value.is_null() ? std::nullopt : std::optional(value.get<double>());
    };
    Basis basis;
    basis.evaluations = json.at("evaluations").get<std::uint64_t>();
    basis.refusals = read_refusals(json.at("refused"), "/basis/refused");
    basis.tried = json.at("tried").get<std::uint64_t>();
    basis.tried_refused = json.at("tried_refused").get<std::uint64_t>();
    for (const Json& each : json.at("laws")) {
        basis.laws.push_back({each.at("normal").get<bool>(), each.at("mean").get<double>(),
                              each.at("deviation").get<double>(),
                              each.at("fourth_moment").get<double>(), each.at("low").get<double>(),
                              each.at("high").get<double>()});
    }
    const Json& values = json.at("values");
    for (std::size_t w = 0; w < study.watch.size(); ++w) {
        const Json& value = values.at(w);
        basis.nominal.push_back(optional(value.at("nominal")));
        basis.periods.push_back(value.at("period").get<double>());
        if (value.contains("expansion")) {
            const Json& from = value.at("expansion");
            Taylor expansion{.value = optional(from.at("value")),
                             .slopes = {},
                             .curvatures = from.at("curvatures").get<std::vector<double>>(),
                             .crossed = from.at("crossed").get<std::vector<double>>()};
            for (std::size_t j = 0; j < study.vary.size(); ++j) {
                const Json& slope = from.at("slopes").at(j);
                expansion.slopes.push_back(
                    slope.is_null() ? std::nullopt
                                    : std::optional(Taylor::Slope{slope.at(0).get<double>(),
                                                                  slope.at(1).get<double>()}));
            }
            basis.expansions.push_back(std::move(expansion));
        }
        if (value.contains("departure")) {
            const Json& from = value.at("departure");
            const auto size = optional(from.at("size"));
            basis.departures.push_back(
                {static_cast<Departure::Kind>(std::clamp(from.at("kind").get<int>(), 0, 3)),
                 std::min(from.at("input").get<std::size_t>(), study.vary.size() - 1),
                 from.at("at").get<double>(),
                 size.value_or(std::numeric_limits<double>::infinity()),
                 {{}, from.at("reason").get<std::string>()}});
        }
        if (value.contains("distance")) {
            basis.distances.push_back(value.at("distance").get<double>());
        }
        if (value.contains("low")) {
            basis.plan.push_back({value.at("low").get<double>(), value.at("width").get<double>(),
                                  value.at("centre").get<double>(), basis.periods.back(),
                                  study.watch[w].min, study.watch[w].max});
        }
    }
    return basis;
}

Json write_row(const Row& row) {
    Json list = Json::array();
    for (const auto& value : row) {
        list.push_back(or_null(value));
    }
    return list;
}

std::vector<Row> read_rows(const Json& json, std::size_t columns) {
    std::vector<Row> rows;
    for (const Json& each : json) {
        Row row;
        for (std::size_t i = 0; i < columns; ++i) {
            row.push_back(each.at(i).is_null() ? std::nullopt
                                               : std::optional(each.at(i).get<double>()));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

Json by_input(const Study& study, const std::vector<double>& values) {
    Json json = Json::object();
    for (std::size_t j = 0; j < values.size(); ++j) {
        json[study.vary[j].pointer] = values[j];
    }
    return json;
}

Json write_linear(const Study& study, const Taylor& expansion, std::span<const Law> laws) {
    Json derivatives = Json::object();
    for (std::size_t j = 0; j < laws.size(); ++j) {
        const auto& slope = expansion.slopes[j];
        derivatives[study.vary[j].pointer] =
            slope ? Json{{"value", slope->value}, {"error", slope->error}} : Json(nullptr);
    }
    const auto linear = expansion.propagated(laws, false);
    return {{"standard_deviation", linear ? Json(linear->deviation) : Json(nullptr)},
            {"contributions", linear ? by_input(study, linear->first_order) : Json(nullptr)},
            {"standard_deviation_error", linear ? Json(linear->deviation_error) : Json(nullptr)},
            {"derivatives", std::move(derivatives)}};
}

Json write_percentiles(const Statistics& statistics) {
    Json json = Json::object();
    for (std::size_t i = 0; i < percent_points.size(); ++i) {
        json[format_number(percent_points[i])] = statistics.percentiles[i];
    }
    return json;
}

Json write_watched(const Part& part, std::size_t w) {
    const Study& study = part.study;
    const Basis& basis = part.basis;
    const bool sampled = is_sampled(study.method);
    const Taylor& expansion = basis.expansions[w];
    const auto propagated = expansion.propagated(basis.laws, study.method == Method::second_order);
    Json json = {{"nominal", or_null(basis.nominal[w])}};
    if (part.tally.solved() == 0 || (!sampled && !propagated)) {
        for (const char* key : {"mean", "standard_deviation", "min", "max", "percentiles"}) {
            json[key] = nullptr;
        }
        json["linear"] = write_linear(study, expansion, basis.laws);
        return json;
    }
    const Statistics found = part.tally.statistics(w);
    json["mean"] = sampled ? found.mean : propagated->mean;
    json["standard_deviation"] = !sampled                   ? Json(propagated->deviation)
                                 : part.tally.solved() >= 2 ? Json(found.deviation)
                                                            : Json(nullptr);
    json["min"] = found.min;
    json["max"] = found.max;
    json["percentiles"] = write_percentiles(found);
    if (study.watch[w].min || study.watch[w].max) {
        json["within"] = {
            {"share", found.share}, {"low", found.share_low}, {"high", found.share_high}};
    }
    json["linear"] = write_linear(study, expansion, basis.laws);
    const auto& first_order = sampled ? found.first_order : propagated->first_order;
    const auto& total = sampled ? found.total : propagated->total;
    if (!first_order.empty()) {
        json["first_order"] = by_input(study, first_order);
    }
    if (!total.empty()) {
        json["total"] = by_input(study, total);
    }
    if (sampled && !first_order.empty()) {
        json["first_order_error"] = by_input(study, found.first_order_error);
    }
    if (sampled && !total.empty()) {
        json["total_error"] = by_input(study, found.total_error);
    }
    return json;
}

/// The largest standard error of the indices where these can say too little: it is large, or an
/// index is what none can be.
std::optional<double> vague_sensitivities(const Statistics& found) {
    constexpr double large = 0.1;
    double most = 0.0;
    bool impossible = false;
    for (std::size_t j = 0; j < found.total.size(); ++j) {
        const double error = found.total_error[j];
        most = std::max(most, error);
        impossible = impossible || found.total[j] > 1.0 + 2.0 * error;
        if (j < found.first_order.size()) {
            impossible = impossible || found.first_order[j] - found.total[j] >
                                           2.0 * std::hypot(error, found.first_order_error[j]);
        }
    }
    for (const double error : found.first_order_error) {
        most = std::max(most, error);
    }
    return most > large || impossible ? std::optional(most) : std::nullopt;
}

constexpr Text no_derivative = CORE_TEXT(
    "studies", "%1 has no linear answer: a derivative does not exist at the inputs' means.");

/// A number that is but what rounding leaves of another is 0.
Number shown(double value, double size, int digits, double rounding = 1e-10) {
    return {std::abs(value) < rounding * std::abs(size) ? 0.0 : value, {}, digits};
}

Message reason_of(const Departure& departure, const Part& part, double deviation) {
    const std::string& input = part.study.vary[departure.input].pointer;
    return departure_text(departure, part.basis.laws[departure.input], input, unit_at(input),
                          deviation);
}

}  // namespace

Message departure_text(const Departure& departure, const Law& law, const std::string& input,
                       const Unit& unit, double deviation) {
    constexpr double halved_to = 1e-6;  // the place was halved to about that of the deviation
    Number at = shown(departure.at, law.deviation, 6, halved_to);
    at.unit = unit;
    if (departure.size < 0.05 * deviation) {
        return CORE_TEXT("studies", "the inputs act on it together");
    }
    switch (departure.kind) {
        case Departure::Kind::jump:
            return {CORE_TEXT("studies", "it jumps by %1 where %2 is %3"),
                    Number{departure.size, {}, 4}, input, at};
        case Departure::Kind::corner:
            return {CORE_TEXT("studies", "it has a corner where %1 is %2"), input, at};
        case Departure::Kind::refused:
            if (departure.reason.empty()) {
                return {CORE_TEXT("studies", "it does not exist where %1 is %2"), input, at};
            }
            return {CORE_TEXT("studies", "it does not exist where %1 is %2 (%3)"), input, at,
                    departure.reason.message()};
        case Departure::Kind::curved:
            break;
    }
    return {CORE_TEXT("studies", "it is curved along %1"), input};
}

Message distance_text(const std::string& name, double distance, double deviation,
                      const Message& why) {
    return {CORE_TEXT("studies",
                      "The linear answer fails for %1: samples lie %2 from it (root mean "
                      "square), at a standard deviation of %3; %4."),
            name, Number{distance, {}, 4}, Number{deviation, {}, 4}, why};
}

bool same_basis(const Basis& one, const Basis& other) {
    return write_basis(one) == write_basis(other);
}

namespace {

/// Of the means and slopes alone: what they do not know of.
void add_notes_of_expansions(const Part& part, std::vector<Note>& notes) {
    const Basis& basis = part.basis;
    if (basis.tried_refused != 0) {
        notes.push_back({{CORE_TEXT("studies",
                                    "%1 of %2 samples that were tried cannot be solved; an "
                                    "expansion does not know of these."),
                          std::to_string(basis.tried_refused), std::to_string(basis.tried)}});
    }
    const bool second = part.study.method == Method::second_order;
    for (std::size_t w = 0; w < part.study.watch.size(); ++w) {
        const std::string& name = part.study.watch[w].pointer;
        const auto found = basis.expansions[w].propagated(basis.laws, second);
        if (!found) {
            notes.push_back({{no_derivative, name}, w});
            continue;
        }
        const Departure& departure = basis.departures[w];
        // A tenth of the deviation moves a mean by some hundredths of it at most.
        const double least = std::max(0.1 * found->deviation, 1e-9 * std::abs(found->mean)) +
                             3.0 * found->deviation_error;
        const bool refused = departure.kind == Departure::Kind::refused && departure.size > 0.0;
        if (!refused && !(basis.distances[w] > least)) {
            continue;
        }
        const Message why = reason_of(departure, part, basis.distances[w]);
        if (refused) {
            notes.push_back(
                {{second ? CORE_TEXT("studies",
                                     "The second order fails for %1 within two standard "
                                     "deviations of an input: %2.")
                         : CORE_TEXT("studies",
                                     "The linear answer fails for %1 within two "
                                     "standard deviations of an input: %2."),
                  name, why},
                 w});
            continue;
        }
        notes.push_back(
            {second ? Message(CORE_TEXT("studies",
                                        "The second order fails for %1: samples lie %2 from it "
                                        "(root mean square), at a standard deviation of %3; %4."),
                              name, Number{basis.distances[w], {}, 4},
                              Number{found->deviation, {}, 4}, why)
                    : distance_text(name, basis.distances[w], found->deviation, why),
             w});
    }
}

}  // namespace

std::vector<Message> notes_of(const Part& part) {
    std::vector<Message> texts;
    for (Note& note : noted(part)) {
        texts.push_back(std::move(note.text));
    }
    return texts;
}

std::vector<Note> noted(const Part& part) {
    std::vector<Note> notes;
    for (const Message& note : part.file_notes) {
        notes.push_back({note});
    }
    if (part.study.method == Method::grid) {
        return notes;
    }
    if (!is_sampled(part.study.method)) {
        add_notes_of_expansions(part, notes);
        return notes;
    }
    if (part.tally.solved() < 2) {
        notes.push_back(
            {CORE_TEXT("studies", "A standard deviation takes two samples that can be solved.")});
        return notes;
    }
    for (std::size_t w = 0; w < part.study.watch.size(); ++w) {
        const std::string& name = part.study.watch[w].pointer;
        const auto linear = part.basis.expansions[w].propagated(part.basis.laws, false);
        const Statistics found = part.tally.statistics(w);
        if (const auto most = vague_sensitivities(found)) {
            notes.push_back({{CORE_TEXT("studies",
                                        "The samples are too few for the sensitivities of %1: "
                                        "standard errors up to %2."),
                              name, Number{*most, {}, 2}}});
        }
        if (!linear) {
            notes.push_back({{no_derivative, name}, w});
            continue;
        }
        // What three standard errors, and a thousandth that nobody minds, do not explain.
        const double least = 1e-3 * found.deviation;
        const double mean_error =
            found.deviation / std::sqrt(static_cast<double>(part.tally.solved()));
        const double period = part.basis.periods[w];
        double shift = found.mean - linear->mean;
        shift = period == 0.0 ? shift : std::remainder(shift, period);
        const bool deviation_fails =
            std::abs(found.plain_deviation - linear->deviation) >
            std::max(3.0 * std::hypot(found.deviation_error, linear->deviation_error), least);
        if (!deviation_fails && !(std::abs(shift) > std::max(3.0 * mean_error, least))) {
            continue;
        }
        const double size = std::max(std::abs(found.mean), found.plain_deviation);
        notes.push_back(
            {{CORE_TEXT("studies",
                        "The linear answer fails for %1: mean %2 and standard deviation %3 against "
                        "%4 and %5 of the samples; %6."),
              name, shown(linear->mean, size, 6), shown(linear->deviation, size, 4),
              shown(linear->mean + shift, size, 6), shown(found.plain_deviation, size, 4),
              reason_of(part.basis.departures[w], part, found.deviation)},
             w});
    }
    return notes;
}

Json write_part(const Part& part) {
    Json json = {{"format", part_format},
                 {"version", study_version},
                 {"program", part.origin.program},
                 {"scene", part.origin.scene},
                 {"title", part.origin.title},
                 {"case_sha256", part.origin.case_sha256},
                 {"files_sha256", write_files(part.origin)},
                 {"shard", part.shard},
                 {"shards", part.shards},
                 {"done", part.done},
                 {"study", write_study(part.study)},
                 {"basis", write_basis(part.basis)},
                 {"counts", part.tally.write()}};
    if (part.study.method == Method::grid) {
        json["rows"] = Json::array();
        for (std::size_t i = 0; i < part.rows.size(); ++i) {
            json["rows"].push_back(write_row(part.rows[i]));
        }
    }
    if (part.robust_best) {
        json["robust_best"] = write_robust_best(*part.robust_best);
    }
    if (!part.file_notes.empty()) {
        json["file_notes"] = english(part.file_notes);
    }
    return json;
}

Part read_part(const Json& json) {
    ObjectReader reader(json, "");
    reader.choice("format", {part_format});
    reader.integer("version", study_version, study_version);
    Part part;
    part.origin.program = reader.text("program");
    part.origin.scene = reader.text("scene");
    part.origin.title = reader.text("title");
    part.origin.case_sha256 = reader.text("case_sha256");
    ObjectReader files = reader.object("files_sha256");
    for (const std::string& name : files.keys()) {
        part.origin.files_sha256.emplace_back(name, files.text(name));
    }
    part.study = read_study(reader.raw("study"));
    const auto count = [&](const char* key, std::uint64_t least, std::uint64_t most) {
        const Json& value = reader.raw(key);
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least ||
            value.get<std::uint64_t>() > most) {
            throw InputError(reader.pointer_to(key),
                             {CORE_TEXT("core", "must be a whole number from %1 to %2"),
                              std::to_string(least), std::to_string(most)},
                             show(value));
        }
        return value.get<std::uint64_t>();
    };
    part.shards = count("shards", 1, most_shards);
    part.shard = count("shard", 1, part.shards);
    std::tie(part.from, part.to) = shard_range(part.study, part.shard, part.shards);
    part.done = count("done", part.from, part.to);
    const bool grid = part.study.method == Method::grid;
    try {
        part.basis = read_basis(reader.raw("basis"), part.study);
        if (grid) {
            part.rows =
                read_rows(reader.raw("rows"), part.study.vary.size() + part.study.watch.size());
        }
        if (reader.has("robust_best")) {
            part.robust_best = read_robust_best(reader.raw("robust_best"));
        }
        if (reader.has("file_notes")) {
            for (const Json& note : reader.raw("file_notes")) {
                part.file_notes.emplace_back(note.get<std::string>());
            }
        }
    } catch (const Json::exception&) {
        throw InputError("/basis", CORE_TEXT("studies", "is not what this program writes"));
    }
    const Basis& basis = part.basis;
    const std::size_t watched = grid ? 0 : part.study.watch.size();
    if (basis.laws.size() != (grid ? 0 : part.study.vary.size()) ||
        basis.expansions.size() != watched || basis.plan.size() != watched ||
        basis.departures.size() != watched ||
        basis.distances.size() != (is_sampled(part.study.method) ? 0 : watched) ||
        part.rows.size() != (grid ? part.done - part.from : 0)) {
        throw InputError("/basis", CORE_TEXT("studies", "is not what this program writes"));
    }
    part.tally = Tally::read(reader.raw("counts"), basis.plan, part.study.vary.size());
    reader.finish();
    return part;
}

std::vector<Refusal> refusals_of(const Part& part) {
    const Method method = part.study.method;
    std::vector<Refusal> list;
    for (const auto& [kind, refusal] : is_sampled(method) || method == Method::grid
                                           ? part.tally.refusals()
                                           : part.basis.refusals) {
        list.push_back(refusal);
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const Refusal& a, const Refusal& b) { return a.count > b.count; });
    return list;
}

Json write_results(const Part& part) {
    const Study& study = part.study;
    const bool sampled = is_sampled(study.method);
    const bool grid = study.method == Method::grid;
    std::uint64_t refused = 0;
    const std::uint64_t samples = sampled || grid ? part.done - part.from : part.basis.evaluations;
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
    for (const Refusal& refusal : refusals_of(part)) {
        refused += refusal.count;
        reasons.push_back(
            {{"reason", refusal.reason.message().english()}, {"count", refusal.count}});
    }
    json["solved"] = samples - refused;
    json["refused"] = std::move(reasons);
    if (sampled) {
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
        json["table"] = Json::array();
        for (const Row& row : part.rows) {
            json["table"].push_back(write_row(row));
        }
        if (const auto notes = notes_of(part); !notes.empty()) {
            json["notes"] = english(notes);
        }
        return json;
    }
    json["watched"] = Json::object();
    for (std::size_t w = 0; w < study.watch.size(); ++w) {
        json["watched"][study.watch[w].pointer] = write_watched(part, w);
    }
    if (part.robust_best) {
        json["robust_best"] = write_robust_best(*part.robust_best);
    }
    json["notes"] = english(notes_of(part));
    return json;
}

}  // namespace ravnoves::studies
