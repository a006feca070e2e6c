// What the page of the elastic hinges shows.

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "elastic-hinge/model/guide_picture.h"
#include "numerics/constants.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Kinematics;
using elastic_hinge::MechanismCurves;
using elastic_hinge::Motion;
using elastic_hinge::Result;

namespace {

/// The words of the plots.
struct HingePlots {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::HingePlots)
};

constexpr std::array branches{Branch::compressed, Branch::stretched};
constexpr std::array branchRoles{Role::Compressed, Role::Stretched};

QString branchName(Branch branch) {
    return branch == Branch::compressed ? HingePlots::tr("compressed")
                                        : HingePlots::tr("stretched");
}

std::string branchId(Branch branch) {
    return branch == Branch::compressed ? "compressed" : "stretched";
}

plot::Axis turnAxis() {
    return {.title = HingePlots::tr("φ, °"), .min = 0.0, .max = 360.0, .degrees = true};
}

Figure overTurn(const QString& title, const QString& unit) {
    return {.title = title, .x = turnAxis(), .left = {.title = unit}};
}

QString pointText(const ElasticHingeModel& model, Branch branch, std::size_t point) {
    const elastic_hinge::Guide& guide = model.shownGuide();
    const std::vector<double>& radius =
        branch == Branch::compressed ? guide.radius_compressed : guide.radius_stretched;
    return QStringList{branchName(branch),
                       QStringLiteral("φ = %1°").arg(
                           fixedNumber(model.result().crank_angle_deg[point], 1, QLocale())),
                       QStringLiteral("ρ = ") + shownNumber(radius[point], units::mm, 4)}
        .join(QLatin1Char('\n'));
}

Figure guides(const ElasticHingeModel& model) {
    const double factor = model.exaggeration();
    Figure figure;
    figure.title = factor == 1.0
                       ? HingePlots::tr("Guides (%1), to scale").arg(model.shownHingeName())
                       : HingePlots::tr("Guides (%1), relief × %2")
                             .arg(model.shownHingeName(), formNumber(factor, QLocale(), 6));
    figure.left = {.title = HingePlots::tr("y, mm")};
    figure.equalScale = true;
    const GuidePicture drawn(model.shownGuide(), factor);
    const GuidePicture toScale(model.shownGuide(), 1.0);
    double reach = 0.0;
    const auto add = [&](Figure::Curve curve, GuidePicture::Path path, GuidePicture::Path real) {
        reach = std::max(reach, path.reach());
        curve.style.gaps = true;
        curve.x = std::move(path.x);
        curve.y = std::move(path.y);
        curve.trueX = std::move(real.x);
        curve.trueY = std::move(real.y);
        figure.curves.push_back(std::move(curve));
    };
    for (const Branch branch : branches) {
        GuidePicture::Path circle = drawn.circle(branch);
        figure.add("circle-" + branchId(branch),
                   {.name = branch == Branch::compressed ? HingePlots::tr("ρ₀")
                                                         : HingePlots::tr("ℓ₀ − ρ₀"),
                    .role = Role::Limit,
                    .width = 1.0,
                    .inLegend = false},
                   std::move(circle.x), std::move(circle.y));
    }
    const double roller = model.input().roller_radius;
    if (GuidePicture::Path profile = drawn.profile(roller); !profile.x.empty()) {
        add({.id = "profile",
             .style = {.name = HingePlots::tr("profile"),
                       .role = Role::Profile,
                       .width = 1.4,
                       .toolTip = HingePlots::tr(
                           "Profile for the roller: path of its centre, offset by its radius")}},
            std::move(profile), toScale.profile(roller));
    }
    const std::array tips{HingePlots::tr("Guide of the compressed spring, minus in (3)"),
                          HingePlots::tr("Guide of the stretched spring, plus in (3)")};
    for (std::size_t i = 0; i < branches.size(); ++i) {
        add({.id = branchId(branches[i]),
             .style = {.name = branchName(branches[i]),
                       .role = branchRoles[i],
                       .width = 1.8,
                       .toolTip = tips[i]},
             .text = [&model, branch = branches[i]](
                         std::size_t point) { return pointText(model, branch, point); }},
            drawn.path(branches[i]), toScale.path(branches[i]));
    }
    const double maximum = reach > 0.0 ? 1.12 * reach : 130.0;
    figure.x = {.title = HingePlots::tr("x, mm"), .min = -maximum, .max = maximum};
    figure.leftRange = std::pair(-maximum, maximum);
    return figure;
}

Figure relief(const ElasticHingeModel& model) {
    const std::vector<double>& phi = model.result().crank_angle_deg;
    const GuidePicture picture(model.shownGuide(), model.exaggeration());
    const double finest = picture.maxRise();
    constexpr double border = 0.5e-3;  // m
    const bool isNarrow = finest > 0.0 && finest < border;
    Figure figure =
        overTurn(HingePlots::tr("ρ over the turn, from its value at 0°"),
                 isNarrow ? HingePlots::tr("ρ − ρ(0), µm") : HingePlots::tr("ρ − ρ(0), mm"));
    for (std::size_t i = 0; i < branches.size(); ++i) {
        figure.add(branchId(branches[i]),
                   {.name = branchName(branches[i]),
                    .role = branchRoles[i],
                    .width = i == 0 ? 1.8 : 1.4,
                    .gaps = true},
                   phi, picture.rise(branches[i], isNarrow ? units::micrometre : units::mm));
    }
    for (const auto& [from, to] : picture.gaps(phi)) {
        figure.bands.push_back({from, to, Role::Forbidden, 0.12, HingePlots::tr("no guide")});
    }
    return figure;
}

