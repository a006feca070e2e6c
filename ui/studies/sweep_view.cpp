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
    : QWidget(parent),
      study_(study),
      model_(new SweepModel(study, this)),
      input_(new QComboBox(this)),
      from_(new NumberField(this)),
      to_(new NumberField(this)),
      result_(new QComboBox(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::gap);
    auto* choices = new QHBoxLayout;
    const auto add = [&](const QString& text, QWidget* field, const char* name, int stretch) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        field->setObjectName(QLatin1String(name));
        choices->addWidget(label);
        choices->addWidget(field, stretch);
    };
    add(tr("&Input"), input_, "sweep_input", 1);
    add(tr("&From"), from_, "sweep_from", 0);
    add(tr("t&o"), to_, "sweep_to", 0);
    add(tr("&Result"), result_, "sweep_result", 1);
    for (QComboBox* box : {input_, result_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
    }
    for (NumberField* end : {from_, to_}) {
        end->setOptional(true);
        end->setIsOfResult(false);
        constexpr int widest = 96;
        end->setMaximumWidth(Theme::withText(widest));
        end->setHint(tr("Blank: limit of the tolerance; without a tolerance, the value ± 10 %."));
        connect(end, &NumberField::valueEdited, this, &SweepView::keepChoice);
    }
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
    const QSignalBlocker blockInput(input_);
    const QSignalBlocker blockResult(result_);
    input_->clear();
    result_->clear();
    for (const StudyModel::Input* input : model_->inputs()) {
        input_->addItem(input->name, QString::fromStdString(input->pointer));
    }
    for (const studies::Watched& watched : study_->study().watch) {
        result_->addItem(study_->resultName(watched.pointer).withUnit(),
                         QString::fromStdString(watched.pointer));
    }
    for (const auto& [box, chosen] :
         {std::pair(input_, model_->input()), std::pair(result_, model_->result())}) {
        box->setCurrentIndex(std::max(box->findData(QString::fromStdString(chosen)), 0));
    }
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
