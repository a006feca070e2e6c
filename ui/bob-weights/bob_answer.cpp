#include "bob-weights/bob_answer.h"

#include <QLabel>

#include "bob-weights/force_plot.h"
#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "bob-weights/plane_view.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "workshop/model/verdict.h"
#include "workshop/sheet_form.h"

namespace ravnoves {

namespace {

constexpr int linesBesideForce = 560;  ///< designed pixels that both need

QLabel* answerLabel(QWidget* parent, const char* name, int pixelSize, bool bold = false) {
    QLabel* label = SheetForm::wrapped(parent, pixelSize, bold);
    label->setObjectName(QLatin1String(name));
    return label;
}

void sayOrHide(QLabel* label, const QString& text) {
    label->setText(unbroken(text));
    label->setVisible(!text.isEmpty());
}

}  // namespace

BobAnswer::BobAnswer(BobWeightsModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this);
    column->addWidget(buildHead());
    column->addWidget(buildCorrection());
    auto* row = new FoldingRow(linesBesideForce, this);
    row->add(buildLines(), 4);
    row->add(new ForcePlot(model_, row), 3);
    column->addWidget(row, 1);
    linesAndForce_ = row;
    auto* pictures = new QWidget(this);
    QHBoxLayout* beside = rowIn(pictures);
    beside->addWidget(new PlaneView(model_, 0, pictures));
    beside->addWidget(new PlaneView(model_, 1, pictures));
    column->addWidget(pictures, 1);
    connect(model_, &SceneModel::changed, this, &BobAnswer::showAnswer);
    showAnswer();
}

QWidget* BobAnswer::buildHead() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    headline_ = answerLabel(panel, "headline", Theme::displaySize, true);
    hang_ = answerLabel(panel, "hang", Theme::titleSize);
    verdict_ = answerLabel(panel, "verdict", Theme::titleSize);
    factor_ = answerLabel(panel, "factor", Theme::baseSize);
    limits_ = answerLabel(panel, "limits", Theme::baseSize);
    troubles_ = answerLabel(panel, "troubles", Theme::baseSize, true);
    refused_ = answerLabel(panel, "refused", Theme::baseSize, true);
    refused_->hide();
    for (QLabel* label : {headline_, refused_, hang_, verdict_, factor_, limits_, troubles_}) {
        column->addWidget(label);
    }
    return panel;
}

QWidget* BobAnswer::buildLines() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Bob weight, line by line"), panel));
    lines_ = new ResultTable(panel);
    lines_->setAccessibleName(tr("Bob weight, line by line"));
    column->addWidget(lines_);
    column->addStretch();
    return panel;
}

QWidget* BobAnswer::buildCorrection() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Correction"), panel));
    const auto table = [&](const QString& name) {
        auto* made = new ResultTable(panel);
        made->setAccessibleName(name);
        column->addWidget(made);
        return made;
    };
    runs_ = table(tr("Runs of the machine"));
    planes_ = table(tr("The correction planes"));
    movedNote_ = captionLabel({}, panel);
    movedNote_->setObjectName(QStringLiteral("moved_note"));
    column->addWidget(movedNote_);
    holes_ = table(tr("Holes and slugs"));
    holeNote_ = captionLabel({}, panel);
    holeNote_->setObjectName(QStringLiteral("hole_note"));
    column->addWidget(holeNote_);
    return panel;
}

void BobAnswer::setRefused(const QStringList& refused) {
    sayOrHide(refused_, refusedNote(Words(), refused));
    showAnswer();
}

void BobAnswer::showAnswer() {
    const bool known = model_->solution().bob_weight.has_value();
    sayOrHide(headline_, model_->headline());
    const bool isStale = !refused_->text().isEmpty();
    // What is still missing is no sentence for the display size.
    headline_->setFont(Theme::font(known ? Theme::displaySize : Theme::titleSize, !isStale));
    colourText(headline_, !known                                   ? &Theme::mutedText
                          : isStale || !model_->doubts().isEmpty() ? &Theme::warning
                                                                   : &Theme::text);
    colourText(refused_, &Theme::warning);
    sayOrHide(verdict_, model_->verdictText());
    const bool isOther = !model_->solution().holds();
    colourText(verdict_, isStale || isOther ? &Theme::warning : &Theme::text);
    sayOrHide(hang_, model_->hangText());
    sayOrHide(factor_, known ? model_->factorText() : QString());
    QStringList limits{model_->limitText(),
                       bob_text::weighing(Words(), model_->input(), model_->solution())};
    limits.removeAll(QString());
    sayOrHide(limits_, limits.join(QLatin1Char('\n')));
    sayOrHide(troubles_, model_->troubles().join(QLatin1Char('\n')));
    const auto* newest = model_->solution().newest();
    troubles_->setToolTip(newest != nullptr ? otherTip(*newest) : QString());
    colourText(troubles_, &Theme::warning);
    lines_->setResults(model_->lineResults());
    linesAndForce_->setVisible(known);
    runs_->setResults(model_->runResults());
    planes_->setResults(model_->planeResults());
    holes_->setResults(model_->holeResults());
    holes_->setVisible(holes_->rowCount() > 0);
    runs_->setVisible(runs_->rowCount() > 0);
    planes_->setVisible(planes_->rowCount() > 0);
    sayOrHide(movedNote_, bob_text::movedNote(Words(), model_->input(), model_->solution()));
    sayOrHide(holeNote_, model_->holeNote());
    planes_->parentWidget()->setVisible(planes_->rowCount() > 0 || runs_->rowCount() > 0);
}

QString BobAnswer::asText() const {
    QStringList said{headline_->text(), refused_->text(), hang_->text(),    verdict_->text(),
                     factor_->text(),   limits_->text(),  troubles_->text()};
    said.removeAll(QString());
    QString text = said.join(QLatin1Char('\n'));
    for (const ResultTable* table : {lines_, runs_, planes_, holes_}) {
        text += QLatin1Char('\n') + table->asText();
    }
    return text + holeNote_->text();
}

QString BobAnswer::asCsv() const {
    return lines_->asCsv() + QLatin1Char('\n') + runs_->asCsv() + QLatin1Char('\n') +
           planes_->asCsv() + QLatin1Char('\n') + holes_->asCsv();
}

}  // namespace ravnoves
