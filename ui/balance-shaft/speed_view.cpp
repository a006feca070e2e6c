#include "balance-shaft/speed_view.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <cmath>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/speed_study_model.h"
#include "balance-shaft/shaft_tabs.h"
#include "balance-shaft/torque_source_editor.h"
#include "model/background_job.h"
#include "page/part_views.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"

namespace ravnoves {

using balance_shaft::SpeedBand;
namespace field = balance_shaft::field;

namespace {

constexpr int pairWidth = 480;  ///< designed pixels of two parts beside each other

/// The map of SpeedStudyModel over α and speed with the key to its colours, and the values under
/// the pointer as text.
class SpeedMapPlot : public PartPlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SpeedMapPlot)

  public:
    SpeedMapPlot(BalanceShaftModel* model, QWidget* parent);

    bool isDrawing() const override { return true; }
    /// The field under the picture.
    QString csv(const CsvFormat& format) const override;

  protected:
    void paintGround(QPainter& painter) override;
    bool readsUnderPointer() const override { return false; }  // as text beside the map
    double keyHeight() const override;
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    void showMap();
    /// α, speed and change at a place of the chart; empty without a map.
    QString wordsAt(double angleDeg, double speed) const;
    /// Null: no map.
    const ChangeContours* map() const { return study_->isSolved() ? &study_->map() : nullptr; }

    SpeedStudyModel* study_;
};

SpeedMapPlot::SpeedMapPlot(BalanceShaftModel* model, QWidget* parent)
    : PartPlot(model, "speed-map", parent), study_(model->speedStudy()) {
    setPickable(true);
    connect(this, &PlotView::pickedAt, study_, &SpeedStudyModel::pick);
    connect(study_, &SpeedStudyModel::mapChanged, this, &SpeedMapPlot::showMap);
    connect(&Theme::instance(), &Theme::changed, this, &SpeedMapPlot::showMap);
    showMap();
}

void SpeedMapPlot::showMap() {
    setToolTip(map() == nullptr ? QString()
                                : tr("Blue: smaller with the shaft; orange: larger; thick line: no "
                                     "change; shaded: does not fit. Click to set α and, with a "
                                     "computed torque, the speed."));
    setImage(map() == nullptr ? QImage() : changeImage(*map()),
             map() == nullptr ? QRectF() : map()->where);
}

double SpeedMapPlot::keyHeight() const {
    return map() != nullptr ? changeKeyHeight() : 0.0;
}

void SpeedMapPlot::paintGround(QPainter& painter) {
    if (map() == nullptr) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintChangeKey(painter, map()->levels, QPointF(2.0 * Theme::margin, keyTop()),
                   width() - 4.0 * Theme::margin);
    painter.setClipRect(plotArea());
    drawContours(painter, *map(), *this);
    painter.restore();
}

QString SpeedMapPlot::wordsAt(double angleDeg, double speed) const {
    if (map() == nullptr) {
        return {};
    }
    const double change = study_->changeAt(angleDeg, speed);
    const QLocale locale;
    return tr("α %1°, n %2: %3")
        .arg(fixedNumber(angleDeg, 1, locale), shownNumber(speed * units::rpm, units::rpm, 0),
             (change > 0.0 ? tr("%1 % worse") : tr("%1 % better"))
                 .arg(fixedNumber(std::abs(change) / units::percent, 1, locale)));
}

bool SpeedMapPlot::event(QEvent* event) {
    // Over the chart what is under the pointer stays; elsewhere stands how to read the map.
    if (event->type() == QEvent::ToolTip && map() != nullptr &&
        plotArea().contains(static_cast<QHelpEvent*>(event)->pos())) {
        return true;
    }
    return PlotView::event(event);
}

void SpeedMapPlot::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    const QString words = plotArea().contains(at) ? wordsAt(xAt(at.x()), yAt(at.y())) : QString();
    QToolTip::showText(event->globalPosition().toPoint(), words, this);
    if (event->buttons() != Qt::NoButton) {
        PlotView::mouseMoveEvent(event);
    }
}

