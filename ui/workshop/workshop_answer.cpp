#include "workshop/workshop_answer.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <utility>

#include "page/part_views.h"
#include "shop/model/verdict.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plane_drawing.h"
#include "workshop/plugs/model/v8_text.h"
#include "workshop/plugs/plug_drawing.h"

namespace ravnoves {

namespace {

constexpr int besideEachOther = 560;  ///< designed pixels that two need

}  // namespace

WorkshopAnswer::WorkshopAnswer(WorkshopModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    constexpr int narrowest = 340;  // designed pixels of the tables; narrower it is a tab
    setMinimumWidth(Theme::withText(narrowest));
    QVBoxLayout* column = columnIn(this);
    column->addWidget(buildHead());
    pictures_ = new QWidget(this);
    QHBoxLayout* beside = rowIn(pictures_);
    beside->addWidget(planeView(model_, 0, pictures_));
    beside->addWidget(planeView(model_, 1, pictures_));
    column->addWidget(pictures_, 1);
    column->addWidget(buildCorrection());
    weight_ = new QWidget(this);
    QVBoxLayout* weight = columnIn(weight_);
    plugs_ = buildPlugs();
    weight->addWidget(plugs_);
    lines_ = buildLines();
    weight->addWidget(lines_);
    weight->addWidget(buildDetails());
    column->addWidget(weight_);
    column->addStretch();
    for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
        connect(model_, signal, this, &WorkshopAnswer::showAnswer);
    }
    showAnswer();
}

QLabel* WorkshopAnswer::say(QVBoxLayout* column, const char* id, int pixelSize, Ink ink,
                            bool isBold) {
    QLabel* label = copyableLabel(id, pixelSize, column->parentWidget(), isBold);
    colourText(label, ink);
    column->addWidget(label);
    return said_[id] = label;
}

QWidget* WorkshopAnswer::buildHead() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    say(column, "correction", Theme::displaySize);
    say(column, "headline", Theme::displaySize);
    say(column, "rejected", Theme::baseSize, &Theme::warning, true);
    say(column, "hang", Theme::titleSize);
    say(column, "factor", Theme::baseSize);
    say(column, "limits", Theme::baseSize);
    say(column, "troubles", Theme::baseSize, &Theme::warning, true);
    say(column, "doubtful", Theme::smallSize, &Theme::mutedText);
    return panel;
}

QWidget* WorkshopAnswer::buildPlugs() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    column->addWidget(headingLabel(tr("Plugs"), panel));
    say(column, "advice", Theme::titleSize);
    say(column, "boring", Theme::baseSize);
    say(column, "excess", Theme::baseSize);
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
    // Designed pixels that they need beside a column and those that hide later.
    constexpr std::pair<int, int> needed[] = {{1, 720}, {2, 720}, {3, 400}, {5, 720}};
    for (const auto& [column, room] : needed) {
        options_->setColumnHidden(column, width() < Theme::withText(room));
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
    say(column, "check", Theme::smallSize, &Theme::mutedText);
    column->addStretch();
    row->add(panel, 5);
    row->add(plugView(model_, row), 3);
    return row;
}

QWidget* WorkshopAnswer::buildDetails() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder);
    auto* fold = new QToolButton(holder);
    fold->setObjectName(QStringLiteral("details"));
    fold->setText(tr("Details"));
    fold->setCheckable(true);
    fold->setArrowType(Qt::RightArrow);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold->setToolTip(tr("Charts that explain the bob weight or the plugs."));
    column->addWidget(fold);
    auto* plots = new FoldingRow(besideEachOther, holder);
    const auto add = [&](std::string_view part, const QString& name) {
        auto* plot = new PartPlot(model_, part, plots);
        plot->setAccessibleName(name);
        constexpr int height = 220;  // designed pixels: labels have room beside the curves
        plot->setMinimumHeight(Theme::withText(height));
        plots->add(plot);
        return plot;
    };
    auto* ofPlugs = add("compensation",
                        CompensationPlot::tr("Excess compensated over the lightening of one plug"));
    auto* force = add(
        "force", ForcePlot::tr("First-order force of the cylinders on a bob weight, over a turn"));
    plots->hide();
    column->addWidget(plots);
    QLabel* note = copyableCaption("shift_note", holder);
    note->hide();
    column->addWidget(note);
    const auto show = [this, fold, plots, note, ofPlugs, force] {
        ofPlugs->setVisible(model_->hasPlugs());
        force->setVisible(!model_->hasPlugs());
        fold->setArrowType(fold->isChecked() ? Qt::DownArrow : Qt::RightArrow);
        plots->setVisible(fold->isChecked());
        showOrHide(note, fold->isChecked() ? model_->shiftText() : QString());
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
    say(column, "convention", Theme::baseSize);
    const auto table = [&](const char* part, const QString& name) {
        auto* made = new PartTable(model_, part, name, panel);
        made->hideWhereEmpty();
        column->addWidget(made);
        return made;
    };
    table("holes", tr("Holes and slugs"));
    planes_ = table("planes", tr("The correction planes"));
    say(column, "as_read_note", Theme::smallSize, &Theme::mutedText);
    say(column, "hole_note", Theme::smallSize, &Theme::mutedText);
    runs_ = table("runs", tr("Runs of the machine"));
    drilledHeading_ = headingLabel(tr("Already drilled"), panel);
    column->addWidget(drilledHeading_);
    drilled_ = table("drilled", tr("Already drilled"));
    // Its five columns have room in a small window.
    drilled_->setFont(Theme::font(Theme::smallSize));
    drilled_->horizontalHeader()->setFont(Theme::font(Theme::smallSize, true));
    return panel;
}

