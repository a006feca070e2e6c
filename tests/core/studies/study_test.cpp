// What studies find, on functions whose moments and sensitivities are known.

#include "studies/study.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "case-file/input_error.h"
#include "numerics/constants.h"
#include "studies/sampler.h"
#include "support.h"

namespace ravnoves::studies {
namespace {

constexpr std::array sampled_words{"monte-carlo", "latin-hypercube", "sobol"};

std::string refusal(const Json& study) {
    try {
        read_study(study);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Study, ReadsWhatItWritesAndRefusesTheRest) {
    const Json study = {{"vary",
                         {{"/a", {{"plus_minus", 0.02}}},
                          {"/b/c", {{"normal_sd", 2}}},
                          {"/d", {{"plus_minus_percent", 0.1}}},
                          {"/e", {{"from", -1}, {"to", 2}}}}},
                        {"watch", {{"/y", {{"max", 3}}}, {"/z", Json::object()}}},
                        {"method", "latin-hypercube"},
                        {"samples", 1'000'000'000'000},
                        {"seed", 9'223'372'036'854'775'807}};
    EXPECT_EQ(refusal(study), "");
    EXPECT_EQ(write_study(read_study(study)).flatten().size(), study.flatten().size());
    EXPECT_EQ(read_study(write_study(read_study(study))), read_study(study));
    const auto with = [&](const char* pointer, const Json& value) {
        Json changed = study;
        changed[Json::json_pointer(pointer)] = value;
        return refusal(changed);
    };
    EXPECT_EQ(with("/samples", 0),
              "/study/samples: must be a whole number from 1 to 1000000000000, got 0");
    EXPECT_EQ(with("/samples", 1e6), "");
    EXPECT_EQ(with("/seed", -1).substr(0, 11), "/study/seed");
    EXPECT_EQ(with("/vary/~1a/plus_minus", -1),
              "/study/vary/~1a/plus_minus: must be greater than 0, got -1");
    EXPECT_EQ(with("/vary/~1a/normal_sd", 1).substr(0, 20), "/study/vary/~1a: mus");
    EXPECT_EQ(with("/vary/~1a", {{"values", {1, 2}}}).substr(0, 20), "/study/vary/~1b~1c: ");
    EXPECT_EQ(with("/vary/a", {{"normal_sd", 1}}).substr(0, 13), "/study/vary/a");
    EXPECT_EQ(with("/vary", Json::object()).substr(0, 12), "/study/vary:");
    EXPECT_EQ(with("/watch/~1y/min", 4), "/study/watch/~1y/max: must be at least 4, got 3");
    EXPECT_EQ(with("/watch/~1a_deg", {{"min", 355}, {"max", 3}}),
              "/study/watch/~1a_deg/max: must be at least 355; across 0° write 363, got 3");
    EXPECT_EQ(with("/watch/~1a_deg", {{"min", 355}, {"max", 363}}), "");
    EXPECT_EQ(with("/vary/~1e", {{"from", -1.7e308}, {"to", 1.7e308}}).substr(0, 22),
              "/study/vary/~1e/to: mu");
    EXPECT_EQ(with("/methd", "sobol").substr(0, 12), "/study/methd");
    EXPECT_EQ(with("/method", "grid").substr(0, 14), "/study/method:");
}

TEST(Study, FindsKnownMomentsForTwentySeeds) {
    // A sum of squares (chi-squared), an amplitude (Rayleigh); each normal (0, 1).
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
            const Statistics squares = part.tally.statistics(0);
            EXPECT_NEAR(squares.mean, 3.0, 3.0 * std::sqrt(6.0 / n)) << method << seed;
            EXPECT_NEAR(squares.deviation, std::sqrt(6.0), 3.0 * squares.deviation_error);
            const Statistics amplitude = part.tally.statistics(1);
            const double variance = 2.0 - pi / 2.0;
            EXPECT_NEAR(amplitude.mean, std::sqrt(pi / 2.0), 3.0 * std::sqrt(variance / n));
            EXPECT_NEAR(amplitude.deviation, std::sqrt(variance), 3.0 * amplitude.deviation_error);
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
            const Part part = whole(problem(
                normal_study(2, method, 2000, seed, "/angle_deg"), {0, 3}, [](auto x, auto y) {
                    const double angle = std::atan2(x[0], x[1]) / degree;
                    y[0] = angle < 0.0 ? angle + 360.0 : angle;
                    return true;
                }));
            const Statistics found = part.tally.statistics(0);
            EXPECT_LT(std::abs(std::remainder(found.mean, 360.0)), 3.0 * known / std::sqrt(2000.0));
            EXPECT_NEAR(found.deviation, known, 3.0 * found.deviation_error) << method << seed;
            EXPECT_LT(found.max - found.min, 360.0);
        }
    }
}

TEST(Study, ErrorsFallAtTheirRates) {
    const auto error = [](const char* method, std::uint64_t samples) {
        double squares = 0.0;
        constexpr int seeds = 16;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Part part = whole(
                problem(normal_study(3, method, samples, seed), {0, 0, 0}, [](auto x, auto y) {
                    y[0] = std::exp(0.3 * (x[0] + x[1] - x[2]));
                    return true;
                }));
            squares += std::pow(part.tally.statistics(0).mean - std::exp(0.135), 2);
        }
        return std::sqrt(squares / seeds);
    };
    const auto rate = [&](const char* method) {
        return std::log2(error(method, 4096) / error(method, 64)) / 6.0;
    };
    EXPECT_NEAR(rate("monte-carlo"), -0.5, 0.12);
    EXPECT_LT(rate("sobol"), -0.9);
    EXPECT_LT(error("latin-hypercube", 1024), 0.5 * error("monte-carlo", 1024));
}

