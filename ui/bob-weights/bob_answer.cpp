#include "bob-weights/bob_answer.h"

#include <QHeaderView>
#include <QLabel>

#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "bob-weights/plane_view.h"
#include "page/part_views.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "workshop/model/verdict.h"

namespace ravnoves {

namespace {

constexpr int linesBesideForce = 560;  ///< designed pixels that both need

}  // namespace

BobAnswer::BobAnswer(BobWeightsModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this);
    column->addWidget(buildHead());
    column->addWidget(buildCorrection());
    auto* row = new FoldingRow(linesBesideForce, this);
    row->add(buildLines(), 4);
    auto* force = new PartPlot(model_, "force", row);
    force->setAccessibleName(
        ForcePlot::tr("First-order force of the cylinders on a bob weight, over a turn"));
    row->add(force, 3);
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
    headline_ = copyableLabel("headline", Theme::displaySize, panel, true);
    hang_ = copyableLabel("hang", Theme::titleSize, panel);
    verdict_ = copyableLabel("verdict", Theme::titleSize, panel);
    factor_ = copyableLabel("factor", Theme::baseSize, panel);
    limits_ = copyableLabel("limits", Theme::baseSize, panel);
    troubles_ = copyableLabel("troubles", Theme::baseSize, panel, true);
    refused_ = copyableLabel("refused", Theme::baseSize, panel, true);
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
    lines_ = new PartTable(model_, "lines", tr("Bob weight, line by line"), panel);
    lines_->hideWhereEmpty();
    column->addWidget(lines_);
    column->addStretch();
    return panel;
}

QWidget* BobAnswer::buildCorrection() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Correction"), panel));
    const auto table = [&](const char* part, const QString& name) {
        auto* made = new PartTable(model_, part, name, panel);
        made->hideWhereEmpty();
        column->addWidget(made);
        return made;
    };
    runs_ = table("runs", tr("Runs of the machine"));
    planes_ = table("planes", tr("The correction planes"));
    asReadNote_ = captionLabel({}, panel);
    asReadNote_->setObjectName(QStringLiteral("as_read_note"));
    column->addWidget(asReadNote_);
    holes_ = table("holes", tr("Holes and slugs"));
    holeNote_ = captionLabel({}, panel);
    holeNote_->setObjectName(QStringLiteral("hole_note"));
    column->addWidget(holeNote_);
    drilledHeading_ = headingLabel(tr("Already drilled"), panel);
    column->addWidget(drilledHeading_);
    drilled_ = table("drilled", tr("Already drilled"));
    // Its five columns have room in a small window.
    drilled_->setFont(Theme::font(Theme::smallSize));
    drilled_->horizontalHeader()->setFont(Theme::font(Theme::smallSize, true));
    drilledNote_ = copyableCaption("drilled_note", panel);
    column->addWidget(drilledNote_);
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
    linesAndForce_->setVisible(known);
    sayOrHide(asReadNote_, bob_text::asReadNote(Words(), model_->input(), model_->solution()));
    sayOrHide(holeNote_, model_->holeNote());
    drilledHeading_->setVisible(drilled_->rowCount() > 0);
    sayOrHide(drilledNote_, model_->drilledNote());
    planes_->parentWidget()->setVisible(planes_->rowCount() > 0 || runs_->rowCount() > 0);
}

}  // namespace ravnoves
