#include "workshop/workshop_answer.h"

#include <QHeaderView>
#include <QLabel>
#include <QToolButton>

#include "page/part_views.h"
#include "shop/model/verdict.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "workshop/model/bob_text.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plane_view.h"
#include "workshop/plugs/model/v8_text.h"
#include "workshop/plugs/plug_view.h"

namespace ravnoves {

namespace {

constexpr int besideEachOther = 560;  ///< designed pixels that two need

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

WorkshopAnswer::WorkshopAnswer(WorkshopModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this);
    column->addWidget(buildHead());
    pictures_ = new QWidget(this);
    QHBoxLayout* beside = rowIn(pictures_);
    beside->addWidget(new PlaneView(model_, 0, pictures_));
    beside->addWidget(new PlaneView(model_, 1, pictures_));
    column->addWidget(pictures_, 1);
    column->addWidget(buildCorrection());
    plugs_ = buildPlugs();
    column->addWidget(plugs_);
    lines_ = buildLines();
    column->addWidget(lines_);
    column->addWidget(buildDetails());
    column->addStretch();
    connect(model_, &SceneModel::changed, this, &WorkshopAnswer::showAnswer);
    showAnswer();
}

QWidget* WorkshopAnswer::buildHead() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    headline_ = copyableLabel("headline", Theme::displaySize, panel, true);
    hang_ = copyableLabel("hang", Theme::titleSize, panel);
    factor_ = copyableLabel("factor", Theme::baseSize, panel);
    limits_ = copyableLabel("limits", Theme::baseSize, panel);
    troubles_ = copyableLabel("troubles", Theme::baseSize, panel, true);
    refused_ = copyableLabel("refused", Theme::baseSize, panel, true);
    refused_->hide();
    doubtful_ = copyableLabel("doubtful", Theme::smallSize, panel);
    for (QLabel* label : {headline_, refused_, hang_, factor_, limits_, troubles_, doubtful_}) {
        column->addWidget(label);
    }
    return panel;
}

QWidget* WorkshopAnswer::buildPlugs() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Plugs"), panel));
    advice_ = copyableLabel("advice", Theme::titleSize, panel, true);
    boring_ = copyableLabel("boring", Theme::baseSize, panel);
    excess_ = copyableLabel("excess", Theme::baseSize, panel);
    for (QLabel* label : {advice_, boring_, excess_}) {
        column->addWidget(label);
    }
    options_ = new PartTable(model_, "options", tr("The options"), panel);
    options_->hideWhereEmpty();
    options_->setFont(Theme::font(Theme::smallSize));
    options_->horizontalHeader()->setFont(Theme::font(Theme::smallSize, true));
    column->addWidget(options_);
    return panel;
}

/// In a narrow window the names of the options need the room of what one only looks up.
void WorkshopAnswer::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    constexpr int wholeNames = 640;  // designed pixels that they need beside all columns
    for (const int column : {1, 2, 5}) {
        options_->setColumnHidden(column, width() < Theme::withText(wholeNames));
    }
}

QWidget* WorkshopAnswer::buildLines() {
    auto* row = new FoldingRow(besideEachOther, this);
    auto* panel = new Panel(row);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Bob weight, line by line"), panel));
    auto* lines = new PartTable(model_, "lines", tr("Bob weight, line by line"), panel);
    lines->hideWhereEmpty();
    column->addWidget(lines);
    check_ = copyableCaption("check", panel);
    column->addWidget(check_);
    column->addStretch();
    row->add(panel, 4);
    auto* beside = new QWidget(row);
    QVBoxLayout* drawn = columnIn(beside);
    auto* force = new PartPlot(model_, "force", beside);
    force->setAccessibleName(
        ForcePlot::tr("First-order force of the cylinders on a bob weight, over a turn"));
    drawn->addWidget(force, 1);
    force_ = force;
    auto* plug = new PlugView(model_, beside);
    drawn->addWidget(plug, 1);
    plugPlots_ = plug;
    row->add(beside, 3);
    return row;
}

QWidget* WorkshopAnswer::buildDetails() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder);
    auto* fold = new QToolButton(holder);
    fold->setObjectName(QStringLiteral("details"));
    fold->setText(tr("Details of the plugs"));
    fold->setCheckable(true);
    fold->setArrowType(Qt::RightArrow);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold->setToolTip(tr("Compensation by option, and details that the method neglects."));
    column->addWidget(fold);
    auto* plots = new FoldingRow(besideEachOther, holder);
    plots->add(new LowPlot(
        model_, "compensation",
        CompensationPlot::tr("Excess compensated over the lightening of one plug"), plots));
    plots->add(new LowPlot(model_, "shift",
                           ShiftPlot::tr("Coefficient Δk over the shift Δr for five crank radii"),
                           plots));
    plots->hide();
    column->addWidget(plots);
    QLabel* note = copyableCaption("shift_note", holder);
    note->hide();
    column->addWidget(note);
    const auto show = [this, fold, plots, note, holder] {
        holder->setVisible(model_->hasPlugs());
        fold->setArrowType(fold->isChecked() ? Qt::DownArrow : Qt::RightArrow);
        plots->setVisible(fold->isChecked());
        sayOrHide(note, fold->isChecked() ? model_->shiftText() : QString());
    };
    connect(fold, &QToolButton::toggled, this, show);
    connect(model_, &SceneModel::changed, holder, show);
    show();
    return holder;
}