TEST(Study, PercentilesKeepToTheContract) {
    // Of an exponential law, whose quantiles are known, against the samples themselves.
    Json study = normal_study(1, "monte-carlo", 20'000, 3);
    study["vary"]["/x0"] = {{"from", 0}, {"to", 1}};
    study["watch"]["/y"] = {{"min", 0.5}, {"max", 1.5}};
    const auto law = [](auto x, auto y) {
        y[0] = -std::log1p(-x[0]);
        return true;
    };
    const Part part = whole(problem(study, {0.5}, law));
    std::vector<double> values(20'000);
    const CounterRandom random(3);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double u = random.uniform(i, 0, 0);
        law(std::span(&u, 1), std::span(&values[i], 1));
    }
    std::sort(values.begin(), values.end());
    const Statistics found = part.tally.statistics(0);
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

TEST(Study, FindsTheSensitivitiesOfIshigami) {
    Json study = normal_study(3, "sobol", 20'000, 1);
    for (const char* input : {"/x0", "/x1", "/x2"}) {
        study["vary"][input] = {{"plus_minus", pi}};
    }
    const Part part = whole(problem(study, {0, 0, 0}, [](auto x, auto y) {
        y[0] = std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2) +
               0.1 * std::pow(x[2], 4) * std::sin(x[0]);
        return true;
    }));
    const Statistics found = part.tally.statistics(0);
    EXPECT_NEAR(found.first_order[0], 0.3139, 0.01);
    EXPECT_NEAR(found.first_order[1], 0.4424, 0.01);
    EXPECT_NEAR(found.first_order[2], 0.0, 0.01);
    EXPECT_NEAR(found.total[0], 0.5576, 0.03);
    EXPECT_NEAR(found.total[1], 0.4424, 0.03);
    EXPECT_NEAR(found.total[2], 0.2437, 0.03);
    EXPECT_EQ(notes_of(part).size(), 1U);
}

TEST(Study, SecondOrderIsExactForSquares) {
    const auto square = [](auto x, auto y) {
        y[0] = 2.0 + x[0] + 0.5 * x[0] * x[0] + x[0] * x[1];
        return true;
    };
    const Part part = whole(problem(normal_study(2, "second-order", 1, 1), {0, 0}, square));
    const auto found = part.basis.expansions[0].propagated(part.basis.laws, true);
    EXPECT_NEAR(found->mean, 2.5, 1e-9);
    EXPECT_NEAR(found->deviation, std::sqrt(1.0 + 0.5 + 1.0), 1e-9);
    EXPECT_NEAR(found->total[1], 1.0 / 2.5, 1e-9);
    const auto linear = part.basis.expansions[0].propagated(part.basis.laws, false);
    EXPECT_NEAR(linear->deviation, 1.0, 1e-9);
}

TEST(Study, SecondOrderSharesEachProductAmongItsTwo) {
    const auto products = [](auto x, auto y) {
        y[0] = x[0] * x[1] + 2.0 * x[1] * x[2] + 3.0 * x[0] * x[2] + 5.0 * x[1] * x[3];
        return true;
    };
    const Part part = whole(problem(normal_study(4, "second-order", 1, 1), {0, 0, 0, 0}, products));
    const auto found = part.basis.expansions[0].propagated(part.basis.laws, true);
    const double variance = 1.0 + 4.0 + 9.0 + 25.0;
    EXPECT_NEAR(found->deviation, std::sqrt(variance), 1e-9);
    EXPECT_NEAR(found->total[0], (1.0 + 9.0) / variance, 1e-9);
    EXPECT_NEAR(found->total[1], (1.0 + 4.0 + 25.0) / variance, 1e-9);
    EXPECT_NEAR(found->total[2], (4.0 + 9.0) / variance, 1e-9);
    EXPECT_NEAR(found->total[3], 25.0 / variance, 1e-9);
}

TEST(Study, SensitivitiesOfAnAngleDoNotSeeItsZero) {
    Json study = normal_study(2, "sobol", 20'000, 1, "/angle_deg");
    const auto shares = [&](double zero) {
        const Part part = whole(problem(study, {0, 0}, [zero](auto x, auto y) {
            const double angle = std::fmod(zero + 20.0 * x[0] + 10.0 * x[1], 360.0);
            y[0] = angle < 0.0 ? angle + 360.0 : angle;
            return true;
        }));
        return part.tally.statistics(0);
    };
    for (const double zero : {0.0, 7.0, 180.0}) {
        const Statistics found = shares(zero);
        EXPECT_NEAR(found.first_order[0], 0.8, 0.01) << zero;
        EXPECT_NEAR(found.total[0], 0.8, 0.03) << zero;
        EXPECT_NEAR(found.total[1], 0.2, 0.03) << zero;
    }
}

TEST(Study, CountsRefusalsByTheirReasons) {
    const Part part =
        whole(problem(normal_study(1, "monte-carlo", 1000, 5), {0.0}, [](auto x, auto y) {
            y[0] = x[0];
            return x[0] < 1.0;
        }));
    ASSERT_EQ(part.tally.refusals().size(), 1U);
    EXPECT_EQ(part.tally.refusals().begin()->first, "/x: must be less than #");
    EXPECT_EQ(part.tally.solved() + part.tally.refused(), 1000U);
    EXPECT_NEAR(static_cast<double>(part.tally.refused()), 158.7, 3.0 * 11.6);
    EXPECT_LT(part.tally.statistics(0).max, 1.0);
    EXPECT_EQ(part.basis.departures[0].kind, Departure::Kind::refused);
}

TEST(Study, SaysWhereWithTheUnit) {
    const Departure corner{Departure::Kind::corner, 0, 386.22, 1.0, {}};
    EXPECT_EQ(
        departure_text(corner, {.deviation = 0.1}, "/angular_speed_rad_s", units::rad_per_s, 1.0)
            .english(),
        "it has a corner where /angular_speed_rad_s is 386.22 rad/s");
}

TEST(Study, SaysWhyTheLinearAnswerFails) {
    const auto note = [](const Function& function) {
        const Part part = whole(problem(normal_study(1, "sobol", 4096, 1), {0.0}, function));
        const auto notes = notes_of(part);
        return notes.empty() ? "" : notes.front().english();
    };
    EXPECT_EQ(note([](auto x, auto y) {
                  y[0] = 5.0 - 2.0 * x[0];
                  return true;
              }),
              "");
    EXPECT_NE(note([](auto x, auto y) {
                  y[0] = x[0] + (x[0] > 0.7 ? 4.0 : 0.0);
                  return true;
              }).find("it jumps by 4 where /x0 is 0.7."),
              std::string::npos);
    EXPECT_NE(note([](auto x, auto y) {
                  y[0] = std::max(x[0], -0.375);
                  return true;
              }).find("it has a corner where /x0 is -0.375."),
              std::string::npos);
    EXPECT_NE(note([](auto x, auto y) {
                  y[0] = std::exp(x[0]);
                  return true;
              }).find("it is curved along /x0."),
              std::string::npos);
}

TEST(Study, OtherLimitsNeedNoOtherSamples) {
    const auto half = [](const Json& limits) {
        Json study = normal_study(2, "latin-hypercube", 6000, 3);
        study["watch"]["/y"] = limits;
        return problem(study, {0.0, 0.0}, [](auto x, auto y) {
            y[0] = x[0] + 0.3 * x[1] * x[1];
            return x[1] < 2.5;
        });
    };
    const Problem first = half({{"max", 0.5}});
    Part part = begin_part(first, 1, 1, 2);
    keep_values(part, 6000);
    // One change while the samples are solved, one when they are.
    run_part(first, part, 2, [&](const Part&) {
        return change_limits(part, {{.pointer = "/y", .min = 0.1, .max = {}}});
    });
    ASSERT_TRUE(change_limits(part, {{.pointer = "/y", .min = -0.25, .max = 1.5}}));
    const Part wanted = whole(half({{"min", -0.25}, {"max", 1.5}}));
    EXPECT_EQ(write_results(part), write_results(wanted));
    Part without = begin_part(first, 1, 1, 1);
    keep_values(without, 5999);
    EXPECT_FALSE(change_limits(without, first.study.watch));
}

TEST(Study, SaysHowFarItIsByTime) {
    Json two = normal_study(2, "sobol", 256, 1);
    two["watch"]["/z"] = Json::object();
    const Problem slow = problem(two, {0.0, 0.0}, [](auto x, auto y) {
        std::this_thread::sleep_for(std::chrono::microseconds(500));
        y[0] = x[0] + x[1];
        y[1] = 100.0 - y[0];
        return true;
    });
    double last = 0.0;
    int told = 0;
    std::uint64_t shown = 0;
    Part part = begin_part(slow, 1, 1, 2, [&](double done, const auto& so_far) {
        EXPECT_GE(done, last);
        last = done;
        ++told;
        if (so_far) {
            const Part now = so_far();
            EXPECT_GE(now.tally.solved(), shown);
            shown = now.tally.solved();
            const Json watched = write_results(now).at("watched");
            if (shown >= 2) {  // each value is told with its own samples
                EXPECT_NEAR(watched.at("/z").at("mean").get<double>(),
                            100.0 - watched.at("/y").at("mean").get<double>(), 1e-9);
            }
        }
        return true;
    });
    EXPECT_GE(told, 2);
    EXPECT_GT(shown, 0U);
    EXPECT_LT(last, 0.7);
    run_part(slow, part, 2, [&](const Part& now) {
        EXPECT_GE(share_done(now), last);
        last = share_done(now);
        ++told;
        return true;
    });
    EXPECT_GE(told, 4);
    EXPECT_EQ(last, 1.0);
    EXPECT_EQ(write_results(part), write_results(whole(slow)));
    EXPECT_TRUE(
        begin_part(slow, 1, 1, 2, [](double, const auto&) { return false; }).basis.plan.empty());
}

std::string notes_text(const Part& part) {
    std::string text;
    for (const Message& note : notes_of(part)) {
        text += note.english() + '\n';
    }
    return text;
}

TEST(Study, ExpansionsSayWhatTheyDoNotKnow) {
    const auto notes = [](const char* method, const Function& function, double nominal = 0.0) {
        return notes_text(whole(problem(normal_study(1, method, 1, 1), {nominal}, function)));
    };
    for (const char* method : {"linear", "second-order"}) {
        EXPECT_EQ(notes(method,
                        [](auto x, auto y) {
                            y[0] = 5.0 - 2.0 * x[0] + 1e-3 * x[0] * x[0];
                            return true;
                        }),
                  "")
            << method;
        // Never negative, and a slope that knows nothing of it.
        const std::string corner = notes(
            method,
            [](auto x, auto y) {
                y[0] = std::abs(x[0]);
                return true;
            },
            0.5);
        EXPECT_NE(corner.find("it has a corner where /x0 is 0"), std::string::npos) << corner;
        const std::string refused = notes(method, [](auto x, auto y) {
            y[0] = x[0];
            return x[0] > -1.5;
        });
        EXPECT_NE(refused.find("it does not exist where /x0 is -1.5 (/x: must"), std::string::npos)
            << refused;
        EXPECT_NE(refused.find(" of 64 samples that were tried cannot be solved"),
                  std::string::npos)
            << refused;
        EXPECT_NE(notes(method,
                        [](auto x, auto y) {
                            y[0] = x[0] + (x[0] > 1.25 ? 4.0 : 0.0);
                            return true;
                        })
                      .find("it jumps by 4 where /x0 is 1.25."),
                  std::string::npos);
    }
    const auto square = [](auto x, auto y) {
        y[0] = x[0] * x[0];
        return true;
    };
    EXPECT_NE(notes("linear", square).find("it is curved along /x0."), std::string::npos);
    EXPECT_EQ(notes("second-order", square), "");
    // Beyond two standard deviations it is another's business.
    EXPECT_EQ(notes("linear",
                    [](auto x, auto y) {
                        y[0] = x[0];
                        return x[0] > -4.0;
                    }),
              "");
    const Part part = whole(problem(normal_study(1, "linear", 1, 1), {0.0}, [](auto x, auto y) {
        y[0] = x[0];
        return x[0] > -1.5;
    }));
    const Json results = write_results(part);
    EXPECT_GT(results.at("refused")[0].at("count").get<int>(), 0);
    EXPECT_TRUE(write_results(read_part(Json::parse(write_part(part).dump()))) == results);
}

TEST(Study, FewSamplesAreCalledFew) {
    const auto function = [](auto x, auto y) {
        y[0] = x[0] + 0.3 * x[1] + x[0] * x[1];
        return true;
    };
    const Part one = whole(problem(normal_study(2, "sobol", 1, 1), {0, 0}, function));
    EXPECT_TRUE(write_results(one).at("watched").at("/y").at("standard_deviation").is_null());
    EXPECT_EQ(notes_text(one), "A standard deviation takes two samples that can be solved.\n");
    const Part few = whole(problem(normal_study(2, "sobol", 320, 1), {0, 0}, function));
    EXPECT_NE(notes_text(few).find("too few for the sensitivities of /y: standard errors up to"),
              std::string::npos);
    EXPECT_EQ(notes_text(whole(problem(normal_study(2, "sobol", 20'000, 1), {0, 0}, function)))
                  .find("too few"),
              std::string::npos);
    // Their standard errors are what twenty seeds scatter by: V = 2.09, one of it by x0 alone.
    double off_first = 0.0;
    double off_total = 0.0;
    double first_error = 0.0;
    double total_error = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Statistics found =
            whole(problem(normal_study(2, "monte-carlo", 2000, seed), {0, 0}, function))
                .tally.statistics(0);
        off_first += std::pow(found.first_order[0] - 1.0 / 2.09, 2) / 20.0;
        off_total += std::pow(found.total[0] - 2.0 / 2.09, 2) / 20.0;
        first_error += found.first_order_error[0] / 20.0;
        total_error += found.total_error[0] / 20.0;
    }
    EXPECT_NEAR(std::sqrt(off_first) / first_error, 1.0, 0.5);
    EXPECT_NEAR(std::sqrt(off_total) / total_error, 1.0, 0.5);
}

TEST(Study, ShardsPrintWhatTheWholePrints) {
    const auto function = [](auto x, auto y) {
        y[0] = std::exp(x[0]) * (1.0 + x[1]);
        y[1] = std::fmod(360.0 + 20.0 * x[1], 360.0);
        return x[0] < 1.5;
    };
    for (const char* method : {"monte-carlo", "latin-hypercube", "sobol", "linear", "grid"}) {
        Json study = normal_study(2, method, 5000, 11);
        study["watch"]["/angle_deg"] = {{"max", 10}};
        if (std::string(method) == "grid") {
            study["vary"] = {{"/x0", {{"from", 0}, {"to", 2}, {"steps", 21}}},
                             {"/x1", {{"values", {0, 1, 3}}}}};
        }
        Problem all = problem(study, {0, 0}, function);
        all.file_notes = {"a file has changed"};
        const Json results = write_results(whole(all, 2));
        EXPECT_EQ(results.at("notes").at(0), "a file has changed");
        const std::string expected = results.dump();
        for (const std::uint64_t shards : {1U, 3U, 7U}) {
            PartMerger merger;
            for (std::uint64_t k = shards; k >= 1; --k) {
                Part part = begin_part(all, k, shards, 1);
                // Stopped after its first stretch, and taken up by another run.
                run_part(all, part, 1, [](const Part&) { return false; });
                part = read_part(Json::parse(write_part(part).dump()));
                run_part(all, part, 1);
                merger.add(read_part(Json::parse(write_part(part).dump())), std::to_string(k));
            }
            EXPECT_EQ(write_results(merger.finish()).dump(), expected) << method << shards;
        }
    }
}

TEST(Study, PartsThatDoNotFitAreNamed) {
    const auto made = [](std::uint64_t shard, std::uint64_t shards, std::uint64_t seed) {
        const Problem all = problem(normal_study(1, "sobol", 600, seed), {0}, [](auto x, auto y) {
            y[0] = x[0];
            return true;
        });
        Part part = begin_part(all, shard, shards, 1);
        run_part(all, part, 1);
        return part;
    };
    const auto fault = [](const auto& work) -> std::string {
        try {
            work();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    PartMerger merger;
    merger.add(made(2, 4, 1), "two");
    EXPECT_EQ(fault([&] { merger.add(made(2, 4, 1), "again"); }),
              "again: is the same part as two: 2/4");
    EXPECT_EQ(fault([&] { merger.add(made(3, 4, 9), "other"); }),
              "other: is a part of another case than two");
    EXPECT_EQ(fault([&] { merger.add(made(1, 3, 1), "third"); }),
              "third: is one of 3 parts, but two is one of 4");
    Part open = made(3, 4, 1);
    --open.done;
    EXPECT_EQ(fault([&] { merger.add(open, "open"); }),
              "open: is not finished (149 of 150 samples); run it again: --shard 3/4");
    merger.add(made(4, 4, 1), "four");
    EXPECT_EQ(fault([&] { merger.finish(); }),
              "2 of 4 parts are missing; run them again: --shard 1/4, 3/4");
}

}  // namespace
}  // namespace ravnoves::studies
