#include "elastic-hinge/model/hinge_motions.h"

#include <array>

namespace ravnoves {

using elastic_hinge::HingeSet;
using elastic_hinge::Input;
using elastic_hinge::Motion;
using elastic_hinge::MotionWish;
using elastic_hinge::Result;

namespace {

constexpr double offFactor = 1.2;

}  // namespace

double offSpeed(const Input& input) {
    if (input.motion && input.motion->start_speed) {
        return *input.motion->start_speed;
    }
    return offFactor * input.angular_speed;
}

std::shared_ptr<HingeMotions> computeMotions(const Input& input, const Result& result,
                                             const BackgroundJob::Progress& progress) {
    auto motions = std::make_shared<HingeMotions>();
    motions->offSpeed = offSpeed(input);
    if (!result.design->has_exact_kinematics()) {
        return motions;
    }
    Input atDesign = input;
    atDesign.motion = input.motion.value_or(MotionWish{});
    atDesign.motion->start_speed.reset();
    Input off = atDesign;
    off.motion->start_speed = motions->offSpeed;

    struct Run {
        const Input* input;
        HingeSet hinges;
        std::optional<Motion>* into;
        bool possible;
    };
    const bool crank = result.crank_guide.feasible;
    const bool both = result.crank_guide_with_rod.feasible && result.rod_guide.feasible;
    const std::array<Run, 4> runs{{
        {&atDesign, HingeSet::none, &motions->without, true},
        {&atDesign, HingeSet::crank, &motions->crank, crank},
        {&atDesign, HingeSet::crank_and_rod, &motions->both, both},
        {&off, HingeSet::crank, &motions->offDesign, crank},
    }};
    double before = 0.0;
    for (const Run& run : runs) {
        const auto report = [&](double part) {
            return progress((before + part) / static_cast<double>(runs.size()));
        };
        if (!report(0.0)) {
            break;
        }
        if (run.possible) {
            *run.into = elastic_hinge::simulate(*run.input, result, run.hinges, report);
        }
        before += 1.0;
    }
    return motions;
}

}  // namespace ravnoves
