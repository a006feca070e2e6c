#include "studies/sweep_view.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "model/background_job.h"
#include "plot/plot_view.h"
#include "studies/field_plot.h"
#include "studies/model/result_words.h"
#include "studies/model/study_model.h"
#include "studies/model/sweep_model.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

namespace {

std::vector<double> times(std::vector<double> values, double factor) {
    for (double& value : values) {
        value *= factor;
    }
    return values;
}

QString markText(const Sweep& sweep) {
    return sweep.nominal ? shownFormNumber(resultName(sweep.result).shown().factor * *sweep.nominal,
                                           QLocale(), 5)
                         : QString();
}

}  // namespace

SweepView::SweepView(StudyModel* study, QWidget* parent)
    : QWidget(parent), study_(study), model_(new SweepModel(study, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::gap);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(Theme::space);
    const auto chooser = [&](const QString& text, const char* name, int row, int place) {
        auto* label = new QLabel(text, this);
        auto* box = new QComboBox(this);
        box->setObjectName(QLatin1String(name));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
        label->setBuddy(box);
        grid->addWidget(label, row, 2 * place);
        grid->addWidget(box, row, 2 * place + 1);
        connect(box, &QComboBox::activated, this, [this] {
            isChosen_ = true;
            choose();
        });
        return box;
    };
    input_ = chooser(tr("&Input"), "sweep_input", 0, 0);
    other_ = chooser(tr("a&nd"), "sweep_other", 0, 1);
    result_ = chooser(tr("&Result"), "sweep_result", 1, 0);
    reach_ = chooser(tr("Ran&ge"), "sweep_reach", 1, 1);
    for (const int times : {1, 2, 5, 10, 50}) {
        reach_->addItem(times == 1 ? tr("its ±") : tr("%1 times its ±").arg(times), times);
    }
    reach_->setToolTip(tr("Of an input without a tolerance: a tenth of its value."));
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    column->addLayout(grid);
    progress_ = new QProgressBar(this);
    progress_->setAccessibleName(tr("Progress"));
    progress_->setMaximumHeight(Theme::withText(6));
    progress_->setTextVisible(false);
    QSizePolicy keeps = progress_->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(keeps);
    progress_->hide();
    column->addWidget(progress_);
    stack_ = new QStackedWidget(this);
    line_ = new PlotView({}, stack_);
    line_->addCurve({.name = {}, .colour = 2, .width = 2.0, .inLegend = false, .gaps = true});
    map_ = new FieldPlot(stack_);
    stack_->addWidget(line_);
    stack_->addWidget(map_);
    column->addWidget(stack_, 1);
    words_ = captionLabel({}, this);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    keeps = words_->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);
    words_->setSizePolicy(keeps);
    column->addWidget(words_);
    connect(study_, &StudyModel::changed, this, &SweepView::fillChoices);
    connect(model_, &SweepModel::changed, this, &SweepView::showSweep);
    connect(model_->job(), &BackgroundJob::progress, this,
            [this](double part) { progress_->setValue(static_cast<int>(100.0 * part)); });
    connect(model_->job(), &BackgroundJob::runningChanged, this, [this](bool running) {
        progress_->setVisible(running);
        progress_->setValue(0);
    });
    fillChoices();
    showSweep();
}

void SweepView::fillChoices() {
    const auto fill = [](QComboBox* box, const std::vector<std::pair<QString, QString>>& entries,
                         const QString& wanted) {
        const QSignalBlocker block(box);
        box->clear();
        for (const auto& [text, data] : entries) {
            box->addItem(text, data);
        }
        const int found = box->findData(wanted);
        box->setCurrentIndex(std::max(found, 0));
    };
    // What scatters stands first.
    std::vector<std::pair<QString, QString>> inputs;
    for (const bool scatters : {true, false}) {
        for (const StudyModel::Input& input : study_->inputs()) {
            if (input.varied.has_value() == scatters) {
                inputs.emplace_back(input.name, QString::fromStdString(input.pointer));
            }
        }
    }
    fill(input_, inputs, isChosen_ ? QString::fromStdString(model_->input()) : QString());
    inputs.insert(inputs.begin(), {tr("no other: a line"), QString()});
    fill(other_, inputs, QString::fromStdString(model_->other()));
    std::vector<std::pair<QString, QString>> results;
    for (const studies::Watched& watched : study_->study().watch) {
        results.emplace_back(resultName(watched.pointer).withUnit(),
                             QString::fromStdString(watched.pointer));
    }
    fill(result_, results, QString::fromStdString(model_->result()));
    choose();
}