QWidget* WorkshopAnswer::buildCorrection() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Correction"), panel));
    const auto table = [&](const char* part, const QString& name) {
        auto* made = new PartTable(model_, part, name, panel);
        made->hideWhereEmpty();
        column->addWidget(made);
        return made;
    };
    holes_ = table("holes", tr("Holes and slugs"));
    planes_ = table("planes", tr("The correction planes"));
    asReadNote_ = captionLabel({}, panel);
    asReadNote_->setObjectName(QStringLiteral("as_read_note"));
    column->addWidget(asReadNote_);
    holeNote_ = captionLabel({}, panel);
    holeNote_->setObjectName(QStringLiteral("hole_note"));
    column->addWidget(holeNote_);
    runs_ = table("runs", tr("Runs of the machine"));
    drilledHeading_ = headingLabel(tr("Already drilled"), panel);
    column->addWidget(drilledHeading_);
    drilled_ = table("drilled", tr("Already drilled"));
    // Its five columns have room in a small window.
    drilled_->setFont(Theme::font(Theme::smallSize));
    drilled_->horizontalHeader()->setFont(Theme::font(Theme::smallSize, true));
    return panel;
}

void WorkshopAnswer::setRefused(const QStringList& refused) {
    sayOrHide(refused_, refusedNote(Words(), refused));
    showAnswer();
}

void WorkshopAnswer::showAnswer() {
    const bob_weights::Result& solution = model_->solution();
    const bool known = solution.bob_weight.has_value();
    const bool isStopped = model_->withheld().bob_weight;
    const bool isStale = !refused_->text().isEmpty();
    sayOrHide(headline_, model_->headline());
    // What is still missing is no sentence for the display size.
    headline_->setFont(
        Theme::font(known || isStopped ? Theme::displaySize : Theme::titleSize, !isStale));
    colourText(headline_, isStopped ? &Theme::error
                          : !known  ? &Theme::mutedText
                          : isStale ? &Theme::warning
                                    : &Theme::text);
    colourText(refused_, &Theme::warning);
    sayOrHide(hang_, model_->hangText());
    sayOrHide(factor_, known && !model_->hasPlugs() ? model_->factorText() : QString());
    QStringList limits =
        QStringList{model_->limitText(), weighingNote(*model_)} + model_->remarks();
    limits.removeAll(QString());
    sayOrHide(limits_, limits.join(QLatin1Char('\n')));
    sayOrHide(troubles_, model_->troubles().join(QLatin1Char('\n')));
    colourText(troubles_, &Theme::warning);
    sayOrHide(doubtful_, model_->doubtfulText());
    colourText(doubtful_, &Theme::mutedText);

    const v8_plugs::Result* plugs = model_->plugs();
    plugs_->setVisible(plugs != nullptr && !isStopped);
    sayOrHide(advice_, model_->adviceText());
    const bool works = plugs != nullptr && v8_text::works(*plugs);
    advice_->setFont(Theme::font(Theme::titleSize, works && !isStale));
    colourText(advice_, plugs == nullptr || !plugs->advice ? &Theme::mutedText
                        : isStale                          ? &Theme::warning
                        : works                            ? &Theme::text
                                                           : &Theme::error);
    sayOrHide(boring_, model_->boringText());
    sayOrHide(excess_, model_->excessText());
    sayOrHide(check_, model_->checkText());
    lines_->setVisible(known);
    force_->setVisible(!model_->hasPlugs());
    plugPlots_->setVisible(model_->hasPlugs());

    pictures_->setVisible(solution.correction.has_value() || drilled_->rowCount() > 0);
    sayOrHide(asReadNote_, bob_text::asReadNote(Words(), model_->input(), solution));
    sayOrHide(holeNote_, model_->holeNote());
    drilledHeading_->setVisible(drilled_->rowCount() > 0);
    planes_->parentWidget()->setVisible(planes_->rowCount() > 0 || runs_->rowCount() > 0 ||
                                        drilled_->rowCount() > 0);
}

}  // namespace ravnoves
