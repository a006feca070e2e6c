#include "elastic-hinge/model/elastic_hinge_model.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/result_json.h"
#include "elastic-hinge/fields.h"
#include "elastic-hinge/results.h"
#include "model/case_model_json.h"
#include "numerics/vector_state.h"
#include "plot/model/ticks.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/write_file.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Guide;
using elastic_hinge::GuideProposal;
using elastic_hinge::Hinge;
using elastic_hinge::Input;
using elastic_hinge::Motion;
using elastic_hinge::MotionEnd;
using elastic_hinge::Result;
using elastic_hinge::Spring;
namespace field = elastic_hinge::field;

namespace {

QString number(double value, int decimals) {
    return fixedNumber(value, decimals, QLocale());
}

/// So many significant digits; whole numbers of everyday size are written out.
QString significant(double value, int digits = 4) {
    const double size = std::abs(value);
    if (size >= std::pow(10.0, digits) && size < 1e8) {
        return number(value, 0);
    }
    return shownFormNumber(value, QLocale(), digits);
}

/// The same of a quantity, in the unit shown.
QString significant(double si, const Unit& unit, int digits = 4) {
    return significant(shownValue(si, unit), digits);
}
QString withItsUnit(double si, const Unit& unit, int digits = 4) {
    return withUnit(significant(si, unit, digits), shownUnit(unit).name);
}

/// A preload, rounded up so that what is shown suffices.
ResultCell preloadUp(double length) {
    const int decimals = 4 + shownUnit(units::mm).decimals;
    const double parts = std::pow(10.0, decimals);
    const double shown = std::ceil(shownValue(length, units::mm) * parts - 1e-9) / parts;
    return {shown, number(shown, decimals)};
}

}  // namespace

QString ElasticHingeScene::defaultTitle() {
    return messageText(elastic_hinge::presets().front().title);
}

ElasticHingeScene::Solved ElasticHingeScene::solve(Input input) {
    input.guide_search.reset();  // looked for when it is asked for
    return {std::make_shared<const Result>(elastic_hinge::solve(input)), std::nullopt};
}

template class CaseModel<ElasticHingeScene>;

ElasticHingeModel::ElasticHingeModel(QObject* parent, bool runsJobs)
    : CaseModel({}, parent), runsJobs_(runsJobs) {
    constexpr int patienceMs = 150;  // a run older than that makes room for a newer one
    constexpr int restMs = 120;      // the hand rests: a drag's frames have the machine
    runner_.setPatience(patienceMs, restMs, true);
    connect(&runner_, &BackgroundJob::failed, this, [this](const QString& why) {
        auto none = std::make_shared<HingeMotions>();
        none->offSpeed = offSpeed(input());
        none->trouble = why;
        showMotions(none);
    });
    connect(&crank_, &CrankAngle::changed, this, [this] {
        if (!isPlayed_) {
            leaveMotion();
        }
    });
    taken();
}

void ElasticHingeModel::taken() {
    if (runsJobs_) {
        runner_.start([this, input = input(), result = solved().result](const auto& progress) {
            auto motions = computeMotions(input, *result, progress);
            return [this, motions] { showMotions(motions); };
        });
    }
}

void ElasticHingeModel::showMotions(std::shared_ptr<const HingeMotions> motions) {
    motions_ = std::move(motions);
    if (motionAngle_) {  // the crank stays where it was left, in the same turn
        const Motion* motion = animatedMotion();
        motionTime_ = motion != nullptr ? motion->time_at(*motionAngle_) : std::nullopt;
    }
    Q_EMIT shownChanged();
}

Json ElasticHingeModel::resultJson() const {
    return result_json({}, input(), elastic_hinge::solve(input()));
}

bool ElasticHingeModel::setViewOption(const QString& key, const QString& value) {
    if (key == QLatin1String("crank_angle_deg")) {
        crank_.turnTo(readNumber(key, value));
    } else if (key == QLatin1String("exaggeration")) {
        setExaggeration(value == QLatin1String("auto") ? std::nullopt
                                                       : std::optional(readNumber(key, value)));
    } else if (key == QLatin1String("guide_shown")) {
        setShownHinge(static_cast<Hinge>(oneOf(
            key, value,
            {QStringLiteral("crank"), QStringLiteral("crank-with-rod"), QStringLiteral("rod")})));
    } else if (key == QLatin1String("animate")) {
        setAnimated(
            static_cast<Animated>(oneOf(key, value,
                                        {QStringLiteral("none"), QStringLiteral("crank"),
                                         QStringLiteral("both"), QStringLiteral("off-design")})));
    } else {
        return false;
    }
    return true;
}