void WorkshopAnswer::setOfMachine(bool isOfMachine) {
    isOfMachine_ = isOfMachine;
    showAnswer();
}

void WorkshopAnswer::showAnswer() {
    constexpr std::array<std::string_view, 4> ofWeight{"headline", "hang", "factor", "doubtful"};
    for (const AnswerLine& line : answerLines(*model_)) {
        const bool isLeftOut = isOfMachine_ ? std::ranges::find(ofWeight, line.id) != ofWeight.end()
                                            : line.id == "correction";
        showOrHide(said_.at(line.id), isLeftOut ? QString() : line.texts.join(QLatin1Char('\n')));
    }
    const bool known = model_->solution().bob_weight.has_value();
    const bool isStopped = model_->withheld().bob_weight;
    const bool isStale = model_->isOutdated();
    // What is still missing is no sentence for the display size.
    const auto show = [&](const char* id, bool isLarge, bool isAnswer, Ink ink) {
        QLabel* label = said_.at(id);
        label->setFont(Theme::font(isLarge ? Theme::displaySize : Theme::titleSize, !isStale));
        colourText(label, isAnswer && isStale ? &Theme::warning : ink);
    };
    show("headline", known || isStopped, known,
         isStopped ? &Theme::error
         : known   ? &Theme::text
                   : &Theme::mutedText);
    const WorkshopModel& shown = model_->shown();
    const QString verdict = shown.verdictNow();
    if (auto* area = qobject_cast<QScrollArea*>(parentWidget()->parentWidget());
        std::exchange(verdict_, verdict) != verdict && area != nullptr) {
        area->verticalScrollBar()->setValue(0);  // another verdict is to be seen
    }
    const VerdictKind kind = verdictKind(verdict);
    const bool isWithheld = shown.withheld().any();
    show("correction", kind != VerdictKind::None, kind != VerdictKind::None && !isWithheld,
         isWithheld                  ? &Theme::error
         : kind == VerdictKind::None ? &Theme::mutedText
         : kind == VerdictKind::Open ? &Theme::warning
         : kind == VerdictKind::Pass ? &Theme::good
                                     : &Theme::error);
    const v8_plugs::Result* plugs = model_->plugs();
    const bool isAdvised = plugs != nullptr && plugs->advice;
    const bool works = isAdvised && v8_text::works(*plugs);
    show("advice", false, isAdvised,
         !isAdvised ? &Theme::mutedText
         : works    ? &Theme::text
                    : &Theme::error);
    if (!works) {
        said_.at("advice")->setFont(Theme::font(Theme::titleSize));
    }
    plugs_->setVisible(plugs != nullptr && !isStopped);
    lines_->setVisible(known);
    weight_->setVisible(!isOfMachine_ && (known || model_->hasPlugs()));
    const bool isDrilled = drilled_->rowCount() > 0;
    pictures_->setVisible(shown.solution().correction.has_value() || isDrilled);
    drilledHeading_->setVisible(isDrilled);
    planes_->parentWidget()->setVisible(planes_->rowCount() > 0 || runs_->rowCount() > 0 ||
                                        isDrilled);
}

}  // namespace ravnoves