QString SpeedMapPlot::csv(const CsvFormat& format) const {
    if (map() == nullptr) {
        return {};
    }
    const ShownTitle speed = shownTitle(tr("n, min⁻¹"));
    QString text = format.line({speed.text, tr("α, °"), title()});
    const QRectF& where = map()->where;
    const std::size_t columns = map()->columns;
    const std::size_t rows = map()->changes.size() / columns;
    const auto number = [&format](double from, double span, std::size_t i, std::size_t count) {
        return format.number(from + span * static_cast<double>(i) / static_cast<double>(count - 1));
    };
    for (std::size_t i = 0; i < map()->changes.size(); ++i) {
        text += format.line(
            {number(speed.factor * where.top(), speed.factor * where.height(), i / columns, rows),
             number(where.left(), where.width(), i % columns, columns),
             format.number(100.0 * map()->changes[i])});
    }
    return text;
}

}  // namespace

SpeedView::SpeedView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model), study_(model->speedStudy()) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
    column->addWidget(buildWords());
    auto* bar = new Panel(this);
    QVBoxLayout* barColumn = columnIn(bar, 0);
    barColumn->addWidget(buildForm());
    barColumn->addWidget(buildProgress());
    column->addWidget(bar);
    auto* charts = new FoldingRow(pairWidth, this);
    charts->add(new PartPlot(model_, "best-angles", this));
    charts->add(new SpeedMapPlot(model_, this));
    column->addWidget(charts, 1);
    charts_ = charts;
    column->addStretch();
    for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
        connect(model_, signal, this, &SpeedView::showStudy);
    }
    showStudy();
}

QWidget* SpeedView::buildWords() {
    auto* panel = new Panel(this);
    QHBoxLayout* row = rowIn(panel, -1, panelMargins);
    auto* answer = new PartText(model_, "least-bad", panel);
    answer->setFont(Theme::font());
    colourText(answer, &Theme::text);
    row->addWidget(answer, 1);
    applyBestCompromise_ = new QPushButton(tr("Apply"), panel);
    applyBestCompromise_->setObjectName(QStringLiteral("go_best_compromise"));
    applyBestCompromise_->setAccessibleName(tr("Apply the best compromise α"));
    connect(applyBestCompromise_, &QPushButton::clicked, study_,
            &SpeedStudyModel::goToBestCompromise);
    row->addWidget(applyBestCompromise_);
    rebuild_ =
        TorqueSourceEditor::rebuildButton(model_, QStringLiteral("rebuild_torque_here"), panel);
    row->addWidget(rebuild_);
    return panel;
}

/// Below all that is typed: where it comes and goes nothing moves, and no gap is left
/// between them.
QWidget* SpeedView::buildProgress() {
    auto* running = new QWidget(this);
    QHBoxLayout* row = rowIn(running, Theme::space, {Theme::margin, 0, Theme::margin, Theme::gap});
    auto* progress = new JobProgress(study_->job(), tr("Progress"), running);
    row->addWidget(progress, 1);
    QPushButton* cancel = progress->cancelButton(tr("Cancel"), {});
    connect(cancel, &QPushButton::clicked, study_, &SpeedStudyModel::cancel);
    row->addWidget(cancel);
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
    form->choice(
        {}, tr("&Map of"), {tr("range"), tr("RMS")},
        tr("Criterion of the map and of the best compromise α"),
        [this] { return static_cast<int>(model_->speedCriterion()); },
        [this](int index) {
            model_->setSpeedCriterion(static_cast<BalanceShaftModel::Criterion>(index));
        });
    return form;
}

void SpeedView::showStudy() {
    applyBestCompromise_->setVisible(study_->isSolved());
    if (study_->isSolved()) {
        enableWhereFeasible(*applyBestCompromise_, study_->buildable());
    }
    rebuild_->setVisible(!study_->isSolved() && model_->canRebuildTorque());
    charts_->setVisible(!study_->isRejected());
}

}  // namespace ravnoves
