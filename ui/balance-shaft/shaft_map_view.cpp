#include "balance-shaft/shaft_map_view.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/model/shaft_map_text.h"
#include "balance-shaft/model/shown_curves.h"
#include "balance-shaft/shaft_map_plot.h"
#include "numerics/units.h"
#include "plot/plot_view.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/apart.h"
#include "widgets/form.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"

namespace ravnoves {

namespace {

constexpr int wideFrom = 860;  ///< designed pixels that map and charts need beside each other
constexpr int sideWidth = 340;

using Measure = double ShaftMap::Criteria::*;

std::vector<double> valuesOf(const std::vector<ShaftMap::Place>& places, Measure measure) {
    std::vector<double> values;
    values.reserve(places.size());
    for (const ShaftMap::Place& place : places) {
        values.push_back(place.criteria.*measure);
    }
    return values;
}

/// With gaps where there is no place.
std::vector<double> valuesOf(const std::vector<std::optional<ShaftMap::Place>>& places,
                             Measure measure) {
    std::vector<double> values;
    values.reserve(places.size());
    for (const auto& place : places) {
        values.push_back(place ? place->criteria.*measure
                               : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
}

}  // namespace

ShaftMapView::ShaftMapView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model), map_(new ShaftMapModel(model, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, Theme::space, 0, 0);
    column->setSpacing(Theme::space);
    bar_ = buildBar();
    column->addWidget(bar_);

    auto* body = new QHBoxLayout;
    body->setSpacing(Theme::space);
    tabs_ = new FittedTabs(this);
    tabs_->setDocumentMode(true);
    auto* front = new QWidget(tabs_);
    front->setObjectName(QStringLiteral("front"));
    auto* frontColumn = new QVBoxLayout(front);
    frontColumn->setContentsMargins(0, 0, 0, 0);
    frontColumn->setSpacing(Theme::gap);
    plot_ = new ShaftMapPlot(model_, map_, front);
    frontColumn->addWidget(plot_, 1);
    words_ = copyableCaption("shaft_map_words", front);
    words_->setAccessibleName(tr("The place under the pointer, or the best one"));
    wordsRoom_ = new Apart(words_, front);
    frontColumn->addWidget(wordsRoom_);
    tabs_->addTab(front, tr("Front view"));
    tabs_->addTab(buildLimits(), tr("Limits"));
    body->addWidget(tabs_, 1);
    side_ = new QWidget(this);
    side_->setFixedWidth(Theme::withText(sideWidth));
    sideColumn_ = new QVBoxLayout(side_);
    sideColumn_->setContentsMargins(0, 0, 0, 0);
    sideColumn_->setSpacing(Theme::space);
    side_->hide();
    body->addWidget(side_);
    column->addLayout(body, 1);
    buildCharts();

    connect(plot_, &ShaftMapPlot::hovered, this, &ShaftMapView::showWords);
    connect(plot_, &ShaftMapPlot::referenceMapChanged, this, [this] {
        fitWords();
        showWords();
    });
    connect(map_, &ShaftMapModel::mapChanged, this, &ShaftMapView::showMap);
    connect(map_, &ShaftMapModel::staleChanged, this, &ShaftMapView::showStale);
    connect(map_, &ShaftMapModel::moved, this, [this] {
        if (isVisible()) {
            showPresent();
            showWords(map_->isAtBest() ? QString() : plot_->placeWords(map_->present()));
        }
    });
    arrange();
    showMap();
}

QWidget* ShaftMapView::buildBar() {
    auto* bar = new Panel(this);
    auto* column = new QVBoxLayout(bar);
    column->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    column->setSpacing(Theme::gap);
    distance_ = new FieldSlider(
        model_, "/centre_distance_mm", {0.0, 200.0, 0.1, 10.0, 2}, bar,
        {.label = tr("Distance &l"),
         .hint = tr("From the crank's axis to the shaft's; α stays. Steps of 0.1 mm."),
         // A new range is a new layout of the page: not at every step.
         .ends = [this] { return std::pair(0.0, std::ceil(map_->largestDistance() / units::mm)); },
         .write = [this](double value) { map_->setDistance(value * units::mm); }});
    distance_->slider()->setObjectName(QStringLiteral("centre_distance_slider"));
    distance_->box()->setObjectName(QStringLiteral("centre_distance_box"));
    column->addWidget(distance_);

    auto* row = new QHBoxLayout;
    row->setSpacing(Theme::space);
    auto* label = new QLabel(tr("&Criterion"), bar);
    criterion_ = new QComboBox(bar);
    criterion_->addItems({tr("range"), tr("RMS"), tr("weighted sum")});
    // As wide as there is room: a narrow window keeps the button whole.
    criterion_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    criterion_->setMinimumContentsLength(4);
    criterion_->setMaximumWidth(Theme::withText(180));
    criterion_->setObjectName(QStringLiteral("map_criterion"));
    criterion_->setAccessibleName(tr("Criterion of the places of the shaft"));
    criterion_->setToolTip(
        tr("What the map shows and the best place makes least, against the engine without a shaft: "
           "the range of Mᵤₚₛ, its RMS, or a weighted sum of both"));
    label->setBuddy(criterion_);
    connect(criterion_, &QComboBox::activated, this, [this](int index) {
        map_->setCriterion(static_cast<ShaftMapModel::Criterion>(index));
    });
    row->addWidget(label);
    row->addWidget(criterion_, 1);
    row->addStretch();
    best_ = new QPushButton(tr("&Best place"), bar);
    best_->setObjectName(QStringLiteral("go_best_place"));
    connect(best_, &QPushButton::clicked, map_, &ShaftMapModel::goToBest);
    row->addWidget(best_);
    column->addLayout(row);

    weight_ = new ValueSlider(tr("&Weight of the range"), 0.0, 100.0, 1.0, 10.0, 0,
                              QStringLiteral("%"), bar);
    weight_->setHint(
        tr("Share of the range in the weighted sum; the RMS has the rest. Both count "
           "relative to the engine without a shaft."));
    weight_->setValue(100.0 * map_->weight());
    connect(weight_, &ValueSlider::valueEdited, this,
            [this](double value) { map_->setWeight(value / 100.0); });
    column->addWidget(weight_);
    return bar;
}

QWidget* ShaftMapView::buildLimits() {
    auto* form = new Form(model_, tabs_);
    FormSection* section = form->section(tr("Limits on the shaft's axis"));
    for (const char* place :
         {"/place_limits/centre_distance_min_mm", "/place_limits/centre_distance_max_mm",
          "/place_limits/shaft_angle_from_deg", "/place_limits/shaft_angle_to_deg",
          "/place_limits/left_mm", "/place_limits/right_mm", "/place_limits/bottom_mm",
          "/place_limits/top_mm"}) {
        form->number(place);
    }
    section->addWide(captionLabel(
        tr("Besides what the shaft must clear: for example a wall of the crankcase. What is empty "
           "does not limit. The sizes of the engine are on the Inputs tab."),
        section));
    form->column()->addStretch();
    constexpr int enough = 340;  // no field stands far from its name
    form->setMaximumWidth(Theme::withText(enough));
    form->setObjectName(QStringLiteral("limits"));
    return form;
}

void ShaftMapView::buildCharts() {
    using Shape = PlotView::Shape;
    distances_ = new PlotView(tr("Best α of each l; thick: can be built"), tabs_);
    distances_->setObjectName(QStringLiteral("distances"));
    distances_->setXAxis({tr("l, mm"), 0.0, 200.0});
    distances_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    distances_->setYAxis(PlotView::Side::Right, {tr("width × height, cm²")});
    distances_->setPickable(true);
    distances_->setToolTip(
        tr("Least range and least RMS of each centre distance, each at its best α: thin of all, "
           "thick of those that can be built. Size is that of the box at the α of the criterion "
           "chosen. Click to go to an l at its best α."));
    range_ = distances_->addCurve(
        {.name = tr("least range"), .colour = 2, .width = 1.2, .toolTip = tr("At its best α")});
    rms_ = distances_->addCurve(
        {.name = tr("least RMS"), .colour = 3, .width = 1.2, .toolTip = tr("At its best α")});
    size_ = distances_->addCurve({.name = tr("size"),
                                  .colour = 4,
                                  .side = PlotView::Side::Right,
                                  .width = 1.2,
                                  .pen = Qt::DashLine,
                                  .toolTip = tr("Width × height of the box, right axis")});
    rangeBuilt_ = distances_->addCurve({.name = tr("least range, can be built"),
                                        .colour = 2,
                                        .width = 3.4,
                                        .inLegend = false,
                                        .gaps = true});
    rmsBuilt_ = distances_->addCurve({.name = tr("least RMS, can be built"),
                                      .colour = 3,
                                      .width = 3.4,
                                      .inLegend = false,
                                      .gaps = true});
    connect(distances_, &PlotView::picked, this,
            [this](double x) { map_->goToDistance(x * units::mm); });

    sizes_ = new PlotView(QString(), tabs_);
    sizes_->setObjectName(QStringLiteral("sizes"));
    sizes_->setXAxis({tr("width × height, cm²"), 0.0, 1.0});
    sizes_->setPickable(true);
    sizes_->setToolTip(
        tr("Places that can be built and that no other beats in range, RMS and size at once, "
           "each to one part in a million. Click to go to one."));
    front_ = sizes_->addCurve({.name = tr("nothing better"),
                               .colour = 0,
                               .shape = Shape::Rings,
                               .toolTip = tr("In range, RMS and size at once")});
    efficient_ = sizes_->addCurve({.name = tr("by this criterion"),
                                   .colour = 3,
                                   .shape = Shape::Points,
                                   .toolTip = tr("Nothing better in this criterion and in size")});
    present_ = sizes_->addCurve({.name = tr("present place"), .colour = 7, .shape = Shape::Points});
    connect(sizes_, &PlotView::pickedAt, this, &ShaftMapView::pickSize);
    for (PlotView* chart : {distances_, sizes_}) {
        chart->installEventFilter(this);
    }
}

/// A click or a drag in a chart is one step of the history.
bool ShaftMapView::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease) {
        model_->finishDrag();
    }
    return QWidget::eventFilter(watched, event);
}