void SweepView::choose() {
    const auto chosen = [](const QComboBox* box) {
        return box->currentData().toString().toStdString();
    };
    model_->setReach(reach_->currentData().toDouble());
    model_->choose(chosen(input_), chosen(other_), chosen(result_));
}

void SweepView::showSweep() {
    const Sweep* sweep = model_->sweep();
    const bool isFaded = model_->isStale() && sweep != nullptr;
    for (PlotView* plot : {line_, static_cast<PlotView*>(map_)}) {
        plot->setFaded(isFaded, isFaded ? tr("Computing …") : QString());
    }
    QStringList lines;
    if (!model_->trouble().isEmpty()) {
        lines << model_->trouble();
    } else if (model_->result().empty()) {
        lines << tr("Choose a result to watch.");
    } else if (sweep != nullptr && sweep->refused > 0) {
        lines << tr("Refused: %1 of %2 places")
                     .arg(QLocale().toString(static_cast<qulonglong>(sweep->refused)),
                          QLocale().toString(static_cast<qulonglong>(sweep->found.size())));
    }
    words_->setText(lines.join(QLatin1Char('\n')));
    words_->setVisible(!lines.isEmpty());
    if (sweep == nullptr || model_->isStale()) {
        return;
    }
    sweep->y ? showMap() : showLine();
    stack_->setCurrentIndex(sweep->y ? 1 : 0);
}

void SweepView::showLine() {
    const Sweep& sweep = *model_->sweep();
    const ResultName name = resultName(sweep.result);
    line_->setTitle(name.text);
    const ShownTitle input = study_->inputTitle(sweep.x.pointer);
    const std::vector<double> x = times(sweep.x.values, input.factor);
    const double nominal = input.factor * sweep.x.nominal;
    line_->setXAxis({input.text, x.front(), x.back()});
    line_->setYAxis(PlotView::Side::Left, {name.unit});
    line_->setCurve(0, x, sweep.found);
    std::vector<PlotView::Band> bands;
    if (sweep.x.half > 0.0) {
        QColor pale = Theme::instance().accent();
        pale.setAlphaF(0.12F);
        const double half = input.factor * sweep.x.half;
        bands.push_back({nominal - half, nominal + half, pale, QStringLiteral("±")});
    }
    line_->setBands(std::move(bands));
    std::vector<PlotView::Mark> marks;
    if (sweep.nominal) {
        marks.push_back({nominal, *sweep.nominal, markText(sweep), 0});
    }
    line_->setMarks(std::move(marks));
    std::vector<PlotView::Line> lines;
    for (const studies::Watched& watched : study_->study().watch) {
        if (watched.pointer == sweep.result) {
            for (const auto& [limit, text] :
                 {std::pair(watched.min, tr("at least")), std::pair(watched.max, tr("at most"))}) {
                if (limit) {
                    lines.push_back({.at = *limit,
                                     .colour = plot::Line::muted,
                                     .text = text,
                                     .keptAtEdge = true});
                }
            }
        }
    }
    line_->setLines(std::move(lines));
}

void SweepView::showMap() {
    const Sweep& sweep = *model_->sweep();
    const ResultName name = resultName(sweep.result);
    const ShownTitle across = study_->inputTitle(sweep.x.pointer);
    const ShownTitle up = study_->inputTitle(sweep.y->pointer);
    const std::vector<double> x = times(sweep.x.values, across.factor);
    const std::vector<double> y = times(sweep.y->values, up.factor);
    map_->setTitle(name.withUnit());
    map_->setXAxis({across.text, x.front(), x.back()});
    map_->setYAxis(PlotView::Side::Left, {up.text});
    map_->setYRange(PlotView::Side::Left, y.front(), y.back());
    map_->setField({x, y, times(sweep.found, name.shown().factor)});
    map_->setMarks(
        {{across.factor * sweep.x.nominal, up.factor * sweep.y->nominal, markText(sweep), 0}});
}

void SweepView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    model_->setWatched(true);
}

void SweepView::hideEvent(QHideEvent* event) {
    model_->setWatched(false);
    QWidget::hideEvent(event);
}

}  // namespace ravnoves