using Values = std::vector<double> MechanismCurves::*;

/// One of a mechanism's curves in the case: broad and beneath, so that it is seen where it is one
/// of a family.
void addCase(Figure& figure, const Result& result, Values values) {
    figure.add("case",
               {.name = HingePlots::tr("this case"),
                .role = Role::Case,
                .width = 3.6,
                .toolTip = HingePlots::tr("At the λ and ω of the case")},
               result.crank_angle_deg, result.curves.*values);
}

/// The same at several ω: the paper's, at its own speed.
void addSpeeds(Figure& figure, const ElasticHingeModel& model, Values values) {
    const Result& result = model.result();
    addCase(figure, result, values);
    int number = 0;
    for (const double factor : {3.0, 5.0}) {
        const double speed = factor * model.input().angular_speed;
        if (speed > 0.0) {
            figure.add("speed-" + std::to_string(number),
                       {.name = shownShort(speed, units::rad_per_s, 5),
                        .role = series(number),
                        .width = 1.4},
                       result.crank_angle_deg,
                       elastic_hinge::curves_at(*result.design, speed).*values);
            ++number;
        }
    }
}

Figure rodMoment(const ElasticHingeModel& model) {
    const Result& result = model.result();
    const std::vector<double>& phi = result.crank_angle_deg;
    Figure figure = overTurn(HingePlots::tr("M₁₂ and its potential part"), HingePlots::tr("N·m"));
    figure.add("moment",
               {.name = HingePlots::tr("moment on rod (M₁₂)"),
                .role = Role::Hinge,
                .width = 2.4,
                .toolTip = HingePlots::tr("Moment on the rod that makes the side force zero, (4), "
                                          "with a counterweight (9)")},
               phi, result.curves.rod_hinge_moment);
    figure.add("potential",
               {.name = HingePlots::tr("potential part"),
                .role = Role::Part,
                .toolTip = HingePlots::tr("M₁₂ minus its mean, (5)")},
               phi, result.curves.rod_hinge_moment_potential);
    figure.add("other",
               {.name = model.input().kinematics == Kinematics::series ? HingePlots::tr("exact")
                                                                       : HingePlots::tr("series"),
                .role = Role::Comparison,
                .width = 1.4,
                .toolTip = HingePlots::tr("M₁₂ by the other kinematics, for comparison")},
               phi, result.other_rod_hinge_moment);
    return figure;
}

Figure rodMomentSpeeds(const ElasticHingeModel& model) {
    Figure figure = overTurn(HingePlots::tr("M₁₂ at several ω"), HingePlots::tr("N·m"));
    addSpeeds(figure, model, &MechanismCurves::rod_hinge_moment);
    return figure;
}

Figure sideForceLambdas(const ElasticHingeModel& model) {
    const Result& result = model.result();
    Figure figure =
        overTurn(HingePlots::tr("Side force with rod hinge, several λ"), HingePlots::tr("N"));
    addCase(figure, result, &MechanismCurves::side_force_with_hinge);
    int number = 0;
    for (const double lambda : {0.3, 0.4, 0.6, 0.8, 1.0}) {
        elastic_hinge::Input other = model.input();
        other.lambda = lambda;
        if (lambda < 1.0 || other.kinematics == Kinematics::series) {  // else it locks
            const elastic_hinge::Design design(other, false);
            figure.add("lambda-" + std::to_string(number),
                       {.name = QStringLiteral("λ = ") + formNumber(lambda, QLocale(), 5),
                        .role = series(number),
                        .width = 1.4},
                       result.crank_angle_deg,
                       elastic_hinge::curves_at(design, other.angular_speed).side_force_with_hinge);
            ++number;
        }
    }
    if (result.largest_side_force_with <= 1e-9 * result.largest_side_force_without) {
        figure.leftRange = std::pair(-1.0, 1.0);  // a flat line at 0, not its rounding enlarged
    }
    return figure;
}

Figure sideForceSpeeds(const ElasticHingeModel& model) {
    const Result& result = model.result();
    Figure figure =
        overTurn(HingePlots::tr("Side force without hinge, several ω"), HingePlots::tr("N"));
    std::vector<double> tenfold = result.curves.side_force_with_hinge;
    for (double& force : tenfold) {
        force *= 10.0;
    }
    figure.add("with-hinge",
               {.name = HingePlots::tr("10 × with hinge"),
                .role = Role::OtherQuantity,
                .width = 2.8,
                .toolTip = HingePlots::tr("Ten times the side force with the rod's hinge: the same "
                                          "at every ω")},
               result.crank_angle_deg, std::move(tenfold));
    addSpeeds(figure, model, &MechanismCurves::side_force_without_hinge);
    return figure;
}

