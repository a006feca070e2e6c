#include "studies/study.h"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/key_units.h"
#include "case-file/object_reader.h"

namespace ravnoves::studies {

namespace {

constexpr std::size_t max_varied = 1000;
constexpr std::size_t max_watched = 32;

using Spread = Varied::Spread;

/// The spreads that one number says.
constexpr std::array sizes{std::pair{"plus_minus", Spread::plus_minus},
                           std::pair{"plus_minus_percent", Spread::plus_minus_percent},
                           std::pair{"normal_sd", Spread::normal}};

constexpr std::array methods{
    Word{"linear", Text::tr("Linear")},
    Word{"monte-carlo", Text::tr("Monte Carlo")},
    Word{"sobol", Text::tr("Sobol points")},
    Word{"grid", Text::tr("Grid")},
};

/// Methods of older cases, and what is said of them.
constexpr std::array former_methods{
    Word{"second-order", Text::tr("must be \"linear\" or \"sobol\": second-order studies are no "
                                  "longer supported")},
    Word{"latin-hypercube", Text::tr("must be \"sobol\" or \"monte-carlo\": Latin hypercubes are "
                                     "no longer supported")},
};

Varied read_varied(const std::string& pointer, ObjectReader reader) {
    Varied varied{.pointer = pointer};
    constexpr Range positive = Range::greater_than(0.0);
    int given = 0;
    for (const auto& [key, spread] : sizes) {
        if (reader.has(key)) {
            ++given;
            varied.spread = spread;
            varied.size = reader.number(key, positive);
        }
    }
    if (reader.has("values")) {
        ++given;
        varied.spread = Spread::grid;
        varied.values = reader.numbers("values", Range{});
        if (varied.values.empty()) {
            throw InputError(reader.pointer_to("values"), Text::tr("must not be empty"));
        }
    }
    if (reader.has("from") || reader.has("to") || reader.has("steps")) {
        ++given;
        varied.from = reader.number("from", Range{});
        varied.to = reader.number("to", Range::greater_than(varied.from));
        if (!std::isfinite(varied.to - varied.from)) {
            throw InputError(
                reader.pointer_to("to"),
                Text::tr("must be nearer to from: their difference exceeds the range of numbers"),
                Number{varied.to});
        }
        varied.spread = Spread::uniform;
        if (reader.has("steps")) {
            varied.spread = Spread::grid;
            varied.steps = static_cast<int>(reader.whole("steps", 2, max_grid_points));
            varied.values = spaced(varied.from, varied.to, varied.steps);
        }
    }
    reader.finish();
    if (given != 1) {
        throw InputError(reader.pointer(),
                         Text::tr("must have one of: plus_minus, plus_minus_percent, normal_sd, "
                                  "from with to, values"));
    }
    return varied;
}

/// An object of pointers; each must differ from the others.
template <typename Read>
auto read_each(ObjectReader& reader, const char* key, bool half_filled, std::size_t maximum,
               Read read) {
    std::vector<decltype(read(std::string(), reader.object(key)))> all;
    ObjectReader object = reader.object(key);
    const auto keys = object.keys();
    if ((keys.empty() && !half_filled) || keys.size() > maximum) {
        throw InputError(object.pointer(), {Text::tr("must have from 1 to %1 pointers"), maximum},
                         Number{static_cast<double>(keys.size())});
    }
    for (const std::string& pointer : keys) {
        if (!is_inner_pointer(pointer)) {
            throw InputError(object.pointer_to(pointer),
                             Text::tr("must be a JSON pointer, such as /crank_radius_mm"));
        }
        all.push_back(read(pointer, object.object(pointer)));
    }
    return all;
}

Watched read_watched(const std::string& pointer, ObjectReader reader) {
    Watched watched{.pointer = pointer};
    watched.min = reader.optional_number("min", Range{});
    watched.max = reader.optional_number("max", Range{});
    if (watched.min && watched.max && *watched.max < *watched.min) {
        throw InputError(
            reader.pointer_to("max"),
            {unit_at(pointer) == units::degree
                 ? Text::tr("must be at least %1; across 0° add the period of the angle")
                 : Text::tr("must be at least %1"),
             *watched.min},
            Number{*watched.max});
    }
    reader.finish();
    return watched;
}

/// All inputs are grids, or none; and so is the method.
void check_grid(const Study& study, bool method_is_given) {
    const bool first = !study.vary.empty() && study.vary.front().spread == Varied::Spread::grid;
    for (const Varied& varied : study.vary) {
        if ((varied.spread == Varied::Spread::grid) != first) {
            throw InputError(
                vary_place(varied.pointer),
                Text::tr("must be a grid like the others; otherwise none may be a grid"));
        }
    }
    if (method_is_given && (study.method == Method::grid) != first) {
        throw InputError("/study/method", first ? Text::tr("must be \"grid\" with listed values")
                                                : Text::tr("must not be \"grid\" without a grid"));
    }
    if (first && study.points() > max_grid_points) {
        throw InputError("/study/vary", {Text::tr("must make at most %1 points"),
                                         std::to_string(max_grid_points)});
    }
}

}  // namespace

double Law::at(double u) const {
    if (!normal) {
        return low + (high - low) * u;
    }
    using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
    return mean - deviation * std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * u, Policy());
}

