#include <QCoreApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <cmath>

#include "balance-shaft/change_map_plot.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/speed_study_model.h"
#include "balance-shaft/shaft_tabs.h"
#include "balance-shaft/torque_source_editor.h"
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

/// The map of SpeedStudyModel over α and speed with the key to its colours, and the values under
/// the pointer as text.
class SpeedMapPlot : public ChangeMapPlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SpeedMapPlot)

  public:
    SpeedMapPlot(BalanceShaftModel* model, QWidget* parent)
        : ChangeMapPlot(model, "speed-map", 2.0 * Theme::margin, parent),
          study_(model->speedStudy()) {
        setPickable(true);
        connect(this, &PlotView::pickedAt, study_, &SpeedStudyModel::pick);
        connect(study_, &SpeedStudyModel::mapChanged, this, &SpeedMapPlot::showField);
        showField();
    }

    /// The field under the picture.
    QString csv(const CsvFormat& format) const override {
        if (!study_->isSolved()) {
            return {};
        }
        const ShownTitle speed = shownTitle(tr("n, min⁻¹"));
        QString text = format.line({speed.text, tr("α, °"), title()});
        const QRectF& where = field().where;
        const std::size_t columns = field().columns;
        const std::size_t rows = field().changes.size() / columns;
        const auto number = [&format](double from, double span, std::size_t i, std::size_t count) {
            return format.number(from +
                                 span * static_cast<double>(i) / static_cast<double>(count - 1));
        };
        for (std::size_t i = 0; i < field().changes.size(); ++i) {
            text += format.line({number(speed.factor * where.top(), speed.factor * where.height(),
                                        i / columns, rows),
                                 number(where.left(), where.width(), i % columns, columns),
                                 format.number(100.0 * field().changes[i])});
        }
        return text;
    }

  protected:
    const ChangeContours& field() const override { return study_->map(); }
    void showField() override {
        setToolTip(!study_->isSolved()
                       ? QString()
                       : tr("Blue: smaller with the shaft; orange: larger; thick line: "
                            "no change; shaded: does not fit. Click to set α and, with "
                            "a computed torque, the speed."));
        ChangeMapPlot::showField();
    }

    /// α, speed and change at a place of the chart.
    QString tipAt(const QPointF& pixel) const override {
        if (!study_->isSolved() || !plotArea().contains(pixel)) {
            return {};
        }
        const double angle = xAt(pixel.x());
        const double speed = yAt(pixel.y());
        const double change = study_->changeAt(angle, speed);
        const QLocale locale;
        return tr("α %1°, n %2: %3")
            .arg(fixedNumber(angle, 1, locale), shownNumber(speed * units::rpm, units::rpm, 0),
                 (change > 0.0 ? tr("%1 % worse") : tr("%1 % better"))
                     .arg(fixedNumber(std::abs(change) / units::percent, 1, locale)));
    }

    void mouseMoveEvent(QMouseEvent* event) override {
        QToolTip::showText(event->globalPosition().toPoint(), tipAt(event->position()), this);
        if (event->buttons() != Qt::NoButton) {
            PlotView::mouseMoveEvent(event);
        }
    }

  private:
    SpeedStudyModel* study_;
};

}  // namespace

/// The band, the best compromise α, best α over speed, the map.
QWidget* ShaftTabs::buildSpeed() {
    SpeedStudyModel* study = model_->speedStudy();
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);

    auto* panel = new Panel(holder);
    QHBoxLayout* row = rowIn(panel, -1, panelMargins);
    auto* answer = new PartText(model_, "least-bad", panel);
    answer->setFont(Theme::font());
    colourText(answer, &Theme::text);
    row->addWidget(answer, 1);
    auto* apply = new QPushButton(tr("Apply"), panel);
    apply->setObjectName(QStringLiteral("go_best_compromise"));
    apply->setAccessibleName(tr("Apply the best compromise α"));
    connect(apply, &QPushButton::clicked, study, &SpeedStudyModel::goToBestCompromise);
    row->addWidget(apply);
    auto* rebuild =
        TorqueSourceEditor::rebuildButton(model_, QStringLiteral("rebuild_torque_here"), panel);
    row->addWidget(rebuild);
    column->addWidget(panel);

    auto* bar = new Panel(holder);
    QVBoxLayout* barColumn = columnIn(bar, 0);
    barColumn->addWidget(buildBand(study));
    // Below all that is typed: where it comes and goes nothing moves, and no gap is left between
    // them.
    auto* running = new QWidget(bar);
    row = rowIn(running, Theme::space, {Theme::margin, 0, Theme::margin, Theme::gap});
    auto* progress = new JobProgress(study->job(), tr("Progress"), running);
    row->addWidget(progress, 1);
    QPushButton* cancel = progress->cancelButton(tr("Cancel"), {});
    connect(cancel, &QPushButton::clicked, study, &SpeedStudyModel::cancel);
    row->addWidget(cancel);
    barColumn->addWidget(running);
    column->addWidget(bar);

    constexpr int pairWidth = 480;  ///< designed pixels of both beside each other
    auto* charts = new FoldingRow(pairWidth, holder);
    charts->add(new PartPlot(model_, "best-angles", charts));
    charts->add(new SpeedMapPlot(model_, charts));
    column->addWidget(charts, 1);
    column->addStretch();

    const auto showStudy = [=, this] {
        apply->setVisible(study->isSolved());
        if (study->isSolved()) {
            enableWhereFeasible(*apply, study->buildable());
        }
        rebuild->setVisible(!study->isSolved() && model_->canRebuildTorque());
        charts->setVisible(!study->isRejected());
    };
    for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
        connect(model_, signal, holder, showStudy);
    }
    showStudy();
    return holder;
}

Form* ShaftTabs::buildBand(SpeedStudyModel* study) {
    auto* form = new Form(model_, this);
    form->section({});
    for (const auto& [end, field] : {std::pair(&SpeedBand::from, &field::band_from),
                                     std::pair(&SpeedBand::to, &field::band_to)}) {
        NumberField* number = form->number(
            *field, [study, end = end] { return study->band().*end; },
            [study, end = end](std::optional<double> value) { study->setBand(end, *value); });
        number->setDigits(6);
    }
    QComboBox* criterion = form->choice(
        {}, tr("&Map of"), {tr("range"), tr("RMS")},
        tr("Criterion of the map and of the best compromise α"),
        [this] { return static_cast<int>(model_->criterion()); },
        [this](int index) {
            model_->setCriterion(static_cast<BalanceShaftModel::Criterion>(index));
        });
    connect(model_, &SceneModel::viewChanged, criterion, [this, criterion] {
        criterion->setCurrentIndex(static_cast<int>(model_->criterion()));
    });
    return form;
}

}  // namespace ravnoves
