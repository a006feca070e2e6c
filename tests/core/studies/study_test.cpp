// What studies find, on functions whose moments and sensitivities are known.

#include "studies/study.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include "case-file/case_file.h"
#include "error_of.h"
#include "numerics/constants.h"
#include "studies/sampler.h"
#include "support.h"

namespace ravnoves::studies {
namespace {

using test::error_of;

constexpr std::array sampled_words{"monte-carlo", "sobol"};

std::string rejection(const Json& study) {
    return test::error_of([&] { read_study(study); });
}

TEST(Study, ReadsWhatItWritesAndRejectsTheRest) {
    const Json study = {{"vary",
                         {{"/a", {{"plus_minus", 0.02}}},
                          {"/b/c", {{"normal_sd", 2}}},
                          {"/d", {{"plus_minus_percent", 0.1}}},
                          {"/e", {{"from", -1}, {"to", 2}}}}},
                        {"watch", {{"/y", {{"max", 3}}}, {"/z", Json::object()}}},
                        {"method", "monte-carlo"},
                        {"samples", 1'000'000'000},
                        {"seed", 9'223'372'036'854'775'807}};
    EXPECT_EQ(rejection(study), "no error");
    EXPECT_EQ(write_study(read_study(study)).flatten().size(), study.flatten().size());
    EXPECT_EQ(read_study(write_study(read_study(study))), read_study(study));
    const auto with = [&](const char* pointer, const Json& value) {
        Json changed = study;
        changed[Json::json_pointer(pointer)] = value;
        return rejection(changed);
    };
    EXPECT_EQ(with("/samples", 0),
              "/study/samples: must be a whole number from 1 to 1000000000, got 0");
    EXPECT_EQ(with("/samples", 1e6), "no error");
    EXPECT_EQ(with("/samples", 1'000'000'001).substr(0, 14), "/study/samples");
    // Methods of older cases.
    EXPECT_EQ(with("/method", "second-order"),
              "/study/method: must be \"linear\" or \"sobol\": second-order studies are no longer "
              "supported");
    EXPECT_EQ(with("/method", "latin-hypercube"),
              "/study/method: must be \"sobol\" or \"monte-carlo\": Latin hypercubes are no longer "
              "supported");
    EXPECT_EQ(with("/seed", -1).substr(0, 11), "/study/seed");
    EXPECT_EQ(with("/vary/~1a/plus_minus", -1),
              "/study/vary/~1a/plus_minus: must be greater than 0, got -1");
    EXPECT_EQ(with("/vary/~1a/normal_sd", 1).substr(0, 20), "/study/vary/~1a: mus");
    EXPECT_EQ(with("/vary/~1a", {{"values", {1, 2}}}).substr(0, 20), "/study/vary/~1b~1c: ");
    EXPECT_EQ(with("/vary/a", {{"normal_sd", 1}}).substr(0, 13), "/study/vary/a");
    EXPECT_EQ(with("/vary", Json::object()).substr(0, 12), "/study/vary:");
    EXPECT_EQ(with("/watch/~1y/min", 4), "/study/watch/~1y/max: must be at least 4, got 3");
    EXPECT_EQ(with("/watch/~1a_deg", {{"min", 355}, {"max", 3}}),
              "/study/watch/~1a_deg/max: must be at least 355; across 0° add the period of the "
              "angle, got 3");
    EXPECT_EQ(with("/watch/~1a_deg", {{"min", 355}, {"max", 363}}), "no error");
    EXPECT_EQ(with("/vary/~1e", {{"from", -1.7e308}, {"to", 1.7e308}}).substr(0, 22),
              "/study/vary/~1e/to: mu");
    EXPECT_EQ(with("/methd", "sobol").substr(0, 12), "/study/methd");
    EXPECT_EQ(with("/method", "grid").substr(0, 14), "/study/method:");
}

TEST(Study, FindsKnownMomentsForTwentySeeds) {
    // A sum of squares (chi-squared), an amplitude (Rayleigh); each normal (0, 1). By their
    // kurtosis 7 and 3.245 the standard error of a deviation σ is σ √((κ − 1) / 4n).
    constexpr double n = 3000.0;
    for (const char* method : sampled_words) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Json study = normal_study(3, method, 3000, seed);
            study["watch"]["/amplitude"] = Json::object();
            const Part part = whole(problem(study, {0, 0, 0}, [](auto x, auto y) {
                y[0] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
                y[1] = std::hypot(x[0], x[1]);
                return true;
            }));
            const Statistics squares = statistics(part);
            EXPECT_NEAR(squares.mean, 3.0, 3.0 * std::sqrt(6.0 / n)) << method << seed;
            EXPECT_NEAR(squares.deviation, std::sqrt(6.0), 4.0 * std::sqrt(6.0 * 6.0 / 4.0 / n));
            const Statistics amplitude = statistics(part, 1);
            const double variance = 2.0 - pi / 2.0;
            EXPECT_NEAR(amplitude.mean, std::sqrt(pi / 2.0), 3.0 * std::sqrt(variance / n));
            EXPECT_NEAR(amplitude.deviation, std::sqrt(variance),
                        4.0 * std::sqrt(variance * 2.245 / 4.0 / n));
        }
    }
}

TEST(Study, TakesAnglesOnTheCircle) {
    // The best α of the RMS lies opposite the first order a cos φ + b sin φ. With a and b normal
    // about 0 and 3, of mean direction 0 and length √(πκ/8) e^(−κ/4) (I₀ + I₁)(κ/4), κ = 9.
    const double z = 9.0 / 4.0;
    const double length = std::sqrt(pi * 9.0 / 8.0) * std::exp(-z) *
                          (std::cyl_bessel_i(0.0, z) + std::cyl_bessel_i(1.0, z));
    const double known = std::sqrt(-2.0 * std::log(length)) / degree;
    for (const char* method : sampled_words) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Part part =
                whole(problem(normal_study(2, method, 2000, seed), {0, 3}, always([](auto x) {
                                  const double angle = std::atan2(x[0], x[1]) / degree;
                                  return angle < 0.0 ? angle + 360.0 : angle;
                              }),
                              360.0));
            const Statistics found = statistics(part);
            EXPECT_LT(std::abs(std::remainder(found.mean, 360.0)), 3.0 * known / std::sqrt(2000.0));
            EXPECT_NEAR(found.deviation, known, 4.0 * known / std::sqrt(2000.0)) << method << seed;
            EXPECT_LT(found.max - found.min, 360.0);
        }
    }
}

// A maximum that jumps between two peaks less than a turn apart: in a cycle of two turns they do
// not lie across 0°, though no sample says that the cycle has two.
TEST(Study, AverageAnglesOverTheirOwnPeriod) {
    const auto jumps = always([](auto x) { return x[0] < 0.25 ? 33.0 : 243.0; });
    Json study = normal_study(1, "sobol", 1024, 1);
    study["vary"]["/x0"] = {{"from", 0}, {"to", 1}};
    for (const double period : {360.0, 720.0}) {
        const double turns = two_pi / period;
        const double known =
            std::atan2(0.25 * std::sin(33.0 * turns) + 0.75 * std::sin(243.0 * turns),
                       0.25 * std::cos(33.0 * turns) + 0.75 * std::cos(243.0 * turns)) /
            turns;
        const double mean = statistics(whole(problem(study, {0.5}, jumps, period))).mean;
        EXPECT_NEAR(std::remainder(mean - known, period), 0.0, 0.5) << period;
    }
}

TEST(Study, PercentilesKeepToTheContract) {
    // Of an exponential law, whose quantiles are known, against the samples themselves.
    Json study = normal_study(1, "monte-carlo", 20'000, 3);
    study["vary"]["/x0"] = {{"from", 0}, {"to", 1}};
    study["watch"]["/y"] = {{"min", 0.5}, {"max", 1.5}};
    const auto law = always([](auto x) { return -std::log1p(-x[0]); });
    const Part part = whole(problem(study, {0.5}, law));
    std::vector<double> values(20'000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double u = random_uniform(3, i, 0, 0);
        law(std::span(&u, 1), std::span(&values[i], 1));
    }
    std::sort(values.begin(), values.end());
    const Statistics found = statistics(part);
    std::array<double, percent_points.size()> exact{};
    for (std::size_t k = 0; k < exact.size(); ++k) {
        const double place = 19'999.0 * percent_points[k] / 100.0;
        const auto i = static_cast<std::size_t>(place);
        exact[k] = std::lerp(values[i], values[i + 1], place - static_cast<double>(i));
    }
    for (std::size_t k = 0; k < exact.size(); ++k) {
        EXPECT_NEAR(found.percentiles[k], exact[k], 1e-4 * (exact.back() - exact.front()));
    }
    EXPECT_EQ(found.min, values.front());
    EXPECT_EQ(found.max, values.back());
    const double share = std::exp(-0.5) - std::exp(-1.5);
    EXPECT_LT(found.share_low, share);
    EXPECT_GT(found.share_high, share);
    EXPECT_NEAR(found.share_high - found.share_low,
                2.0 * 1.96 * std::sqrt(share * (1.0 - share) / 20'000.0), 1e-4);
}

/// A value of inputs that scatter alike, with its sensitivity indices.
struct Known {
    const char* name;
    Json law;
    std::vector<double> first_order;
    std::vector<double> total;
    Function value;
};

/// Functions whose indices are known in closed form.
std::vector<Known> known_functions() {
    const auto linear = [](std::vector<double> shares) {
        return [shares](auto x, auto y) {
            y[0] = 3.0;
            for (std::size_t j = 0; j < shares.size(); ++j) {
                y[0] += std::sqrt(shares[j]) * x[j];
            }
            return true;
        };
    };
    const std::vector<double> shares{0.00908, 0.01675, 0.0014, 0.97277};
    std::vector<Known> all{{"linear", {{"plus_minus", 1}}, shares, shares, linear(shares)},
                           {"linear, normal", {{"normal_sd", 1}}, shares, shares, linear(shares)},
                           {"Ishigami", {{"plus_minus", pi}}, {}, {}, always([](auto x) {
                                return std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2) +
                                       0.1 * std::pow(x[2], 4) * std::sin(x[0]);
                            })},
                           {"product with corners", {{"plus_minus", 2}}, {}, {}, always([](auto x) {
                                return (std::abs(x[0]) + 0.0) * (std::abs(x[1]) + 1.0) *
                                       (std::abs(x[2]) + 4.5);
                            })},
                           {"product, normal", {{"normal_sd", 1}}, {}, {}, always([](auto x) {
                                return std::exp(0.3 * x[0] + 0.5 * x[1] + 0.6 * x[2]);
                            })}};
    const double mixed = 8.0 * std::pow(pi, 8) / 22'500.0;
    const double one = 0.5 * std::pow(1.0 + std::pow(pi, 4) / 50.0, 2);
    const double two = 49.0 / 8.0;
    const double ishigami = one + two + mixed;
    all[2].first_order = {one / ishigami, two / ishigami, 0.0};
    all[2].total = {(one + mixed) / ishigami, two / ishigami, mixed / ishigami};
    // Of a product the relative variances of the factors, v: V = Π (1 + v) − 1.
    const auto product = [](const std::vector<double>& v, Known& of) {
        double whole = 1.0;
        for (const double each : v) {
            whole *= 1.0 + each;
        }
        for (const double each : v) {
            of.first_order.push_back(each / (whole - 1.0));
            of.total.push_back(each / (1.0 + each) * whole / (whole - 1.0));
        }
    };
    product({1.0 / 3.0, 1.0 / 12.0, 1.0 / 3.0 / 5.5 / 5.5}, all[3]);
    product({std::expm1(0.09), std::expm1(0.25), std::expm1(0.36)}, all[4]);
    return all;
}

TEST(Study, SensitivitiesAreWithinTheirErrorsAtTheRateTheyClaim) {
    constexpr std::uint64_t seeds = 24;
    for (const char* method : sampled_words) {
        for (const std::uint64_t samples : {1000U, 8000U}) {
            double within_one = 0.0;
            double within_two = 0.0;
            double all = 0.0;
            for (const Known& known : known_functions()) {
                const std::size_t inputs = known.total.size();
                std::vector<std::array<double, 2>> within(inputs);
                for (std::uint64_t seed = 0; seed < seeds; ++seed) {
                    Json study = normal_study(static_cast<int>(inputs), method, samples, seed);
                    for (auto& law : study["vary"]) {
                        law = known.law;
                    }
                    const Statistics found =
                        statistics(whole(problem(study, std::vector<double>(inputs), known.value)));
                    for (std::size_t j = 0; j < inputs; ++j) {
                        const auto count = [&](const std::optional<Estimate>& estimate,
                                               double exact, double& of_these) {
                            const double off = std::abs(estimate.value().value - exact);
                            within_one += off <= estimate->error ? 1.0 : 0.0;
                            within_two += off <= 2.0 * estimate->error ? 1.0 : 0.0;
                            of_these += off <= 2.0 * estimate->error ? 1.0 : 0.0;
                            all += 1.0;
                        };
                        count(found.first_order[j], known.first_order[j], within[j][0]);
                        count(found.total[j], known.total[j], within[j][1]);
                    }
                }
                for (std::size_t j = 0; j < inputs; ++j) {  // 22.4 of 24, some less by chance
                    EXPECT_GE(within[j][0], 18.0) << known.name << method << samples << j;
                    EXPECT_GE(within[j][1], 18.0) << known.name << method << samples << j;
                }
            }
            EXPECT_GE(within_one / all, 0.66) << method << samples;
            EXPECT_LE(within_one / all, 0.85) << method << samples;
            EXPECT_GE(within_two / all, 0.93) << method << samples;
        }
    }
}

TEST(Study, SensitivitiesOfAnAngleDoNotSeeItsZero) {
    const Json study = normal_study(2, "sobol", 20'000, 1);
    const auto shares = [&](double zero) {
        const auto angle = always([zero](auto x) {
            const double sum = std::fmod(zero + 20.0 * x[0] + 10.0 * x[1], 360.0);
            return sum < 0.0 ? sum + 360.0 : sum;
        });
        return statistics(whole(problem(study, {0, 0}, angle, 360.0)));
    };
    for (const double zero : {0.0, 7.0, 180.0}) {
        const Statistics found = shares(zero);
        EXPECT_NEAR(found.first_order[0].value().value, 0.8, 0.01) << zero;
        EXPECT_NEAR(found.total[0].value().value, 0.8, 0.03) << zero;
        EXPECT_NEAR(found.total[1].value().value, 0.2, 0.03) << zero;
    }
}

// Each input has its own pairs of samples that are both feasible.
TEST(Study, SensitivitiesAreThoseOfTheFeasibleSamples) {
    Json study = normal_study(2, "sobol", 40'000, 1);
    const Statistics found = statistics(whole(problem(study, {0, 0}, [](auto x, auto y) {
        y[0] = x[0] + x[1];
        return std::abs(x[1]) < 1.0;
    })));
    const double within = 1.0 - std::sqrt(2.0 / pi) * std::exp(-0.5) / std::erf(std::sqrt(0.5));
    EXPECT_NEAR(found.total[0].value().value, 1.0 / (1.0 + within), 0.02);
    EXPECT_NEAR(found.total[1].value().value, within / (1.0 + within), 0.02);
}

TEST(Study, CountsRejectionsByTheirReasons) {
    const Part part =
        whole(problem(normal_study(1, "monte-carlo", 1000, 5), {0.0}, [](auto x, auto y) {
            y[0] = x[0];
            return x[0] < 1.0;
        }));
    ASSERT_EQ(part.tally.rejections().size(), 1U);
    EXPECT_EQ(part.tally.rejections().begin()->first, "/x: must be less than #");
    EXPECT_EQ(part.tally.solved() + count_of(part.tally.rejections()), 1000U);
    EXPECT_NEAR(static_cast<double>(count_of(part.tally.rejections())), 158.7, 3.0 * 11.6);
    EXPECT_LT(statistics(part).max, 1.0);
}

TEST(Study, SaysWhereTheLinearAnswerFails) {
    const auto note = [](const char* method, const Function& function, double nominal = 0.0) {
        return notes_text(whole(problem(normal_study(1, method, 4096, 1), {nominal}, function)));
    };
    const auto line = always([](auto x) { return 5.0 - 2.0 * x[0] + 1e-3 * x[0] * x[0]; });
    const auto jump = always([](auto x) { return x[0] + (x[0] > 0.7 ? 4.0 : 0.0); });
    const auto corner = always([](auto x) { return std::max(x[0], -0.375); });
    const auto curve = always([](auto x) { return std::exp(x[0]); });
    for (const char* method : {"linear", "monte-carlo", "sobol"}) {
        EXPECT_EQ(note(method, line), "") << method;
        for (const Function& function : {jump, corner, curve}) {
            EXPECT_EQ(note(method, function).substr(0, 31), "The linear answer fails for /y:")
                << method;
        }
    }
    const std::string rejected = note("linear", [](auto x, auto y) {
        y[0] = x[0];
        return x[0] > -1.5;
    });
    EXPECT_NE(rejected.find(" of 64 trial samples cannot be solved"), std::string::npos)
        << rejected;
    const std::string isolated = note("linear", [](auto x, auto y) {
        y[0] = x[0];
        return x[0] == 0.0;
    });
    EXPECT_NE(isolated.find("/y has no linear answer: a derivative does not exist"),
              std::string::npos);
}

TEST(Study, AToleranceBelowTheRoundingHasNoDerivative) {
    for (const double size : {1e-15, 1e-13}) {
        Json study = normal_study(2, "linear", 1, 1);
        study["vary"]["/x0"] = {{"plus_minus", size}};
        const Part part =
            whole(problem(study, {46.0, 3.0}, always([](auto x) { return 2.0 * x[0] + x[1]; })));
        const Json linear = write_results(part).at("watched").at("/y").at("linear");
        EXPECT_TRUE(linear.at("derivatives").at("/x0").is_null());
        EXPECT_NEAR(linear.at("derivatives").at("/x1").at("value").get<double>(), 1.0, 1e-9);
        EXPECT_NEAR(linear.at("standard_deviation").get<double>(), 1.0, 1e-9);
        EXPECT_EQ(linear.at("contributions").at("/x0"), 0.0);
        EXPECT_EQ(notes_text(part),
                  "/x0 does not scatter and has no derivative: its tolerance is below the rounding "
                  "of its value.\n");
    }
}

TEST(Study, SaysHowFarItIs) {
    const Problem slow = problem(normal_study(2, "sobol", 256, 1), {0.0, 0.0}, [](auto x, auto y) {
        std::this_thread::sleep_for(std::chrono::microseconds(1500));
        y[0] = x[0] + x[1];
        return true;
    });
    double last = 0.0;
    int reported = 0;
    const auto keep_going = [&](double done) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1.0);
        last = done;
        ++reported;
        return true;
    };
    // One thread, which sleeps longer than it may be silent, whatever the machine does beside it.
    const auto part = run_study(slow, 1, 1, 1, keep_going);
    EXPECT_GE(reported, 4);
    EXPECT_GT(last, 0.7);
    ASSERT_TRUE(part);
    EXPECT_EQ(write_results(*part), write_results(whole(slow, 2)));
    for (const double far_enough : {0.0, 0.6}) {  // among the first samples, or behind them
        EXPECT_FALSE(run_study(slow, 1, 1, 2, [&](double done) { return done < far_enough; }));
    }
}

TEST(Study, FewSamplesAreCalledFew) {
    const auto function = always([](auto x) { return x[0] + 0.3 * x[1] + x[0] * x[1]; });
    const Part one = whole(problem(normal_study(2, "sobol", 1, 1), {0, 0}, function));
    EXPECT_TRUE(write_results(one).at("watched").at("/y").at("standard_deviation").is_null());
    EXPECT_EQ(notes_text(one), "A standard deviation needs two solved samples.\n");
    const Json total = write_results(one).at("watched").at("/y").at("total");
    for (const auto& [key, index] : total.items()) {
        EXPECT_TRUE(index.is_null()) << key;
    }
    const Part few = whole(problem(normal_study(2, "sobol", 320, 1), {0, 0}, function));
    EXPECT_NE(notes_text(few).find("too few for the sensitivities of /y: standard errors up to"),
              std::string::npos);
    EXPECT_EQ(notes_text(whole(problem(normal_study(2, "sobol", 20'000, 1), {0, 0}, function)))
                  .find("too few"),
              std::string::npos);
}

TEST(Study, ShardsPrintWhatTheWholePrints) {
    const auto function = [](auto x, auto y) {
        y[0] = std::exp(x[0]) * (1.0 + x[1]);
        y[1] = std::fmod(360.0 + 20.0 * x[1], 360.0);
        return x[0] < 1.5;
    };
    for (const char* method : {"monte-carlo", "sobol", "linear", "grid"}) {
        Json study = normal_study(2, method, 5'000, 11);
        study["watch"]["/angle_deg"] = {{"max", 10}};
        if (std::string(method) == "grid") {
            study["vary"] = {{"/x0", {{"from", 0}, {"to", 2}, {"steps", 21}}},
                             {"/x1", {{"values", {0, 1, 3}}}}};
        }
        Problem all = problem(study, {0, 0}, function, 360.0);
        all.file_notes = {"a file has changed"};
        const Json results = write_results(whole(all, 2));
        EXPECT_EQ(results.at("notes").at(0), "a file has changed");
        const std::string expected = results.dump();
        EXPECT_EQ(write_results(whole(all, 1)).dump(), expected) << method;
        for (const std::uint64_t shards : {1U, 3U, 64U}) {
            std::vector<std::string> names;
            for (std::uint64_t k = shards; k >= 1; --k) {
                names.push_back(std::to_string(k));
            }
            const Part merged = merge_parts(names, [&](const std::string& name) {
                const Part part = *run_study(all, std::stoull(name), shards, 1);
                return read_part(Json::parse(write_part(part).dump()));
            });
            EXPECT_EQ(write_results(merged).dump(), expected) << method << shards;
        }
    }
}

/// Of a study by a method.
Json written_part(const char* method) {
    Json study = normal_study(2, method, 60, 3);
    if (std::string(method) == "grid") {
        study["vary"] = {{"/x0", {{"from", 0}, {"to", 3}, {"steps", 9}}},
                         {"/x1", {{"values", {0, 1, 3}}}}};
    }
    study["watch"]["/y"]["max"] = 1.0;
    const Problem all = problem(study, {0.0, 0.0}, [](auto x, auto y) {
        y[0] = x[0] + x[1] * x[1];
        return x[0] < 2.0;
    });
    return write_part(*run_study(all, 2, 3, 1));
}

// With a sum to fit, fuzz/part reads them.
TEST(Study, AChangedPartIsRejected) {
    for (const char* method : {"sobol", "monte-carlo", "grid", "linear"}) {
        const Json written = written_part(method);
        EXPECT_EQ(write_part(read_part(written)), written);
        const Json flat = written.flatten();
        std::vector<std::string> places;
        for (const auto& item : flat.items()) {
            places.push_back(item.key());
        }
        for (std::uint64_t i = 0; i < 400; ++i) {
            Json changed = written;
            const std::string& pointer = places[random_bits(1, i, 0, 0) % places.size()];
            Json& value = changed[Json::json_pointer(pointer)];
            value = value.is_string()         ? Json(value.get<std::string>() + "1")
                    : value.is_number_float() ? Json(std::nextafter(value.get<double>(), 1e300))
                    : value.is_number()       ? Json(value.get<std::int64_t>() + 1)
                    : value.is_boolean()      ? Json(!value.get<bool>())
                                              : Json(1);
            EXPECT_NE(error_of([&] { read_part(changed); }), "no error") << pointer;
        }
    }
}

TEST(Study, RejectionsOfOneKindReadTheSameWithoutNumbers) {
    const Message rule(Text{"must be at most %1"}, 2.5);
    EXPECT_EQ(without_numbers({Text{"%1: %2 of %3"}, "rod_2", rule, 7}),
              "rod_2: must be at most # of #");
}

TEST(Study, APartNeedsItsChecksum) {
    EXPECT_EQ(error_of([&] {
                  read_part({{"format", "ravnoves-study-part"}, {"version", 4}});
              }),
              "/sha256: is required and missing");
}

TEST(Study, PartsThatDoNotFitAreNamed) {
    const auto made = [](std::uint64_t shard, std::uint64_t shards, std::uint64_t seed) {
        const Problem all =
            problem(normal_study(1, "sobol", 600, seed), {0}, always([](auto x) { return x[0]; }));
        return *run_study(all, shard, shards, 1);
    };
    const std::map<std::string, Part> parts{{"two", made(2, 4, 1)},
                                            {"again", made(2, 4, 1)},
                                            {"other", made(3, 4, 9)},
                                            {"third", made(1, 3, 1)},
                                            {"four", made(4, 4, 1)}};
    const auto merging = [&](const std::vector<std::string>& names) {
        return error_of(
            [&] { merge_parts(names, [&](const std::string& name) { return parts.at(name); }); });
    };
    EXPECT_EQ(merging({"two", "again"}), "again: is the same part as two: 2/4");
    EXPECT_EQ(merging({"two", "other"}), "other: is a part of another case than two");
    EXPECT_EQ(merging({"two", "third"}), "third: is one of 3 parts, but two is one of 4");
    EXPECT_EQ(merging({"two", "four"}),
              "2 of 4 parts are missing; run them again: --shard 1/4, 3/4");
}

}  // namespace
}  // namespace ravnoves::studies
