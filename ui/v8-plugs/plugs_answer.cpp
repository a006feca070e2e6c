#include "v8-plugs/plugs_answer.h"

#include <QLabel>

#include "page/part_views.h"
#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/model/weighing_text.h"
#include "v8-plugs/plug_view.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "workshop/model/verdict.h"

namespace ravnoves {

namespace {

constexpr int besideEachOther = 600;  ///< designed pixels that bob weights and plots need
constexpr int wholeNames = 520;       ///< that the names of the options need beside all columns

/// As low as it can be read, so that the page needs no scroll bar for it.
class LowPlot : public PartPlot {
  public:
    LowPlot(SceneModel* model, std::string_view part, const QString& name, QWidget* parent)
        : PartPlot(model, part, parent) {
        setAccessibleName(name);
    }
    QSize sizeHint() const override { return {420, minimumSizeHint().height()}; }
};

}  // namespace

PlugsAnswer::PlugsAnswer(V8PlugsModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this);
    column->addWidget(buildAdvice());

    auto* lower = new FoldingRow(besideEachOther, this);
    auto* leftHolder = new QWidget(lower);
    QVBoxLayout* left = columnIn(leftHolder);
    left->addWidget(buildBobWeights());
    left->addWidget(new PlugView(model_, this), 1);
    lower->add(leftHolder, 7);
    lower->add(buildPlots(), 6);
    column->addWidget(lower, 1);

    connect(model_, &SceneModel::changed, this, &PlugsAnswer::showAnswer);
    connect(&Theme::instance(), &Theme::changed, this, &PlugsAnswer::showAnswer);
    showAnswer();
}

QWidget* PlugsAnswer::buildAdvice() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    advice_ = copyableLabel("advice", Theme::displaySize, panel, true);
    refused_ = copyableLabel("refused", Theme::baseSize, panel, true);
    refused_->hide();
    boring_ = copyableLabel("boring", Theme::titleSize, panel);
    hang_ = copyableLabel("hang", Theme::titleSize, panel, true);
    plugs_ = copyableLabel("plugs_while_hung", Theme::baseSize, panel);
    excess_ = copyableLabel("excess", Theme::baseSize, panel);
    troubles_ = copyableLabel("troubles", Theme::baseSize, panel);
    options_ = new PartTable(model_, "options", tr("The options"), panel);
    for (QWidget* each :
         QWidgetList{advice_, refused_, boring_, hang_, plugs_, excess_, troubles_, options_}) {
        column->addWidget(each);  // over the whole width
    }
    return panel;
}

QWidget* PlugsAnswer::buildBobWeights() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Bob weight on each crankpin"), panel));
    bobWeights_ = new PartTable(model_, "bob-weights",
                                tr("Bob weight on each crankpin, line by line"), panel);
    bobWeights_->hideWhereEmpty();
    column->addWidget(bobWeights_);
    check_ = copyableCaption("check", panel);
    column->addWidget(check_);
    weighing_ = copyableCaption("weighing", panel);
    column->addWidget(weighing_);
    return panel;
}

QWidget* PlugsAnswer::buildPlots() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder);
    compensation_ = new LowPlot(
        model_, "compensation",
        CompensationPlot::tr("Excess compensated over the lightening of one plug"), holder);
    column->addWidget(compensation_, 1);
    shift_ =
        new LowPlot(model_, "shift",
                    ShiftPlot::tr("Coefficient Δk over the shift Δr for five crank radii"), holder);
    column->addWidget(shift_, 1);
    shiftNote_ = copyableCaption("", holder);
    column->addWidget(shiftNote_);
    return holder;
}

/// In a narrow window the names of the options need the room of what one only looks up.
void PlugsAnswer::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool isNarrow = width() < Theme::withText(wholeNames);
    model_->setShortNames(isNarrow);  // a page before this one may have been narrow
    if (isNarrow != isNarrow_) {
        isNarrow_ = isNarrow;
        for (const int column : {1, 2, 5}) {
            options_->setColumnHidden(column, isNarrow);
        }
        showAdvice();
    }
    // What scrolls anyway needs not be as low as it can be read.
    constexpr int easilyRead = 210;
    const bool scrolls = width() < Theme::withText(besideEachOther);
    shift_->setMinimumHeight(scrolls ? Theme::withText(easilyRead) : 0);
}

void PlugsAnswer::showAnswer() {
    showAdvice();
    showBobWeights();
    sayOrHide(shiftNote_, model_->shiftText());
    compensation_->setVisible(model_->solution().before.has_value());
}

void PlugsAnswer::setRefused(const QStringList& refused) {
    sayOrHide(refused_, refusedNote(Words(), refused));
    showAdvice();
}

void PlugsAnswer::showAdvice() {
    const bool isStale = !refused_->text().isEmpty();
    colourText(refused_, &Theme::warning);
    sayOrHide(excess_, model_->excessText());
    sayOrHide(advice_, model_->adviceText());
    const auto& advice = model_->solution().advice;
    const bool isDoubted = advice && v8_text::doubtsWeights(model_->input());
    const bool works = v8_text::works(model_->solution()) && !isDoubted;
    // What is still missing is no sentence for the display size.
    advice_->setFont(Theme::font(works ? Theme::displaySize : Theme::titleSize, !isStale));
    const bool isUneven = v8_text::hasUnequalCrankpins(model_->input(), model_->solution());
    const Severity severity = v8_text::adviceSeverity(model_->input(), model_->solution());
    colourText(excess_, isUneven || isDoubted ? &Theme::warning : &Theme::text);
    colourText(advice_, !advice                                    ? &Theme::mutedText
                        : isStale || severity == Severity::warning ? &Theme::warning
                        : severity == Severity::error              ? &Theme::error
                                                                   : &Theme::text);
    sayOrHide(boring_, model_->boringText());
    sayOrHide(hang_, model_->hangText());
    colourText(hang_, isDoubted ? &Theme::warning : &Theme::text);
    sayOrHide(plugs_, model_->plugsText());
    const bool known = model_->solution().before.has_value();
    hang_->setFont(Theme::font(known ? Theme::titleSize : Theme::baseSize, known));
    excess_->setVisible(known);  // the room belongs to what is missing
    sayOrHide(troubles_, model_->troubles().join(QLatin1Char('\n')));
    troubles_->setToolTip(otherTip(model_->solution()));
    colourText(troubles_, &Theme::warning);
    for (int row = 0; row < options_->rowCount(); ++row) {
        const bool methodAlone = v8_text::methodAlone(
            model_->solution(), v8_plugs::all_options.at(static_cast<std::size_t>(row)));
        for (int column = 0; column < options_->columnCount(); ++column) {
            options_->item(row, column)
                ->setForeground(methodAlone ? QBrush(Theme::instance().warning()) : QBrush());
        }
    }
}

void PlugsAnswer::showBobWeights() {
    const bool isKnown = bobWeights_->rowCount() > 0;
    bobWeights_->parentWidget()->setVisible(isKnown);
    QStringList said{model_->checkText(), model_->rodFactorText()};
    said.removeAll(QString());
    // What is missing stands above.
    sayOrHide(check_, !isKnown ? QString() : said.join(QLatin1Char('\n')));
    const bool doubtful = model_->solution().shift_that_matters() != nullptr;
    colourText(check_, doubtful ? &Theme::warning : &Theme::mutedText);
    const auto weighing = v8_text::weighingNote(Words(), model_->input());
    sayOrHide(weighing_, !isKnown ? QString() : weighing.text);
    colourText(weighing_, weighing.enough ? &Theme::mutedText : &Theme::warning);
}

}  // namespace ravnoves