void ElasticHingeModel::takeView(const SceneModel& other) {
    if (const auto* model = qobject_cast<const ElasticHingeModel*>(&other)) {
        setShownHinge(model->shownHinge());
        // Reliefs are compared at one scale, the chosen one or that of the other's relief.
        if (const double factor = model->exaggeration(); factor != exaggeration_) {
            exaggeration_ = factor;
            Q_EMIT viewChanged();
        }
    }
}

// ------------------------------------------------------------------------------------- pictures

void ElasticHingeModel::setMotionTime(double seconds) {
    leaveMotion();
    motionTime_ = seconds;
    if (const Motion* motion = animatedMotion()) {
        motionAngle_ = motion->angle_at(seconds);
        isPlayed_ = true;
        crank_.turnTo(*motionAngle_ / degree);
        isPlayed_ = false;
    }
}

void ElasticHingeModel::leaveMotion() {
    motionTime_.reset();
    motionAngle_.reset();
}

void ElasticHingeModel::setAnimated(Animated animated) {
    if (animated != animated_) {
        animated_ = animated;
        leaveMotion();
        Q_EMIT viewChanged();
    }
}

const Motion* ElasticHingeModel::animatedMotion() const {
    constexpr std::array all{&HingeMotions::without, &HingeMotions::crank, &HingeMotions::both,
                             &HingeMotions::offDesign};  // in the order of Animated
    if (!motions_) {
        return nullptr;
    }
    const std::optional<Motion>& motion = (*motions_).*all.at(static_cast<std::size_t>(animated_));
    return motion ? &*motion : nullptr;
}

double ElasticHingeModel::shownSpeed() const {
    const Motion* motion = animatedMotion();
    return motionTime_ && motion != nullptr ? motion->speed_at(*motionTime_)
                                            : input().angular_speed;
}

QString ElasticHingeModel::hingeMoment(Hinge hinge) {
    return QStringList{QStringLiteral("M"), QStringLiteral("M₁"), QStringLiteral("M₁₂")}.at(
        static_cast<int>(hinge));
}

QStringList ElasticHingeModel::hingeNames() {
    QStringList names;
    for (const Text& name : elastic_hinge::guide_names) {
        const QString moment = hingeMoment(static_cast<Hinge>(names.size()));
        names << shownText(name) + QStringLiteral(" (%1)").arg(moment);
    }
    return names;
}

void ElasticHingeModel::setShownHinge(Hinge hinge) {
    if (hinge != shownHinge_) {
        shownHinge_ = hinge;
        Q_EMIT viewChanged();
    }
}

const Guide& ElasticHingeModel::guideOf(Hinge hinge) const {
    return hinge == Hinge::crank            ? result().crank_guide
           : hinge == Hinge::crank_with_rod ? result().crank_guide_with_rod
                                            : result().rod_guide;
}

double ElasticHingeModel::exaggeration() const {
    if (exaggeration_) {
        return *exaggeration_;
    }
    const Guide& guide = shownGuide();
    if (!guide.feasible || !(guide.relief > 0.0)) {
        return 1.0;
    }
    // The relief then fills about a fifth of the radius.
    return round_step(std::max(1.0, 0.2 * guide.summary().min_radius / guide.relief));
}

void ElasticHingeModel::setExaggeration(std::optional<double> factor) {
    if (factor) {
        check_range(exaggerationField, *factor, exaggerationField.key);
    }
    if (factor != exaggeration_) {
        exaggeration_ = factor;
        Q_EMIT viewChanged();
    }
}

// --------------------------------------------------------------------------------------- search

void ElasticHingeModel::setGravity(double gravity) {
    edit(fieldName(field::gravity), [&](Input& input) {
        if (input.masses_as_weights) {
            const Field before = field::as_weight({}, input.gravity);
            const Field after = field::as_weight({}, gravity);
            for (double* mass : {&input.crank_mass, &input.rod_mass, &input.slider_mass}) {
                *mass = from_si(before, *mass) * after.unit;
            }
            if (input.rod_counterweight && input.rod_counterweight->mass) {
                double& mass = *input.rod_counterweight->mass;
                mass = from_si(before, mass) * after.unit;
            }
        }
        input.gravity = gravity;
    });
}

const GuideProposal& ElasticHingeModel::proposal() const {
    if (!solved().proposal) {
        clear_vector_state();
        solved().proposal =
            elastic_hinge::search_guide(result().design, input(), result().crank_guide.branch);
    }
    return *solved().proposal;
}