void ShaftMapView::arrange() {
    const bool wide = width() >= Theme::withText(wideFrom);
    if (wide_ == wide) {
        return;
    }
    wide_ = wide;
    if (wide) {
        for (PlotView* chart : {distances_, sizes_}) {
            sideColumn_->addWidget(chart, 1);  // takes it out of the tabs
            chart->show();
        }
    } else {
        tabs_->addTab(distances_, tr("Over l"));
        tabs_->addTab(sizes_, tr("Pareto"));
    }
    side_->setVisible(wide);
}

QSize ShaftMapView::minimumSizeHint() const {
    return {std::max(bar_->minimumSizeHint().width(), tabs_->minimumSizeHint().width()),
            QWidget::minimumSizeHint().height()};
}

void ShaftMapView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    map_->setWatched(true);
    showPresent();
}

void ShaftMapView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    map_->setWatched(false);
}

void ShaftMapView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
    fitWords();
}

void ShaftMapView::fitWords() {
    const bool isNarrow = width() < Theme::withText(500);
    const int rows = (isNarrow ? 5 : 3) + (plot_->reference() == nullptr ? 0 : isNarrow ? 3 : 1);
    wordsRoom_->setFixedHeight(rows * words_->fontMetrics().lineSpacing() + 2);
}

void ShaftMapView::showMap() {
    criterion_->setCurrentIndex(static_cast<int>(map_->criterion()));
    weight_->setVisible(map_->criterion() == ShaftMapModel::Criterion::Both);
    const ShaftMapModel::Marker* best = map_->best();
    best_->setEnabled(best != nullptr && best->isBuildable);
    const QString why =
        nothingIsBuilt() ? messageText(map_->map()->buildable.reason) : shaft_map_text::best(*map_);
    best_->setToolTip(why);
    best_->setAccessibleDescription(why);
    showStale();
    showWords();
    showDistances();
    showSizes();
    showPresent();
}

