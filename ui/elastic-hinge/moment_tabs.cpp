#include "elastic-hinge/hinge_plots.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using elastic_hinge::FamilyMember;
using elastic_hinge::Kinematics;
using elastic_hinge::MechanismCurves;
using elastic_hinge::Result;

namespace {

/// A plot's family, which of a mechanism's curves it shows, and that of the case itself: broad and
/// beneath, so that it is seen where it is one of the family.
class MechanismFamily {
  public:
    using Values = std::vector<double> MechanismCurves::*;

    MechanismFamily(PlotView* plot, Values values)
        : plot_(plot),
          values_(values),
          own_(plot->addCurve({.name = HingePlots::tr("this case"),
                               .colour = 7,
                               .width = 3.6,
                               .toolTip = HingePlots::tr("At the λ and ω of the case")})),
          family_(plot->addFamily(6, {.name = {}, .colour = 1, .width = 1.4})) {}

    void show(const Result& result, const std::vector<FamilyMember>& members,
              const std::function<QString(double)>& name) const {
        const std::vector<double>& phi = result.crank_angle_deg;
        std::vector<PlotView::Member> shown;
        shown.reserve(members.size());
        for (const FamilyMember& member : members) {
            shown.push_back({name(member.parameter), member.curves.*values_});
        }
        plot_->setCurve(own_, phi, result.curves.*values_);
        plot_->setFamily(family_, phi, shown);
    }
    void showSpeeds(const Result& result) const {
        show(result, result.by_speed,
             [](double speed) { return shownShort(speed, units::rad_per_s, 5); });
    }

  private:
    PlotView* plot_;
    Values values_;
    int own_;
    PlotView::Family family_;
};

}  // namespace

HingePlotTab* makeRodHingeTab(ElasticHingeModel* model, QWidget* parent) {
    auto* tab = new HingePlotTab(model, parent);
    PlotView* moment =
        tab->addAnglePlot(HingePlots::tr("M₁₂ and its potential part"), HingePlots::tr("N·m"));
    moment->addCurve({.name = HingePlots::tr("M₁₂"),
                      .colour = 2,
                      .width = 2.4,
                      .toolTip = HingePlots::tr("Moment on the rod that makes the side force zero, "
                                                "(4), with a counterweight (9)")});
    moment->addCurve({.name = HingePlots::tr("potential part"),
                      .colour = 1,
                      .pen = Qt::DashLine,
                      .toolTip = HingePlots::tr("M₁₂ less its mean, (5)")});
    moment->addCurve({.name = HingePlots::tr("series"),
                      .colour = 7,
                      .width = 1.4,
                      .pen = Qt::DashLine,
                      .toolTip = HingePlots::tr("M₁₂ by the other kinematics, for comparison")});
    const MechanismFamily speeds(
        tab->addAnglePlot(HingePlots::tr("M₁₂ at several ω"), HingePlots::tr("N·m")),
        &MechanismCurves::rod_hinge_moment);
    tab->refresh = [=] {
        const Result& result = model->result();
        const std::vector<double>& phi = result.crank_angle_deg;
        moment->setCurve(0, phi, result.curves.rod_hinge_moment);
        moment->setCurve(1, phi, result.curves.rod_hinge_moment_potential);
        moment->setCurveName(2, model->input().kinematics == Kinematics::series
                                    ? HingePlots::tr("exact")
                                    : HingePlots::tr("series"));
        moment->setCurve(2, phi, result.other_rod_hinge_moment);
        speeds.showSpeeds(result);
    };
    return tab;
}

HingePlotTab* makeSideForceTab(ElasticHingeModel* model, QWidget* parent) {
    auto* tab = new HingePlotTab(model, parent);
    PlotView* with = tab->addAnglePlot(HingePlots::tr("Side force with rod hinge, several λ"),
                                       HingePlots::tr("N"));
    PlotView* without = tab->addAnglePlot(HingePlots::tr("Side force without hinge, several ω"),
                                          HingePlots::tr("N"));
    without->addCurve({.name = HingePlots::tr("10 × with hinge"),
                       .width = 1.8,
                       .toolTip = HingePlots::tr("Ten times the side force with the rod's hinge: "
                                                 "the same at every ω")});
    const MechanismFamily lambdas(with, &MechanismCurves::side_force_with_hinge);
    const MechanismFamily speeds(without, &MechanismCurves::side_force_without_hinge);
    tab->refresh = [=] {
        const Result& result = model->result();
        lambdas.show(result, result.by_lambda, [](double lambda) {
            return QStringLiteral("λ = ") + formNumber(lambda, QLocale(), 5);
        });
        // A flat line at 0, not its rounding enlarged.
        if (model->sideForceVanishes()) {
            with->setYRange(PlotView::Side::Left, -1.0, 1.0);
        } else {
            with->followData(PlotView::Side::Left);
        }
        speeds.showSpeeds(result);
        std::vector<double> tenfold = result.curves.side_force_with_hinge;
        for (double& force : tenfold) {
            force *= 10.0;
        }
        without->setCurve(0, result.crank_angle_deg, std::move(tenfold));
    };
    return tab;
}

HingePlotTab* makeCrankMomentTab(ElasticHingeModel* model, QWidget* parent) {
    auto* tab = new HingePlotTab(model, parent);
    PlotView* moment = tab->addAnglePlot(HingePlots::tr("Moment that keeps the crank's speed"),
                                         HingePlots::tr("N·m"));
    moment->addCurve({.name = HingePlots::tr("M"),
                      .colour = 2,
                      .width = 1.8,
                      .toolTip = HingePlots::tr("Without the rod's hinge, d(T + V)/dφ")});
    moment->addCurve({.name = HingePlots::tr("M₁"),
                      .colour = 1,
                      .width = 1.8,
                      .toolTip = HingePlots::tr("With the rod's hinge, M + M₁₂ (1 + ψ′), (8); "
                                                "with a counterweight M₁*, (11)")});
    PlotView* family = tab->addAnglePlot(HingePlots::tr("M₁ at several ω"), HingePlots::tr("N·m"));
    const MechanismFamily speeds(family, &MechanismCurves::crank_moment_with_rod_hinge);
    tab->refresh = [=] {
        const Result& result = model->result();
        const bool starred = result.has_counterweight;
        moment->setCurve(0, result.crank_angle_deg, result.curves.crank_moment);
        moment->setCurve(1, result.crank_angle_deg, result.curves.crank_moment_with_rod_hinge);
        const QString name = starred ? HingePlots::tr("M₁*") : HingePlots::tr("M₁");
        if (moment->curveName(1) != name) {
            moment->setCurveName(1, name);
            family->setTitle(starred ? HingePlots::tr("M₁* at several ω")
                                     : HingePlots::tr("M₁ at several ω"));
        }
        speeds.showSpeeds(result);
    };
    return tab;
}

}  // namespace ravnoves