Law law_of(const Varied& varied, double nominal) {
    Law law;
    if (varied.spread == Spread::normal) {
        const double size = varied.size;
        return {true, nominal, size, nominal - 3.0 * size, nominal + 3.0 * size};
    }
    law.low = varied.from;
    law.high = varied.to;
    if (varied.spread == Spread::plus_minus || varied.spread == Spread::plus_minus_percent) {
        const bool percent = varied.spread == Spread::plus_minus_percent;
        const double half = percent ? std::abs(nominal) * varied.size / 100.0 : varied.size;
        law.low = nominal - half;
        law.high = nominal + half;
    }
    const double width = law.high - law.low;
    law.mean = law.low + 0.5 * width;
    law.deviation = width / std::sqrt(12.0);
    return law;
}

std::span<const Word> method_words() {
    return methods;
}

std::vector<double> spaced(double from, double to, int steps) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(steps));
    for (int i = 0; i < steps; ++i) {
        values.push_back(i + 1 == steps ? to : from + (to - from) * i / (steps - 1));
    }
    return values;
}

std::uint64_t Study::points() const {
    if (method != Method::grid) {
        constexpr std::uint64_t of_expansion = 16'384;  // for its percentiles
        return method == Method::linear ? of_expansion : samples;
    }
    std::uint64_t product = 1;
    for (const Varied& varied : vary) {
        product = std::min(product, max_grid_points + 1) * varied.values.size();
    }
    return product;
}

std::string vary_place(const std::string& pointer) {
    return "/study/vary/" + printable(escape_segment(pointer));
}

std::string watch_place(const std::string& pointer) {
    return "/study/watch/" + printable(escape_segment(pointer));
}

Study read_study(const Json& json, bool half_filled) {
    ObjectReader reader(json, "/study");
    Study study;
    study.vary = read_each(reader, "vary", half_filled, max_varied, read_varied);
    study.watch = read_each(reader, "watch", half_filled, max_watched, read_watched);
    const bool given = reader.has("method");
    const bool is_grid = !study.vary.empty() && study.vary.front().spread == Varied::Spread::grid;
    study.method = is_grid ? Method::grid : Method::sobol;
    if (given) {
        for (const Word& former : former_methods) {
            if (reader.raw("method") == former.word) {
                throw InputError(reader.pointer_to("method"), former.label);
            }
        }
        study.method = static_cast<Method>(reader.choice("method", method_words()));
    }
    if (reader.has("samples")) {
        study.samples = reader.whole("samples", 1, max_samples);
    }
    if (reader.has("seed")) {
        study.seed = reader.whole("seed", 0, (std::uint64_t{1} << 63) - 1);
    }
    reader.finish();
    check_grid(study, given);
    return study;
}

Json write_study(const Study& study) {
    Json vary = Json::object();
    for (const Varied& varied : study.vary) {
        Json& json = vary[varied.pointer];
        for (const auto& [key, spread] : sizes) {
            if (varied.spread == spread) {
                json[key] = varied.size;
            }
        }
        if (varied.spread == Spread::grid && varied.steps == 0) {
            json["values"] = varied.values;
        } else if (varied.spread == Spread::grid || varied.spread == Spread::uniform) {
            json["from"] = varied.from;
            json["to"] = varied.to;
            if (varied.steps != 0) {
                json["steps"] = varied.steps;
            }
        }
    }
    Json watch = Json::object();
    for (const Watched& watched : study.watch) {
        Json& limits = watch[watched.pointer] = Json::object();
        if (watched.min) {
            limits["min"] = *watched.min;
        }
        if (watched.max) {
            limits["max"] = *watched.max;
        }
    }
    return {{"vary", std::move(vary)},
            {"watch", std::move(watch)},
            {"method", methods[static_cast<std::size_t>(study.method)].word},
            {"samples", study.samples},
            {"seed", study.seed}};
}

}  // namespace ravnoves::studies
