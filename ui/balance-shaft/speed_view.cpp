#include "balance-shaft/speed_view.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "balance-shaft/model/buildable_bands.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/speed_study_model.h"
#include "balance-shaft/speed_map_plot.h"
#include "balance-shaft/torque_source_editor.h"
#include "model/background_job.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/field_slider.h"
#include "widgets/form.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"

namespace ravnoves {

using balance_shaft::SpeedBand;
namespace field = balance_shaft::field;

namespace {

constexpr int pairWidth = 480;  ///< designed pixels of two parts beside each other

/// Curves of an angle over speed: broken where the angle passes 0, which is no jump.
struct Broken {
    std::vector<double> speed;
    std::vector<double> angle;
};

Broken brokenAtZero(const std::vector<double>& speed, const std::vector<double>& angle) {
    Broken broken;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        if (i > 0 && std::abs(angle[i] - angle[i - 1]) > 180.0) {
            broken.speed.push_back(speed[i]);
            broken.angle.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        broken.speed.push_back(speed[i]);
        broken.angle.push_back(angle[i]);
    }
    return broken;
}

}  // namespace

SpeedView::SpeedView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model), study_(new SpeedStudyModel(model, this)) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);

    auto* bar = new Panel(this);
    QVBoxLayout* barColumn = columnIn(bar, 0);
    auto* barRow = new FoldingRow(pairWidth, bar);
    barRow->add(buildSliders());
    barRow->add(buildForm());
    barColumn->addWidget(barRow);
    barColumn->addWidget(buildProgress());
    column->addWidget(bar);

    angles_ = new PlotView(tr("Best α over speed"), this);
    angles_->setYAxis(PlotView::Side::Left, {tr("α, °")});
    angles_->setYRange(PlotView::Side::Left, 0.0, 360.0);
    rangeAngle_ = angles_->addCurve({.name = tr("range"),
                                     .colour = 2,
                                     .width = 1.8,
                                     .toolTip = tr("α of the least range at each speed"),
                                     .gaps = true});
    rmsAngle_ = angles_->addCurve({.name = tr("RMS"),
                                   .colour = 3,
                                   .width = 1.8,
                                   .toolTip = tr("α of the least RMS at each speed"),
                                   .gaps = true});
    map_ = new SpeedMapPlot(this);
    mapTitle_ = map_->title();
    bestLine_ = map_->addCurve({.name = tr("best α"), .colour = 7, .width = 2.0, .gaps = true});
    connect(map_, &PlotView::pickedAt, study_, &SpeedStudyModel::pick);
    auto* charts = new FoldingRow(pairWidth, this);
    charts->add(angles_);
    charts->add(map_);
    column->addWidget(charts, 1);
    charts_ = charts;

    auto* panel = new Panel(this);
    words_ = panel;
    QHBoxLayout* row = rowIn(panel, -1, panelMargins);
    answer_ = new QLabel(panel);
    answer_->setWordWrap(true);
    answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(answer_, 1);
    goLeastBad_ = new QPushButton(tr("Go"), panel);
    goLeastBad_->setMaximumWidth(Theme::withText(52));
    goLeastBad_->setAccessibleName(tr("Go to the α that is least bad over the band"));
    goLeastBad_->setToolTip(goLeastBad_->accessibleName());
    row->addWidget(goLeastBad_);
    rebuild_ =
        TorqueSourceEditor::rebuildButton(model_, QStringLiteral("rebuild_torque_here"), panel);
    row->addWidget(rebuild_);
    column->addWidget(panel);
    column->addStretch();

    connect(goLeastBad_, &QPushButton::clicked, study_, &SpeedStudyModel::goToLeastBad);
    connect(study_, &SpeedStudyModel::studied, this, &SpeedView::showStudy);
    connect(model_, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            showInput();
            study_->solve();
        }
    });
    connect(model_, &BalanceShaftModel::shaftMoved, this,
            [this] { map_->setPresentX(model_->shaftAngleDeg()); });
    connect(&Theme::instance(), &Theme::changed, this, &SpeedView::showStudy);
}

QWidget* SpeedView::buildSliders() {
    auto* sliders = new QWidget(this);
    auto* column = new QVBoxLayout(sliders);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, 0);
    column->setSpacing(Theme::gap);
    column->addWidget(new FieldSlider(
        model_, "/speed_rpm", {300.0, 9000.0, 10.0, 100.0, 0}, sliders,
        {.label = tr("Speed &n"),
         .hint = tr("Speed of the engine; the inertia torque of a computed torque follows it."),
         .name = QStringLiteral("study_speed_rpm"),
         .read = [this] { return model_->input().angular_speed / units::rpm; },
         .write = [this](double value) { model_->setSpeed(value * units::rpm); }}));
    load_ = new FieldSlider(model_, "/torque/cycle/indicated_mean_effective_pressure_bar",
                            {0.0, 25.0, 0.05, 1.0, 2}, sliders,
                            {.label = tr("&Load, IMEP"),
                             .hint = tr("Indicated mean effective pressure of the computed cycle."),
                             .name = QStringLiteral("study_load_bar"),
                             .isMovable = [this] { return study_->hasLoad(); },
                             .isGiven = [this] { return study_->load().has_value(); },
                             .read = [this] { return study_->load().value_or(0.0); },
                             .write = [this](double value) { study_->setLoad(value); }});
    column->addWidget(load_);
    return sliders;
}