QString ElasticHingeModel::proposalText() const {
    const GuideProposal& found = proposal();
    if (!found.found) {
        return tr("None: %1.").arg(messageText(found.reason));
    }
    const QString text =
        tr("c = %1, ρ₀ = %2: relief %3 within %4. Spring: minimum length %5, maximum force %6, "
           "maximum energy %7 J.")
            .arg(withItsUnit(found.spring.stiffness, units::kN_per_m, 5),
                 shownNumber(found.spring.guide_radius_at_zero, units::mm, 3),
                 shownNumber(found.relief, units::mm, 3),
                 shownNumber(found.outer_diameter, units::mm, 1),
                 shownNumber(found.smallest_spring_length, units::mm, 1),
                 withItsUnit(found.largest_spring_force, units::kN),
                 significant(found.largest_spring_energy));
    const Guide& present = result().crank_guide;
    if (!present.feasible) {
        return text;
    }
    return text + QLatin1Char(' ') +
           (meetsWish() ? tr("The present design meets the requirements: relief %1, maximum force "
                             "%2, moment error %3.")
                        : tr("Present design: relief %1, maximum force %2, moment error %3."))
               .arg(shownNumber(present.relief, units::mm, 3),
                    withItsUnit(present.largest_spring_force, units::kN),
                    percentText(present.error.relative));
}

bool ElasticHingeModel::meetsWish() const {
    return elastic_hinge::meets_wish(result().crank_guide, input());
}

void ElasticHingeModel::takeProposal() {
    if (!proposal().found) {
        return;
    }
    const Spring spring = proposal().spring;
    edit(tr("Use the guide found"), [&](Input& input) { input.spring = spring; });
}

void ElasticHingeModel::takeMinimumPreload() {
    const Guide& guide = result().crank_guide;
    if (!guide.lacks_preload) {
        return;
    }
    const double preload = guide.minimum_preload + std::max(0.01 * guide.minimum_preload,
                                                            elastic_hinge::min_preload_margin);
    const double side = guide.branch == Branch::compressed ? -1.0 : 1.0;
    edit(tr("Minimum preload of the guide"), [&](Input& input) {
        // Rounded away from ℓ₀/2 to what a drawing would say.
        const double radius = 0.5 * input.spring->free_length + side * preload;
        input.spring->guide_radius_at_zero =
            side * std::ceil(side * radius / units::mm * 1e3 - 1e-9) / 1e3 * units::mm;
    });
}

// --------------------------------------------------------------------------------------- answer

