// Cases whose numbers are anything that JSON can hold. Each is an example with some numbers, or
// all, replaced, over 600 orders of magnitude or near what stood there: it is solved or rejected in
// words, in less than five seconds of the processor.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

using Random = std::mt19937_64;

struct Example {
    std::string name;
    Json document;
    std::vector<Json::json_pointer> numbers;  ///< below "input"
};

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

std::vector<Example> read_examples(const std::vector<std::filesystem::path>& folders) {
    std::vector<std::filesystem::path> paths;
    for (const auto& folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().extension() == ".json") {
                paths.push_back(entry.path());
            }
        }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Example> examples;
    for (const auto& path : paths) {
        Example example{path.filename().string(), Json::parse(read_text_file(path)), {}};
        const Json flat = Json{{"input", example.document.at("input")}}.flatten();
        for (const auto& item : flat.items()) {
            if (item.value().is_number()) {
                example.numbers.emplace_back(item.key());
            }
        }
        if (!example.numbers.empty()) {
            examples.push_back(std::move(example));
        }
    }
    return examples;
}

struct Count {
    int solved = 0;
    int rejected = 0;
    double slowest_s = 0.0;
};

/// @return what is wrong; empty where nothing is
std::string try_case(const Json& document, Count& count) {
    const std::clock_t begin = std::clock();
    std::string fault;
    try {
        solve_case(read_case(document), CaseContext{});
        ++count.solved;
    } catch (const InputError& error) {
        ++count.rejected;
        if (std::string(error.what()).find("/input") == std::string::npos) {
            fault = error.what() + std::string(": refused without a place");
        }
    } catch (const std::exception& error) {
        fault = error.what();
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    count.slowest_s = std::max(count.slowest_s, seconds);
    return fault.empty() && seconds > 5.0 ? "took " + std::to_string(seconds) + " s" : fault;
}

int run(const std::vector<std::filesystem::path>& folders, int cases) {
    std::map<std::string, std::vector<Example>> scenes;
    for (Example& example : read_examples(folders)) {
        scenes[example.document.at("scene").get<std::string>()].push_back(std::move(example));
    }
    int faults = 0;
    for (const auto& [scene, examples] : scenes) {
        Count count;
        for (int k = 0; k < cases; ++k) {
            // Case k is the same whatever came before it.
            Random random((std::uint64_t{1} << 32) + static_cast<unsigned>(k));
            const Example& example = examples[random() % examples.size()];
            Json document = example.document;
            const bool all = random() % 10 == 0;
            for (auto changes = all ? example.numbers.size() : 1 + random() % 3; changes > 0;
                 --changes) {
                const auto& at =
                    example.numbers[(all ? changes - 1 : random()) % example.numbers.size()];
                document[at] = other_number(document[at], random);
            }
            if (const std::string fault = try_case(document, count); !fault.empty()) {
                ++faults;
                std::printf("%s, case %d of %s: %s\n%s\n", scene.c_str(), k, example.name.c_str(),
                            fault.c_str(), document.dump().c_str());
            }
        }
        std::printf("%-16s %d solved, %d refused, slowest %.2f s\n", scene.c_str(), count.solved,
                    count.rejected, count.slowest_s);
        std::fflush(stdout);
    }
    if (scenes.empty()) {
        std::printf("no cases in the folders given\n");
        return 2;
    }
    return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ravnoves

int main(int count, char** arguments) {
    std::vector<std::filesystem::path> folders;
    int cases = 1000;
    for (int k = 1; k < count; ++k) {
        const std::string word = arguments[k];
        if (word == "--cases" && k + 1 < count) {
            cases = std::atoi(arguments[++k]);
        } else {
            folders.emplace_back(word);
        }
    }
    try {
        return ravnoves::run(folders, cases);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
