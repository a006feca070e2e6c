#include "example_check.h"

#include <cmath>
#include <filesystem>
#include <vector>

#include "case-file/json.h"
#include "case-file/text_file.h"
#include "scenes/scenes.h"

namespace ravnoves::test {

namespace {

bool is_optimum_angle(const std::string& pointer) {
    return pointer.find("/optimum/") != std::string::npos && pointer.size() > 16 &&
           pointer.ends_with("_angle_deg");
}

bool is_direction(const std::string& pointer) {
    return pointer.ends_with("/angle_deg") || pointer.ends_with("_lag_deg") ||
           pointer.ends_with("/force_angle_deg") || pointer.ends_with("/moment_angle_deg");
}

/// The largest |number| below a value: the scale on which its zeros are zero.
double scale_of(const Json& value) {
    if (value.is_number()) {
        return std::abs(value.get<double>());
    }
    double scale = 0.0;
    if (value.is_structured()) {
        for (const auto& item : value.items()) {
            if (!item.key().ends_with("deg")) {
                scale = std::max(scale, scale_of(item.value()));
            }
        }
    }
    return scale;
}

/// The curves of a result at the crank angles that the expected samples list.
void expect_samples(const Json& samples, const Json& curves) {
    const auto angles = curves.at("crank_angle_deg").get<std::vector<double>>();
    const auto wanted = samples.at("crank_angle_deg").get<std::vector<double>>();
    for (const auto& item : samples.items()) {
        if (item.key() == "crank_angle_deg") {
            continue;
        }
        ASSERT_TRUE(curves.contains(item.key())) << "curves lack " << item.key();
        const Json& curve = curves.at(item.key());
        const double scale = scale_of(item.value());
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            std::size_t nearest = 0;
            for (std::size_t i = 0; i < angles.size(); ++i) {
                if (std::abs(angles[i] - wanted[k]) < std::abs(angles[nearest] - wanted[k])) {
                    nearest = i;
                }
            }
            ASSERT_NEAR(angles[nearest], wanted[k], 1e-9) << "no sample at " << wanted[k];
            expect_matches(item.value().at(k), curve.at(nearest),
                           "/curves/" + item.key() + " at " + std::to_string(wanted[k]), scale);
        }
    }
}

}  // namespace

void expect_matches(const Json& expected, const Json& found, const std::string& pointer,
                    double scale) {
    if (expected.is_object()) {
        ASSERT_TRUE(found.is_object()) << pointer;
        const double inner =
            std::max(scale_of(expected), pointer.find("two_term") != std::string::npos ||
                                                 pointer.find("exact") != std::string::npos
                                             ? scale
                                             : 0.0);
        for (const auto& item : expected.items()) {
            const std::string& key = item.key();
            if (key == "samples") {
                ASSERT_TRUE(found.contains("curves")) << "result lacks curves";
                expect_samples(item.value(), found.at("curves"));
                continue;
            }
            ASSERT_TRUE(found.contains(key)) << pointer << " lacks " << key;
            // The direction of a vector of no length means nothing; the contract makes it null.
            if (key == "angle_deg" && expected.contains("amplitude") &&
                expected.at("amplitude").get<double>() <= 1e-9 * scale) {
                continue;
            }
            expect_matches(item.value(), found.at(key), pointer + "/" + key, inner);
        }
        return;
    }
    if (expected.is_array()) {
        ASSERT_TRUE(found.is_array() && found.size() == expected.size()) << pointer;
        const double inner = std::max(scale, scale_of(expected));
        for (std::size_t i = 0; i < expected.size(); ++i) {
            expect_matches(expected.at(i), found.at(i), pointer + "/" + std::to_string(i), inner);
        }
        return;
    }
    if (!expected.is_number()) {
        EXPECT_EQ(expected, found) << pointer;
        return;
    }
    ASSERT_TRUE(found.is_number()) << pointer << " is " << found.dump();
    const double want = expected.get<double>();
    const double have = found.get<double>();
    double difference = std::abs(have - want);
    double tolerance = std::max(1e-6 * std::abs(want), 1e-9 * scale);
    if (is_optimum_angle(pointer)) {
        difference = std::abs(std::remainder(have - want, 360.0));
        tolerance = 0.05;
    } else if (is_direction(pointer)) {
        difference = std::abs(std::remainder(have - want, 360.0));
        tolerance = 1e-6 * 360.0;
    }
    EXPECT_LE(difference, tolerance) << pointer << ": expected " << want << ", got " << have;
}

CaseFile example(const std::string& name) {
    return parse_case(read_text_file(RAVNOVES_EXAMPLES "/" + name + ".case.json"));
}

std::vector<std::filesystem::path> example_files() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(RAVNOVES_EXAMPLES)) {
        if (entry.path().string().ends_with(".case.json")) {
            paths.push_back(entry.path());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

Json check_example(const std::string& name) {
    const std::filesystem::path folder = RAVNOVES_EXAMPLES;
    const std::filesystem::path expected_file =
        std::filesystem::path(RAVNOVES_EXPECTED) / (name + ".expected.json");
    const Json expected = parse_json(read_text_file(expected_file));
    const CaseFile file = example(name);
    EXPECT_EQ(expected.at("scene").get<std::string>(), file.scene);
    Json document = solve_case(file, CaseContext{folder});
    expect_matches(expected.at("expected"), document.at("result"), "", 0.0);
    return document;
}

}  // namespace ravnoves::test