bool ShaftMapView::nothingIsBuilt() const {
    const ShaftMap* map = map_->map();
    return map != nullptr && map->best.reason.empty() && !map->buildable.reason.empty();
}

void ShaftMapView::showStale() {
    const QString computing = tr("computing …");
    distances_->setFaded(map_->isStale(), computing);
    sizes_->setFaded(map_->isStale() || nothingIsBuilt(),
                     map_->isStale() ? computing : tr("nothing can be built"));
}

void ShaftMapView::showWords(const QString& hovered) {
    const QString text = hovered.isEmpty() ? plot_->bestWords() : hovered;
    words_->setText(text);
    words_->setToolTip(text);
}

void ShaftMapView::showDistances() {
    const ShaftMap* map = map_->map();
    if (map == nullptr) {
        return;
    }
    const ShaftMap::Distances& of = map->distances;
    std::vector<double> x;
    for (const double distance : of.distance) {
        x.push_back(distance / units::mm);
    }
    const bool byRms = map_->criterion() == ShaftMapModel::Criterion::Rms;
    if (distances_->xInterval().second != map->view / units::mm && !distances_->isZoomed()) {
        distances_->setXAxis({tr("l, mm"), 0.0, map->view / units::mm});
    }
    constexpr Measure range = &ShaftMap::Criteria::range;
    constexpr Measure rms = &ShaftMap::Criteria::rms;
    distances_->setCurve(range_, x, valuesOf(of.range, range));
    distances_->setCurve(rms_, x, valuesOf(of.rms, rms));
    distances_->setCurve(rangeBuilt_, x, valuesOf(of.rangeBuilt, range));
    distances_->setCurve(rmsBuilt_, x, valuesOf(of.rmsBuilt, rms));
    // The size of where a click goes.
    std::vector<double> size;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto& built = byRms ? of.rmsBuilt[i] : of.rangeBuilt[i];
        size.push_back((built   ? *built
                        : byRms ? of.rms[i]
                                : of.range[i])
                           .criteria.size /
                       units::cm2);
    }
    distances_->setCurve(size_, x, std::move(size));
    std::vector<PlotView::Mark> marks;
    const auto mark = [&](const auto& built, const auto& all, Measure measure, int colour) {
        const auto& best = built ? built : all;
        if (best) {
            const double at = best->position.centre_distance() / units::mm;
            marks.push_back({at, best->criteria.*measure, shownDigits(at * units::mm, units::mm, 1),
                             colour, PlotView::Side::Left, true});
        }
    };
    mark(map->buildable.range, map->best.range, range, 2);
    mark(map->buildable.rms, map->best.rms, rms, 3);
    distances_->setMarks(std::move(marks));
}

