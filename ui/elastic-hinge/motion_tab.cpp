#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <cmath>

#include "elastic-hinge/hinge_plots.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

using elastic_hinge::Motion;

namespace {

double turnsTo(double angle, const Motion& motion) {
    return std::abs(angle - motion.crank_angle.front()) / two_pi;
}

void addProgress(QHBoxLayout* bar, MotionRunner* runner) {
    auto* progress = new QProgressBar;
    progress->setRange(0, 1000);
    progress->setTextVisible(false);
    progress->setFixedWidth(Theme::withText(110));
    progress->setAccessibleName(HingePlots::tr("Part of the motion computed"));
    auto* cancel = new QPushButton(HingePlots::tr("Cancel"));
    cancel->setToolTip(HingePlots::tr("Stop computing the motion"));
    // Their place stays, so that nothing jumps when a run starts.
    for (QWidget* widget : std::initializer_list<QWidget*>{progress, cancel}) {
        QSizePolicy policy = widget->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        widget->setSizePolicy(policy);
        bar->addWidget(widget);
    }
    const auto showRunning = [progress, cancel](bool running) {
        progress->setVisible(running);
        cancel->setVisible(running);
        progress->setValue(0);
    };
    showRunning(runner->isRunning());
    QObject::connect(runner, &MotionRunner::runningChanged, progress, showRunning);
    QObject::connect(runner, &MotionRunner::progress, progress, [progress](double part) {
        progress->setValue(static_cast<int>(std::lround(1000 * part)));
    });
    QObject::connect(cancel, &QPushButton::clicked, runner, &MotionRunner::cancel);
}

PlotView* addSpeedPlot(HingePlotTab* tab) {
    PlotView* speed = tab->addPlot(HingePlots::tr("Crank speed"),
                                   {HingePlots::tr("turns"), 0.0, 5.0}, HingePlots::tr("rad/s"));
    speed->addCurve({.name = HingePlots::tr("without hinge"),
                     .width = 1.4,
                     .toolTip = HingePlots::tr("The bare mechanism, from the design speed")});
    speed->addCurve({.name = HingePlots::tr("crank hinge"),
                     .colour = 2,
                     .width = 3.0,
                     .toolTip = HingePlots::tr("With the crank's hinge, from the design speed")});
    speed->addCurve({.name = HingePlots::tr("both hinges"),
                     .colour = 7,
                     .width = 2.0,
                     .pen = Qt::DashLine,
                     .toolTip = HingePlots::tr("With the rod's hinge and the crank's beside it, "
                                               "from the design speed")});
    speed->addCurve({.name = HingePlots::tr("off design"),
                     .colour = 1,
                     .width = 1.4,
                     .toolTip = HingePlots::tr("With the crank's hinge, from another speed: the "
                                               "hinge is exact at one speed only")});
    return speed;
}

}  // namespace

HingePlotTab* makeMotionTab(ElasticHingeModel* model, QWidget* parent) {
    auto* tab = new HingePlotTab(model, parent);
    QHBoxLayout* bar = tab->addBar();
    QLabel* text = copyableCaption("", tab);
    bar->addWidget(text, 1);
    addProgress(bar, model->runner());
    PlotView* speed = addSpeedPlot(tab);
    tab->refresh = [=, shownTurns = 0.0]() mutable {
        // No unit is broken behind its stroke.
        text->setText(model->motionsText().replace(u'/', QStringLiteral("/\u2060")));
        const double turns = model->input().motion.value_or(elastic_hinge::MotionWish{}).turns;
        if (turns != shownTurns) {
            shownTurns = turns;
            speed->setXAxis({HingePlots::tr("turns"), 0.0, turns});
        }
        int curve = 0;
        for (const auto wanted : {&HingeMotions::without, &HingeMotions::crank, &HingeMotions::both,
                                  &HingeMotions::offDesign}) {
            std::vector<double> x;
            std::vector<double> y;
            if (model->motions() != nullptr && model->motions()->*wanted) {
                const Motion& motion = *(model->motions()->*wanted);
                for (const double angle : motion.crank_angle) {
                    x.push_back(turnsTo(angle, motion));
                }
                y = motion.speed;
            }
            speed->setCurve(curve++, std::move(x), std::move(y));
        }
    };
    tab->showPresent = [=] {
        const Motion* motion = model->animatedMotion();
        const auto time = model->motionTime();
        speed->setPresentX(motion != nullptr && time
                               ? std::optional(turnsTo(motion->angle_at(*time), *motion))
                               : std::nullopt);
    };
    return tab;
}

}  // namespace ravnoves
