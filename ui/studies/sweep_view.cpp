#include "studies/sweep_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "model/background_job.h"
#include "plot/plot_view.h"
#include "studies/model/result_words.h"
#include "studies/model/study_model.h"
#include "studies/model/sweep_model.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/number_field.h"

namespace ravnoves {

namespace {

std::string chosen(const QComboBox* box) {
    return box->currentData().toString().toStdString();
}

}  // namespace

std::vector<PlotView::Line> limitLines(const StudyModel& study, const std::string& result,
                                       Qt::Orientation orientation) {
    std::vector<PlotView::Line> lines;
    const auto& watch = study.study().watch;
    const auto watched = std::ranges::find(watch, result, &studies::Watched::pointer);
    if (watched == watch.end()) {
        return lines;
    }
    for (const auto& [limit, text] : {std::pair(watched->min, SweepView::tr("at least")),
                                      std::pair(watched->max, SweepView::tr("at most"))}) {
        if (limit) {
            lines.push_back({.at = *limit,
                             .orientation = orientation,
                             .role = Role::Limit,
                             .text = text,
                             .keptAtEdge = true});
        }
    }
    return lines;
}

SweepView::SweepView(StudyModel* study, QWidget* parent)
    : QWidget(parent), study_(study), model_(new SweepModel(study, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::gap);
    auto* choices = new QHBoxLayout;
    const auto chooser = [&](const QString& text, const char* name) {
        auto* label = new QLabel(text, this);
        auto* box = new QComboBox(this);
        box->setObjectName(QLatin1String(name));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
        label->setBuddy(box);
        choices->addWidget(label);
        choices->addWidget(box, 1);
        return box;
    };
    input_ = chooser(tr("&Input"), "sweep_input");
    const auto end = [&](const QString& text, const char* name) {
        auto* label = new QLabel(text, this);
        auto* field = new NumberField(this);
        field->setObjectName(QLatin1String(name));
        field->setOptional(true);
        field->setIsOfResult(false);
        constexpr int widest = 96;
        field->setMaximumWidth(Theme::withText(widest));
        field->setHint(tr("Blank: limit of the tolerance; without a tolerance, the value ± 10 %."));
        label->setBuddy(field);
        choices->addWidget(label);
        choices->addWidget(field);
        connect(field, &NumberField::valueEdited, this, &SweepView::keepChoice);
        return field;
    };
    from_ = end(tr("&From"), "sweep_from");
    to_ = end(tr("t&o"), "sweep_to");
    result_ = chooser(tr("&Result"), "sweep_result");
    connect(input_, &QComboBox::activated, this, [this] {
        from_->setValue({});
        to_->setValue({});
        keepChoice();
    });
    connect(result_, &QComboBox::activated, this, &SweepView::keepChoice);
    column->addLayout(choices);
    auto* progress = new JobProgress(model_->job(), tr("Progress"), this);
    progress->setMaximumHeight(Theme::withText(6));
    plot_ = new PlotView({}, this);
    plot_->addCurve({.name = tr("mean"), .role = Role::Value, .width = 2.0, .gaps = true});
    column->addWidget(plot_, 2);
    share_ = new PlotView({}, this);
    share_->addCurve({.name = tr("feasible"), .role = Role::OtherQuantity, .inLegend = false});
    share_->setToolTip(tr("Share of feasible samples."));
    share_->hide();
    column->addWidget(share_, 1);
    PlotView::stack({plot_, share_});
    auto* below = new QHBoxLayout;
    words_ = captionLabel({}, this);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    below->addWidget(words_, 1);
    below->addWidget(progress);
    take_ = new QPushButton(this);
    take_->setObjectName(QStringLiteral("take_best"));
    take_->setAutoDefault(false);
    connect(take_, &QPushButton::clicked, model_, &SweepModel::takeBest);
    below->addWidget(take_);
    column->addLayout(below);
    QSizePolicy keeps = take_->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);
    take_->setSizePolicy(keeps);
    connect(study_, &StudyModel::changed, this, &SweepView::fillChoices);
    connect(model_, &SweepModel::changed, this, &SweepView::showSweep);
    from_->setValue(study_->scene()->sweepChoice().from);
    to_->setValue(study_->scene()->sweepChoice().to);
    fillChoices();
    showSweep();
}

QList<PlotView*> SweepView::plots() const {
    return share_->isHidden() ? QList{plot_} : QList{plot_, share_};
}

void SweepView::fillChoices() {
    const auto fill = [](QComboBox* box, const std::vector<std::pair<QString, QString>>& entries,
                         const std::string& wanted) {
        const QSignalBlocker block(box);
        box->clear();
        for (const auto& [text, data] : entries) {
            box->addItem(text, data);
        }
        box->setCurrentIndex(std::max(box->findData(QString::fromStdString(wanted)), 0));
    };
    // What scatters is first.
    std::vector<std::pair<QString, QString>> inputs;
    for (const bool scatters : {true, false}) {
        for (const StudyModel::Input& input : study_->inputs()) {
            if (input.varied.has_value() == scatters && !input.isMissing) {
                inputs.emplace_back(input.name, QString::fromStdString(input.pointer));
            }
        }
    }
    const SweepChoice& kept = study_->scene()->sweepChoice();
    fill(input_, inputs, kept.input);
    std::vector<std::pair<QString, QString>> results;
    for (const studies::Watched& watched : study_->study().watch) {
        results.emplace_back(study_->resultName(watched.pointer).withUnit(),
                             QString::fromStdString(watched.pointer));
    }
    fill(result_, results, model_->result().empty() ? kept.result : model_->result());
    choose();
}

void SweepView::keepChoice() {
    study_->scene()->setSweepChoice(
        {chosen(input_), chosen(result_), from_->value(), to_->value()});
    choose();
}