void ShaftMapView::showSizes() {
    const bool byRms = map_->criterion() == ShaftMapModel::Criterion::Rms;
    const bool both = map_->criterion() == ShaftMapModel::Criterion::Both;
    sizes_->setTitle(byRms  ? tr("RMS against size")
                     : both ? tr("Weighted sum against size")
                            : tr("Range against size"));
    sizes_->setYAxis(PlotView::Side::Left, {tr("change, %")});
    const ShaftMap* map = map_->map();
    std::vector<double> x;
    std::vector<double> y;
    QStringList texts;
    std::vector<double> bestX;
    std::vector<double> bestY;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; map != nullptr && i < map->front.size(); ++i) {
        const balance_shaft::FrontPosition& place = map->front[i];
        const auto change = map_->change(place.criteria);
        if (!change) {
            continue;
        }
        x.push_back(place.criteria.size / units::cm2);
        y.push_back(100.0 * *change);
        texts << shaft_map_text::placeLines(*map_, place.position, 1).join(QLatin1Char('\n'));
        if (*change < least) {  // sizes ascend
            least = *change;
            bestX.push_back(x.back());
            bestY.push_back(y.back());
        }
    }
    if (!x.empty()) {
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        const double pad = std::max(0.04 * (*high - *low), 1e-3 * *high);
        sizeReach_ = {*low - pad, *high + pad};
    }
    sizes_->setCurve(front_, std::move(x), std::move(y));
    sizes_->setPointTexts(front_, texts);
    sizes_->setCurve(efficient_, std::move(bestX), std::move(bestY));
    showPresentSize();
}

void ShaftMapView::showPresent() {
    const double present = model_->input().centre_distance / units::mm;
    distance_->follow();
    distances_->setPresentX(present);
    plot_->setAccessibleDescription(plot_->placeWords(map_->present()));
    showPresentSize();
}

/// The axis holds the present place too, and its point is hollow where it cannot be built.
void ShaftMapView::showPresentSize() {
    const balance_shaft::Envelope& box = model_->result().envelope;
    const auto change = map_->change(
        {model_->result().M_ups.range, model_->result().M_ups.rms, box.width() * box.height()});
    if (!change) {
        sizes_->setCurve(present_, {}, {});
        return;
    }
    const double area = boxArea(box);
    const auto [low, high] = sizeReach_;
    const double pad = 0.04 * (high - low);
    const std::pair reach(std::min(low, area - pad), std::max(high, area + pad));
    if (reach != sizes_->xInterval() && !sizes_->isZoomed()) {
        sizes_->setXAxis({tr("width × height, cm²"), reach.first, reach.second});
    }
    const PlotView::Shape shape =
        model_->result().is_buildable ? PlotView::Shape::Points : PlotView::Shape::Rings;
    if (sizes_->data().curve(present_).style.shape != shape) {
        sizes_->setCurveStyle(present_, {.name = tr("present place"), .colour = 7, .shape = shape});
    }
    sizes_->setCurve(present_, {area}, {100.0 * *change});
}

/// Goes to the place whose point lies nearest on the screen.
void ShaftMapView::pickSize(double size, double change) {
    const ShaftMap* map = map_->map();
    if (map == nullptr || map->front.empty()) {
        return;
    }
    const QPointF clicked = sizes_->toPixel(size, change);
    const auto distance = [&](const balance_shaft::FrontPosition& place) {
        const QPointF away = sizes_->toPixel(place.criteria.size / units::cm2,
                                             100.0 * map_->change(place.criteria).value_or(0.0)) -
                             clicked;
        return std::hypot(away.x(), away.y());
    };
    const auto nearest =
        std::min_element(map->front.begin(), map->front.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    constexpr double reach = 40.0;  // pixels
    if (distance(*nearest) <= reach) {
        map_->moveTo(map_->shortened(nearest->position, map_->criterion()));
    }
}

}  // namespace ravnoves