Figure crankMoment(const ElasticHingeModel& model) {
    const Result& result = model.result();
    Figure figure =
        overTurn(HingePlots::tr("Moment that keeps the crank's speed"), HingePlots::tr("N·m"));
    figure.add("without",
               {.name = HingePlots::tr("without hinge (M)"),
                .role = Role::Engine,
                .width = 1.8,
                .toolTip = HingePlots::tr("Without the rod's hinge, d(T + V)/dφ")},
               result.crank_angle_deg, result.curves.crank_moment);
    figure.add(
        "with",
        {.name = result.design->mechanism().has_counterweight() ? HingePlots::tr("with hinge (M₁*)")
                                                                : HingePlots::tr("with hinge (M₁)"),
         .role = Role::Sum,
         .width = 1.8,
         .toolTip = HingePlots::tr("With the rod's hinge, M + M₁₂ (1 + ψ′), (8); with a "
                                   "counterweight M₁*, (11)")},
        result.crank_angle_deg, result.curves.crank_moment_with_rod_hinge);
    return figure;
}

Figure crankMomentSpeeds(const ElasticHingeModel& model) {
    Figure figure = overTurn(model.result().design->mechanism().has_counterweight()
                                 ? HingePlots::tr("M₁* at several ω")
                                 : HingePlots::tr("M₁ at several ω"),
                             HingePlots::tr("N·m"));
    addSpeeds(figure, model, &MechanismCurves::crank_moment_with_rod_hinge);
    return figure;
}

Figure crankSpeed(const ElasticHingeModel& model) {
    Figure figure;
    figure.title = HingePlots::tr("Crank speed");
    figure.x = {.title = HingePlots::tr("turns"),
                .min = 0.0,
                .max = model.input().motion.value_or(elastic_hinge::MotionWish{}).turns};
    figure.left = {.title = HingePlots::tr("rad/s")};
    const HingeMotions* motions = model.motions();
    const auto add = [&](const char* id, const std::optional<Motion> HingeMotions::*which,
                         plot::CurveStyle style) {
        Figure::Curve& curve = figure.add(id, std::move(style), {}, {});
        if (motions == nullptr || !(motions->*which)) {
            return;
        }
        const Motion& motion = *(motions->*which);
        for (const double angle : motion.crank_angle) {
            curve.x.push_back(std::abs(angle - motion.crank_angle.front()) / two_pi);
        }
        curve.y = motion.speed;
    };
    add("without", &HingeMotions::without,
        {.name = HingePlots::tr("without hinge"),
         .width = 1.4,
         .toolTip = HingePlots::tr("The bare mechanism, from the design speed")});
    add("crank", &HingeMotions::crank,
        {.name = HingePlots::tr("crank hinge"),
         .role = Role::Sum,
         .width = 3.0,
         .toolTip = HingePlots::tr("With the crank's hinge, from the design speed")});
    add("both", &HingeMotions::both,
        {.name = HingePlots::tr("both hinges"),
         .role = Role::Comparison,
         .width = 2.0,
         .toolTip = HingePlots::tr("With both hinges, from the design speed")});
    add("off-design", &HingeMotions::offDesign,
        {.name = HingePlots::tr("off design"),
         .role = Role::Part,
         .width = 1.4,
         .toolTip = HingePlots::tr("With the crank's hinge, away from the design speed")});
    return figure;
}

Notes motions(const ElasticHingeModel& model) {
    return Notes::of(Severity::note, model.motionsText());
}

using Maker = PartMaker<ElasticHingeModel>;
constexpr std::array makers{
    Maker{{.id = "quantities", .isAnswer = true}, made<&ElasticHingeModel::quantities>},
    Maker{{.id = "guides", .tab = "guides"}, made<guides>},
    Maker{{.id = "relief", .tab = "guides"}, made<relief>},
    Maker{{.id = "rod-moment", .tab = "rod-hinge"}, made<rodMoment>},
    Maker{{.id = "rod-moment-speeds", .tab = "rod-hinge"}, made<rodMomentSpeeds>},
    Maker{{.id = "side-force-lambdas", .tab = "side-force"}, made<sideForceLambdas>},
    Maker{{.id = "side-force-speeds", .tab = "side-force"}, made<sideForceSpeeds>},
    Maker{{.id = "crank-moment", .tab = "crank-moment"}, made<crankMoment>},
    Maker{{.id = "crank-moment-speeds", .tab = "crank-moment"}, made<crankMomentSpeeds>},
    Maker{{.id = "crank-speed", .tab = "motion", .hasBand = false}, made<crankSpeed>},
    Maker{{.id = "motions", .tab = "motion", .hasBand = false, .isAnswer = true}, made<motions>},
};

}  // namespace

std::span<const PagePart> ElasticHingeModel::parts() const {
    return partsOf(makers);
}

Content ElasticHingeModel::part(std::string_view id) const {
    return makePart(makers, *this, id);
}

}  // namespace ravnoves