/// Below all that is moved and typed: where it comes and goes nothing moves, and no gap is left
/// between them.
QWidget* SpeedView::buildProgress() {
    auto* running = new QWidget(this);
    auto* row = new QHBoxLayout(running);
    row->setContentsMargins(Theme::margin, 0, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    auto* progress = new QProgressBar(running);
    progress->setRange(0, 100);
    progress->setTextVisible(false);
    auto* cancel = new QPushButton(tr("Cancel"), running);
    row->addWidget(progress, 1);
    row->addWidget(cancel);
    QSizePolicy keepsItsPlace = running->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    running->setSizePolicy(keepsItsPlace);
    running->hide();
    connect(cancel, &QPushButton::clicked, study_, &SpeedStudyModel::cancel);
    connect(job(), &BackgroundJob::progress, progress,
            [progress](double part) { progress->setValue(static_cast<int>(100.0 * part)); });
    connect(job(), &BackgroundJob::runningChanged, running, &QWidget::setVisible);
    return running;
}

Form* SpeedView::buildForm() {
    auto* form = new Form(model_, this);
    form->section({});
    for (const auto& [end, field] : {std::pair(&SpeedBand::from, &field::band_from),
                                     std::pair(&SpeedBand::to, &field::band_to)}) {
        NumberField* number = form->number(
            *field, [this, end = end] { return study_->band().*end; },
            [this, end = end](std::optional<double> value) { study_->setBand(end, *value); });
        number->setDigits(6);
    }
    criterion_ = form->choice(
        {}, tr("&Map of"), {tr("range"), tr("RMS")},
        tr("What the map shows and the least bad α makes least"),
        [this] { return static_cast<int>(study_->criterion()); },
        [this](int index) {
            study_->setCriterion(static_cast<SpeedStudyModel::Criterion>(index));
        });
    return form;
}

void SpeedView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showInput();
    study_->solve();
}

void SpeedView::showInput() {
    load_->setToolTip(study_->hasLoad() ? QString()
                                        : tr("The load can be moved when the torque is a computed "
                                             "cycle (Torque tab)."));
    map_->setPresentX(model_->shaftAngleDeg());
}

void SpeedView::showStudy() {
    answer_->setText(study_->answer());
    goLeastBad_->setEnabled(study_->isSolved());
    goLeastBad_->setVisible(study_->isSolved());
    rebuild_->setVisible(!study_->isSolved() && model_->canRebuildTorque());
    charts_->setVisible(!study_->isRefused());
    showWordsFirst(study_->isRefused());
    if (!study_->isSolved()) {
        for (const int curve : {rangeAngle_, rmsAngle_}) {
            angles_->setCurve(curve, {}, {});
        }
        angles_->setLines({});
        map_->setCurve(bestLine_, {}, {});
        map_->setMap({});
        map_->setTitle(mapTitle_);
        map_->setToolTip({});
        map_->setBands({});
        angles_->setBands({});
        const SpeedBand asked = study_->band();
        angles_->setXAxis({tr("n, min⁻¹"), asked.from / units::rpm, asked.to / units::rpm});
        map_->setYRange(PlotView::Side::Left, asked.from / units::rpm, asked.to / units::rpm);
        return;
    }
    const auto& [speed, rangeAngle, rmsAngle] = study_->curves();
    angles_->setXAxis({tr("n, min⁻¹"), speed.front(), speed.back()});
    const Broken range = brokenAtZero(speed, rangeAngle);
    const Broken rms = brokenAtZero(speed, rmsAngle);
    angles_->setCurve(rangeAngle_, range.speed, range.angle);
    angles_->setCurve(rmsAngle_, rms.speed, rms.angle);
    const double best = study_->leastBadDeg();
    angles_->setLines(
        {{best, Qt::Horizontal, 7, tr("least bad %1°").arg(fixedNumber(best, 1, QLocale())),
          PlotView::Side::Left}});
    angles_->setBands(unbuildableBands(study_->buildable(), Qt::Vertical));
    map_->setBands(unbuildableBands(study_->buildable()));
    map_->setYRange(PlotView::Side::Left, speed.front(), speed.back());
    const Broken& line = criterion_->currentIndex() == 0 ? range : rms;
    map_->setCurve(bestLine_, line.angle, line.speed);
    showMap();
}

void SpeedView::showWordsFirst(bool first) {
    auto* column = static_cast<QVBoxLayout*>(layout());
    if (const int place = first ? 0 : 2; column->indexOf(words_) != place) {
        column->removeWidget(words_);
        column->insertWidget(place, words_);
    }
}

void SpeedView::showMap() {
    const SpeedStudyModel::Map map = study_->map();
    map_->setMap(map);
    map_->setTitle(tr("%1 ÷ without: %2…%3")
                       .arg(criterion_->currentIndex() == 0 ? tr("Range") : tr("RMS"),
                            fixedNumber(map.least, 2, QLocale()),
                            fixedNumber(map.most, 2, QLocale())));
    map_->setToolTip(
        tr("The criterion with the shaft over that without it at the same speed: blue is less, "
           "orange is more, paled cannot be built. Along the thick line, 1.0, the shaft changes "
           "nothing. Click to set α and, with a computed torque, the speed."));
}

BackgroundJob* SpeedView::job() const {
    return study_->job();
}

QString SpeedView::answer() const {
    return answer_->text();
}

}  // namespace ravnoves
