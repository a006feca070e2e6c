// A case file: solved, or rejected in words; never another exception. Where it is solved, the same
// with some of its numbers, or all, replaced by anything that JSON can hold, over 600 orders of
// magnitude or near what stood there: solved, or rejected at a place of its input, in less than
// five seconds of the processor.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/input_error.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

namespace {

using namespace ravnoves;
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

Json other_number(const Json& old, Random& random) {
    const double value = old.get<double>();
    const double sign = random() % 3 == 0 ? -1.0 : 1.0;
    switch (random() % 9) {
        case 0:
            return 0;
        case 8:
            return random() % 2 == 0 ? 5e-324 : 1e300;
        case 1:
            return sign * std::pow(10.0, uniform(random, -308.0, 308.0));
        case 2:
            return sign * std::pow(10.0, uniform(random, -12.0, 12.0));
        case 3:
            return static_cast<long long>(random() % 2001) - 1000;
        case 4:
            return value * (1.0 + uniform(random, -0.5, 0.5));
        case 5:
            return std::nextafter(value, sign * 1e308);
        case 6:
            return value * sign * std::pow(10.0, uniform(random, -3.0, 3.0));
        default:
            return old.is_number_integer() ? Json(static_cast<long long>(random() % 100))
                                           : Json(value * uniform(random, 0.0, 2.0));
    }
}

Json with_other_numbers(Json document, Random& random) {
    std::vector<Json::json_pointer> numbers;
    const Json flat = Json{{"input", document.at("input")}}.flatten();
    for (const auto& item : flat.items()) {
        if (item.value().is_number()) {
            numbers.emplace_back(item.key());
        }
    }
    const bool all = random() % 10 == 0;
    for (auto changes = numbers.empty() ? 0
                        : all           ? numbers.size()
                                        : 1 + random() % 3;
         changes > 0; --changes) {
        Json& value = document[numbers[(all ? changes - 1 : random()) % numbers.size()]];
        value = other_number(value, random);
    }
    return document;
}

/// What is wrong with how a case of other numbers is answered; empty where nothing is.
std::string fault_of(const Json& document, const CaseContext& context) {
    const std::clock_t begin = std::clock();
    std::string fault;
    try {
        solve_case(read_case(document), context);
    } catch (const InputError& error) {
        if (std::string_view(error.what()).find("/input") == std::string_view::npos) {
            fault = error.what() + std::string(": rejected without a place");
        }
    } catch (const std::exception& error) {
        fault = error.what();
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return fault.empty() && seconds > 5.0 ? "took " + std::to_string(seconds) + " s" : fault;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    CaseContext context;
    context.stays_in_directory = true;
    Json document;
    try {
        document = parse_json(text);
        solve_case(read_case(document), context);
    } catch (const InputError&) {
        return 0;  // rejected in words
    }
    try {
        studies::problem_of(read_case(document), context);
    } catch (const InputError&) {
        // rejected in words
    }
    Random random(std::hash<std::string_view>{}(text));  // the same in every run
    const std::clock_t begin = std::clock();
    for (int k = 0; k < 32 && std::clock() - begin < 2 * CLOCKS_PER_SEC; ++k) {
        const Json other = with_other_numbers(document, random);
        if (const std::string fault = fault_of(other, context); !fault.empty()) {
            std::fprintf(stderr, "%s\n%s\n", fault.c_str(), other.dump().c_str());
            std::abort();
        }
    }
    return 0;
}