void SweepView::choose() {
    model_->choose({chosen(input_), chosen(result_), from_->value(), to_->value()});
    showEnds();
}

void SweepView::showEnds() {
    const StudyModel::Input* input = study_->input(model_->input());
    const std::optional<SweepModel::Ends> usual = model_->usualEnds();
    for (NumberField* field : {from_, to_}) {
        if (input != nullptr) {
            field->setShownUnit(input->shown);
            field->setRange(study_->rangeOf(input->pointer), input->shown.name);
        }
        constexpr int digits = 5;
        const double end = !usual ? 0.0 : field == from_ ? usual->first : usual->second;
        field->setPlaceholderText(usual ? tr("auto") + QChar::Nbsp +
                                              field->textOf(rounded_to_digits(end, digits))
                                        : QString());
    }
}

void SweepView::chooseResult(const std::string& result) {
    if (const int place = result_->findData(QString::fromStdString(result)); place >= 0) {
        result_->setCurrentIndex(place);
        choose();
    }
}

void SweepView::showSweep() {
    const Sweep* sweep = model_->sweep();
    const bool isFaded = model_->isStale() && sweep != nullptr;
    plot_->setFaded(isFaded, isFaded ? tr("Computing…") : QString());
    share_->setFaded(isFaded);
    words_->setText(words());
    const bool isTaken = sweep != nullptr && sweep->best && !model_->isStale() &&
                         !study_->inputTitle(sweep->input).text.isEmpty();
    take_->setVisible(isTaken);
    if (sweep == nullptr || model_->isStale()) {
        return;
    }
    if (isTaken) {
        const ShownTitle input = study_->inputTitle(sweep->input);
        take_->setText(
            tr("Set t&o %1").arg(shownFormNumber(input.factor * sweep->best->x, QLocale(), 5)));
    }
    showCurves();
}

QString SweepView::words() const {
    return !model_->trouble().isEmpty() ? model_->trouble()
           : model_->result().empty()   ? tr("Choose a result to watch.")
           : model_->sweep() == nullptr ? tr("Computing…")
                                        : bestText();
}

QString SweepView::bestText() const {
    const Sweep& sweep = *model_->sweep();
    const QString few = tr("No value makes 95 % of the samples feasible.");
    if (!sweep.best) {
        return few;
    }
    const ShownTitle input = study_->inputTitle(sweep.input);
    const ShownUnit unit = study_->resultName(sweep.result).shown();
    QString best =
        tr("Minimum 95th percentile of the absolute value: %1 at %2; %3 of the samples are "
           "feasible.")
            .arg(withUnit(shownFormNumber(unit.factor * sweep.best->size, QLocale(), 5), unit.name),
                 shownFormNumber(input.factor * sweep.best->x, QLocale(), 5),
                 percentText(sweep.best->built));
    if (sweep.best->x == sweep.places.front().x || sweep.best->x == sweep.places.back().x) {
        best += QLatin1Char(' ') + tr("This is an end of the range.");
    }
    return sweep.best->built < Sweep::minBuilt ? few + QLatin1Char(' ') + best : best;
}

void SweepView::showCurves() {
    const Sweep& sweep = *model_->sweep();
    const ResultName name = study_->resultName(sweep.result);
    const ShownTitle input = study_->inputTitle(sweep.input);
    std::vector<double> x;
    std::vector<double> mean;
    std::vector<double> below;
    std::vector<double> above;
    std::vector<double> every;
    std::vector<double> built;
    for (const Sweep::Place& place : sweep.places) {
        every.push_back(input.factor * place.x);
        built.push_back(100.0 * place.built);
        if (std::isfinite(place.mean)) {
            x.push_back(every.back());
            mean.push_back(place.mean);
            below.push_back(place.mean - place.low);
            above.push_back(place.high - place.mean);
        }
    }
    const bool scatters = std::any_of(above.begin(), above.end(), [](double a) { return a > 0; });
    const bool allBuilt =
        std::all_of(built.begin(), built.end(), [](double b) { return b > 99.9; });
    plot_->setTitle(name.text);
    plot_->setXAxis({allBuilt ? input.text : QString(), every.front(), every.back()});
    plot_->setYAxis(plot::Side::Left, {name.unit});
    plot_->setCurve(0, x, mean);
    plot_->setSpread(0, scatters ? below : std::vector<double>(),
                     scatters ? above : std::vector<double>());
    share_->setVisible(!allBuilt);
    share_->setXAxis({input.text, every.front(), every.back()});
    share_->setYAxis(plot::Side::Left, {tr("feasible, %")});
    share_->setYRange(plot::Side::Left, 0.0, 100.0);
    share_->setCurve(0, every, built);
    std::vector<PlotView::Band> bands;
    const double nominal = input.factor * sweep.nominal;
    if (sweep.half > 0.0) {
        const double half = input.factor * sweep.half;
        bands.push_back({nominal - half, nominal + half, Role::Present, 0.12, QStringLiteral("±")});
    }
    plot_->setBands(std::move(bands));
    const auto shown = [&](double value) {
        return shownFormNumber(name.shown().factor * value, QLocale(), 5);
    };
    std::vector<PlotView::Mark> marks;
    if (sweep.nominalResult) {
        marks.push_back({nominal, *sweep.nominalResult, shown(*sweep.nominalResult)});
    }
    if (sweep.best) {
        const double worst = std::copysign(sweep.best->size, sweep.best->low + sweep.best->high);
        marks.push_back({input.factor * sweep.best->x, worst,
                         QStringLiteral("95 %: ") + shown(worst), Role::Best, plot::Side::Left,
                         true});
    }
    plot_->setMarks(std::move(marks));
    plot_->setLines(limitLines(*study_, sweep.result, Qt::Horizontal));
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
