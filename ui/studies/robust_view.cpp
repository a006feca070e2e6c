#include "studies/robust_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "model/background_job.h"
#include "studies/model/result_words.h"
#include "studies/model/robust_model.h"
#include "studies/model/study_model.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

/// A number to its second uncertain digit, with that uncertainty.
QString withError(double value, double error, int decimals) {
    if (error > 0.0) {
        decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 6);
    }
    const QString shown = fixedDecimals(value, decimals, QLocale());
    return error > 0.0 ? shown + QStringLiteral(" ± ") + fixedDecimals(error, decimals, QLocale())
                       : shown;
}

}  // namespace

RobustView::RobustView(StudyModel* study, QWidget* parent)
    : QWidget(parent), model_(new RobustModel(study, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::gap);
    auto* about =
        captionLabel(tr("The α whose 95 % point is least: nineteen of twenty engines have "
                        "at most that, each with parts within their tolerances, and as many can "
                        "be built at it. Beside it the α that is best of the inputs as they are, "
                        "of the angles that can be built then."),
                     this);
    column->addWidget(about);
    table_ = new ResultTable(this);
    table_->setAccessibleName(tr("Robust best α"));
    table_->setColumns({tr("Best α"),
                        QStringLiteral("α, °"),
                        {tr("nominal"), tr("Of the inputs as they are.")},
                        {QStringLiteral("95 %"), tr("One sample of twenty is more.")},
                        {tr("built, %"), tr("So many of the samples can be built at this α.")}});
    column->addWidget(table_, 1);
    words_ = captionLabel({}, this);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(words_);
    auto* row = new QHBoxLayout;
    take_ = new QPushButton(tr("&Go to the robust α"), this);
    take_->setObjectName(QStringLiteral("take_robust"));
    take_->setAutoDefault(false);
    connect(take_, &QPushButton::clicked, this, [this] {
        if (model_->best() != nullptr && model_->best()->robust) {
            model_->goTo(model_->best()->robust->angle);
        }
    });
    row->addWidget(take_);
    row->addStretch();
    progress_ = new QProgressBar(this);
    progress_->setRange(0, 0);  // how long it takes, the samples say
    progress_->setAccessibleName(tr("Progress"));
    progress_->hide();
    row->addWidget(progress_);
    stop_ = new QPushButton(tr("Sto&p"), this);
    stop_->setAutoDefault(false);
    stop_->hide();
    connect(stop_, &QPushButton::clicked, this,
            [this] { model_->isStopped() ? model_->run() : model_->stop(); });
    row->addWidget(stop_);
    column->addLayout(row);
    connect(model_, &RobustModel::changed, this, &RobustView::showBest);
    connect(model_->job(), &BackgroundJob::runningChanged, this, [this](bool running) {
        progress_->setVisible(running);
        showStop();
    });
    showBest();
}

void RobustView::showBest() {
    const studies::RobustBest* best = model_->best();
    const ShownUnit unit = best != nullptr ? resultName(best->value).shown() : ShownUnit{};
    ResultRows rows;
    QStringList lines;
    if (!model_->trouble().isEmpty()) {
        lines << model_->trouble();
    } else if (model_->isStopped()) {
        lines << tr("Stopped.");
    } else if (best == nullptr || model_->isStale()) {
        lines << tr("Computing …");
    }
    if (best != nullptr) {
        const auto add = [&](const QString& name,
                             const std::optional<studies::RobustBest::Place>& at) {
            if (at) {
                constexpr int angleDecimals = 2;
                const int valueDecimals = std::max(0, 1 + unit.decimals);
                rows.push_back(
                    {name, withError(at->angle, at->angle_error, angleDecimals),
                     at->nominal ? fixedNumber(unit.factor * *at->nominal, valueDecimals, QLocale())
                                 : QStringLiteral("–"),
                     withError(unit.factor * at->percentile, unit.factor * at->percentile_error,
                               valueDecimals),
                     at->buildable ? fixedDecimals(100.0 * *at->buildable, 1, QLocale())
                                   : QStringLiteral("–")});
            }
        };
        add(tr("of the inputs as they are"), best->nominal);
        add(tr("robust"), best->robust);
        if (best->robust && best->nominal) {
            const QString by =
                withUnit(withError(unit.factor * std::abs(best->gain),
                                   unit.factor * best->gain_error, std::max(2, unit.decimals)),
                         unit.name);
            const QString name = resultName(best->value).text;
            lines << (best->gain >= 0.0
                          ? tr("%1: its 95 % point is less by %2 at the robust α.").arg(name, by)
                          : tr("%1: its 95 % point is more by %2 at the robust α.").arg(name, by));
        }
        if (best->robust && best->robust->buildable &&
            *best->robust->buildable < studies::RobustBest::least_buildable) {
            lines << tr("At no α can 95 % of the samples be built, at the robust one %1.")
                         .arg(percentText(*best->robust->buildable));
        }
        if (best->samples > 0) {
            lines << tr("Samples: %1")
                         .arg(QLocale().toString(static_cast<qulonglong>(best->samples)));
        }
        if (best->refused > 0) {
            lines.last() +=
                QStringLiteral("; ") +
                tr("refused: %1").arg(QLocale().toString(static_cast<qulonglong>(best->refused)));
        }
    }
    table_->setRows(rows);
    table_->setEnabled(!model_->isStale());
    take_->setEnabled(best != nullptr && best->robust && !model_->isStale());
    words_->setText(lines.join(QLatin1Char('\n')));
    showStop();
}

void RobustView::showStop() {
    stop_->setText(model_->isStopped() ? tr("Run") : tr("Sto&p"));
    stop_->setVisible(model_->job()->isRunning() || model_->isStopped());
}

void RobustView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    model_->setWatched(true);
}

void RobustView::hideEvent(QHideEvent* event) {
    model_->setWatched(false);
    QWidget::hideEvent(event);
}

}  // namespace ravnoves
