#include "studies/sweep_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/decimal.h"
#include "model/background_job.h"
#include "plot/plot_view.h"
#include "studies/model/study_figures.h"
#include "studies/model/study_model.h"
#include "studies/model/sweep_model.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/number_field.h"

namespace ravnoves {

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
    plot_ = new PlotView(this);
    column->addWidget(plot_, 2);
    share_ = new PlotView(this);
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
    std::vector<std::pair<QString, QString>> inputs;
    for (const StudyModel::Input* input : model_->inputs()) {
        inputs.emplace_back(input->name, QString::fromStdString(input->pointer));
    }
    fill(input_, inputs, model_->input());
    std::vector<std::pair<QString, QString>> results;
    for (const studies::Watched& watched : study_->study().watch) {
        results.emplace_back(study_->resultName(watched.pointer).withUnit(),
                             QString::fromStdString(watched.pointer));
    }
    fill(result_, results, model_->result());
    showEnds();
}

void SweepView::keepChoice() {
    const auto chosen = [](const QComboBox* box) {
        return box->currentData().toString().toStdString();
    };
    study_->scene()->setSweepChoice(
        {chosen(input_), chosen(result_), from_->value(), to_->value()});
    model_->follow();
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
        SweepChoice choice = study_->scene()->sweepChoice();
        choice.result = result;
        study_->scene()->setSweepChoice(choice);
        model_->follow();
    }
}

void SweepView::showSweep() {
    const Sweep* sweep = model_->sweep();
    const bool isOld = model_->isStale() && !model_->isPartial();
    const bool isFaded = isOld && sweep != nullptr;
    const QString& trouble = model_->trouble();
    plot_->setFaded(isFaded, !isFaded ? QString() : trouble.isEmpty() ? tr("Computing…") : trouble);
    share_->setFaded(isFaded);
    words_->setText(sweepWords(*study_, *model_));
    const ShownTitle input = study_->inputTitle(model_->input());
    const bool isTaken =
        sweep != nullptr && sweep->best && !model_->isStale() && !input.text.isEmpty();
    take_->setVisible(isTaken);
    if (isTaken) {
        take_->setText(
            tr("Set t&o %1").arg(shownFormNumber(input.factor * sweep->best->x, QLocale(), 5)));
    }
    if (sweep == nullptr || isOld) {
        return;
    }
    const std::vector<Figure> figures = sweepFigures(*study_, *model_);
    plot_->showFigure(figures.front());
    share_->setVisible(figures.size() > 1);
    if (figures.size() > 1) {
        share_->showFigure(figures.back());
    }
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