Results ElasticHingeModel::quantities() const {
    const ResultCell none(QStringLiteral("–"));
    const Guide& guide = shownGuide();
    const bool there = guide.feasible;
    const auto when = [&](bool shown, const ResultCell& cell) { return shown ? cell : none; };
    const auto row = [&](const QString& name, const ResultCell& cell, const Unit& unit,
                         const QString& tip) {
        return ResultRow({name, cell, shownUnit(unit).name}, tip);
    };
    const auto length = [&](const QString& name, double value, int decimals, const QString& tip) {
        return row(name, when(there, shownCell(value, units::mm, decimals)), units::mm, tip);
    };
    const auto& roller = guide.summary().largest_roller_radius;
    const double with = result().largest_side_force_with;
    const double reduction = result().largest_side_force_without / with;
    ResultCell sideForce = shownCell(with, units::newton, 2);
    if (with > 0.0 && std::isfinite(reduction)) {
        sideForce.text += QStringLiteral(" (÷ ") + number(reduction, 1) + QLatin1Char(')');
    }
    sideForce.isSmallerBetter = true;
    const Unit weight = input().masses_as_weights ? units::newton : units::kg;
    const double counterweight = result().design->mechanism().counterweight_mass *
                                 (input().masses_as_weights ? input().gravity : 1.0);
    const auto ripple = [&](const QString& name, const std::optional<Motion> HingeMotions::*which,
                            const QString& tip) {
        const Motion* motion = motions_ && (*motions_).*which ? &*((*motions_).*which) : nullptr;
        const ResultCell cell =
            motion == nullptr ? none
            : motion->end == MotionEnd::reversed
                ? ResultCell(tr("reverses"))
                : ResultCell(100.0 * motion->ripple,
                             number(100.0 * motion->ripple, motion->ripple < 1e-3 ? 5 : 2));
        return ResultRow({name, cell, QStringLiteral("%")}, tip);
    };
    Results results{{tr("Quantity"), tr("Value"), tr("Unit")}};
    results.rows = {
        length(tr("Relief (%1)").arg(shownHingeName()), guide.relief, 4,
               tr("Maximum minus minimum radius of the guide")),
        row(tr("Preload min / present"),
            when(guide.shape != nullptr,
                 ResultCell::two(QStringLiteral("%1 / %2"), preloadUp(guide.minimum_preload),
                                 shownCell(guide.preload, units::mm, 2))),
            units::mm, tr("|ℓ₀/2 − ρ₀|: minimum to store the energy, and present value")),
        length(tr("Spring travel"), 2.0 * guide.relief, 3,
               tr("Maximum minus minimum length of the spring over a turn")),
        row(tr("Maximum spring force"),
            when(there, {shownValue(guide.largest_spring_force, units::kN),
                         significant(guide.largest_spring_force, units::kN)}),
            units::kN, tr("c |ℓ − ℓ₀|, maximum over a turn")),
        row(tr("Moment error, %1").arg(withItsUnit(input().profile_error, units::micrometre, 3)),
            when(there, ResultCell::two(
                            QStringLiteral("%1 (%2)"), shownCell(guide.error.torque, units::N_m, 2),
                            {100.0 * guide.error.relative, percentText(guide.error.relative),
                             ResultCell::Kind::Percent})),
            units::N_m,
            tr("Maximum error of the hinge's moment at this profile error; in brackets relative to "
               "the maximum moment")),
        length(tr("Min. curvature radius"), guide.summary().smallest_curvature_radius, 2,
               tr("Radius of curvature of the guide; a cutter must be smaller")),
        row(tr("Maximum roller radius"),
            when(there, roller ? shownCell(*roller, units::mm, 2) : ResultCell(tr("any"))),
            units::mm, tr("Maximum radius of a roller that touches the whole guide")),
        {{tr("∮ M₁₂ dφ"),
          {result().design->rod_hinge_integral(), number(result().design->rod_hinge_integral(), 3)},
          tr("J")},
         tr("Work of the rod hinge's moment over a turn; 0 if a spring can supply it")},
        shownRow(tr("Side force, no hinge"), result().largest_side_force_without, units::newton, 1,
                 tr("Maximum force of the slider on its guide")),
        row(tr("Side force, rod hinge"), sideForce, units::newton,
            tr("Maximum force with the rod hinge; in brackets the reduction factor")),
        row(tr("Counterweight P₄"),
            when(result().design->mechanism().has_counterweight(),
                 shownCell(counterweight, weight, input().masses_as_weights ? 3 : 4)),
            weight, tr("Weight on the rod for ∮ M₁₂ dφ = 0, or as entered")),
    };
    if (!runsJobs_) {
        return results;  // it never has a motion
    }
    results.rows += {
        ripple(tr("Ripple without hinge"), &HingeMotions::without,
               tr("(ω_max − ω_min) / mean ω of the free motion, %")),
        ripple(tr("Ripple with hinge"), &HingeMotions::crank,
               tr("(ω_max − ω_min) / mean ω with the crank hinge, %")),
        ripple(tr("Ripple from %1")
                   .arg(withItsUnit(motions_ ? motions_->offSpeed : offSpeed(input()),
                                    units::rad_per_s)),
               &HingeMotions::offDesign,
               tr("(ω_max − ω_min) / mean ω after a start away from the design speed")),
    };
    return results;
}

QString ElasticHingeModel::motionsText() const {
    if (!motions_) {
        return {};
    }
    if (!motions_->trouble.isEmpty()) {
        return motions_->trouble;
    }
    QStringList lines;
    const auto add = [&](const QString& name, const std::optional<Motion>& motion) {
        if (!motion) {
            return;
        }
        if (motion->end == MotionEnd::completed) {
            QString line = tr("%1: %2…%3, drift %4")
                               .arg(name, significant(motion->min_speed, units::rad_per_s, 5),
                                    withItsUnit(motion->max_speed, units::rad_per_s, 5),
                                    powerText(motion->energy_drift, QLocale(), 1));
            // No number stands alone in a line.
            lines << line.replace(line.lastIndexOf(QLatin1Char(' ')), 1, QChar::Nbsp);
        } else if (motion->end != MotionEnd::cancelled) {
            lines << name + QStringLiteral(": ") + messageText(motion->reason);
        }
    };
    add(tr("without hinge"), motions_->without);
    add(tr("crank hinge"), motions_->crank);
    add(tr("both hinges"), motions_->both);
    add(tr("from %1").arg(withItsUnit(motions_->offSpeed, units::rad_per_s)), motions_->offDesign);
    return lines.join(QLatin1Char('\n'));
}

QString ElasticHingeModel::exportGuide(const QString& path) const {
    const Guide& guide = guideOf(guideExport_.hinge);
    elastic_hinge::GuideDrawing drawing = guideExport_.drawing;
    drawing.branch = exportedBranch();
    drawing.roller_radius = input().roller_radius;
    drawing.title = title().toStdString();
    return writeFile(path, [&] {
        const bool table = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
        return table ? elastic_hinge::guide_csv(guide, drawing, guideExport_.stepDeg)
                     : elastic_hinge::guide_dxf(guide, drawing);
    });
}

}  // namespace ravnoves
