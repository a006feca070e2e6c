#include "plot/plot_view.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAccessibleWidget>
#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QMetaMethod>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "pictures/figure.h"
#include "pictures/wheel_guard.h"
#include "plot/legend_item.h"
#include "plot/plot_painter.h"
#include "text/csv_format.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr double zoomPerStep = 1.2;

/// A screen reader that asks for the description gets the sentence, made then and not at every
/// frame.
class AccessiblePlot final : public QAccessibleWidget {
  public:
    explicit AccessiblePlot(PlotView* plot) : QAccessibleWidget(plot, QAccessible::Chart) {}

    QString text(QAccessible::Text kind) const override {
        return kind == QAccessible::Description ? static_cast<PlotView*>(widget())->sentence()
                                                : QAccessibleWidget::text(kind);
    }
};

QAccessibleInterface* makeAccessible(const QString& /*className*/, QObject* object) {
    auto* plot = qobject_cast<PlotView*>(object);
    return plot != nullptr ? new AccessiblePlot(plot) : nullptr;
}

/// Gives a picture the size of a widget, in its pixels; opaque. @return true where that is another
/// one, and nothing in it
bool fitPicture(QImage& picture, const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    const QSize pixels = (QSizeF(widget.size()) * ratio).toSize();
    if (picture.size() == pixels && picture.devicePixelRatio() == ratio) {
        return false;
    }
    picture = QImage(pixels, QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    return true;
}

}  // namespace

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
    [[maybe_unused]] static const bool isAccessible =
        (QAccessible::installFactory(makeAccessible), true);
    guardWheel();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);  // nothing behind it is painted first
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto* menu = new FigureMenu(
        this, QStringLiteral("plot"),
        [this](QPainter& painter, const QRectF& target) { renderTo(painter, target); });
    menu->setData([this](const CsvFormat& format) { return csv(format); });
    addAction(tr("Reset zoom"), this, &PlotView::resetZoom);
    connect(&Theme::instance(), &Theme::changed, this, &PlotView::chartChanged);
    setPickable(false);
}

PlotView::~PlotView() {
    for (PlotView* other : stack_) {
        other->stack_.removeOne(this);
    }
}

void PlotView::stack(const QList<PlotView*>& plots) {
    for (PlotView* plot : plots) {
        plot->stack_ = plots;
        plot->stack_.removeOne(plot);
        plot->chartChanged();
    }
}

QList<LegendItem*> PlotView::shownLegend() const {
    QList<LegendItem*> items(legend_.begin(), legend_.end());
    items << spreadItem_ << referenceItem_;
    items.removeIf([](const LegendItem* item) { return item == nullptr || item->isHidden(); });
    return items;
}

void PlotView::showFigure(const Figure& figure) {
    const QString before = data_.title;
    const PlotData::Change change = data_.show(figure);
    if (data_.title != before) {
        setAccessibleName(data_.title);
    }
    if (change == PlotData::Change::Chart) {
        for (std::size_t number = 0; number < data_.curves.size(); ++number) {
            dressLegend(number);
        }
        chartChanged();
    } else if (change == PlotData::Change::Curves) {
        curvesChanged();
    }
    showLegend();
    if (change != PlotData::Change::None) {
        updateChart();
    }
    if (figure.spreads) {
        setSpreads(*figure.spreads);
    }
}

LegendItem* PlotView::addSwitch(bool& shown, plot::Shape shape) {
    auto* item = new LegendItem(this);
    item->setChecked(shown);
    item->setSwatch({}, shape);
    connect(item, &LegendItem::toggled, this, [this, &shown](bool on) {
        shown = on;
        data_.makeStale();
        chartChanged();
    });
    return item;
}

void PlotView::dressLegend(std::size_t number) {
    const plot::CurveStyle& style = data_.curves[number].style;
    if (number == legend_.size()) {
        legend_.push_back(style.inLegend ? new LegendItem(this) : nullptr);
        if (LegendItem* item = legend_.back()) {
            item->setChecked(style.shown);
            connect(item, &LegendItem::toggled, this,
                    [this, number](bool on) { setCurveShown(static_cast<int>(number), on); });
        }
    }
    if (LegendItem* item = legend_[number]) {
        item->setName(style.name);
        item->setAccessibleName(tr("Show %1").arg(style.name));
        item->setToolTip(style.toolTip.isEmpty() ? tr("Show or hide %1").arg(style.name)
                                                 : style.toolTip);
        item->setSwatch(style.role, style.shape);
    }
}

void PlotView::showReference(const Figure* figure, const QString& name) {
    if (figure == nullptr) {
        if (std::exchange(data_.reference, nullptr) != nullptr) {
            showLegend();
            chartChanged();
        }
        return;
    }
    data_.reference = std::make_shared<PlotData>();
    data_.reference->show(*figure);
    data_.referenceName = name;
    if (referenceItem_ == nullptr) {
        referenceItem_ = addSwitch(data_.referenceShown, plot::Shape::Line);
    }
    constexpr int longest = 24;
    referenceItem_->setName(name.size() > longest ? name.left(longest - 1) + QChar(0x2026) : name);
    referenceItem_->setAccessibleName(tr("Show reference %1").arg(name));
    referenceItem_->setToolTip(tr("Show or hide the curves of the reference %1").arg(name));
    showLegend();
    chartChanged();
}

void PlotView::showLegend() {
    const auto isThere = [this](std::size_t curve) {
        return !data_.curves[curve].x.empty() ||
               data_.curveOfReference(data_.curves[curve]) != nullptr;
    };
    // A name without a curve says nothing, but a plot that waits for its data has its frame.
    bool any = false;
    for (std::size_t curve = 0; curve < legend_.size(); ++curve) {
        any = any || (legend_[curve] != nullptr && isThere(curve));
    }
    for (std::size_t curve = 0; curve < legend_.size(); ++curve) {
        if (LegendItem* item = legend_[curve]) {
            item->setVisible(!item->name().isEmpty() &&
                             (any ? isThere(curve) : data_.curves[curve].inFigure));
        }
    }
    if (spreadItem_ != nullptr) {
        spreadItem_->setVisible(data_.hasSpread());
    }
    if (referenceItem_ != nullptr) {
        referenceItem_->setVisible(data_.hasGhosts());
    }
}

void PlotView::setSpreads(const plot::Spreads& spreads) {
    bool isOther = false;
    for (PlotCurve& curve : data_.curves) {
        const auto found = spreads.find(curve.id);
        const plot::Spread spread = found != spreads.end() ? found->second : plot::Spread();
        if (curve.below != spread.below || curve.above != spread.above) {
            curve.below = spread.below;
            curve.above = spread.above;
            curve.stale = isOther = true;
        }
    }
    if (!isOther) {
        return;
    }
    if (spreadItem_ == nullptr) {
        spreadItem_ = addSwitch(data_.spreadShown, plot::Shape::Bars);
        spreadItem_->setObjectName(QStringLiteral("spread"));
        spreadItem_->setName(tr("5…95 %"));
        spreadItem_->setAccessibleName(tr("Show the tolerance band"));
        spreadItem_->setToolTip(
            tr("Range from 5 % to 95 % of the curve, with the tolerances of the case."));
    }
    showLegend();
    curvesChanged();
}

void PlotView::setCurveShown(int number, bool shown) {
    PlotCurve& curve = data_.curve(number);
    if (curve.shown == shown) {
        return;
    }
    curve.shown = shown;
    curve.stale = true;
    data_.pointRead.reset();
    if (LegendItem* item = legend_[static_cast<std::size_t>(number)]) {
        item->setChecked(shown);
    }
    curvesChanged();
}

void PlotView::setImage(const QImage& image, const QRectF& values) {
    data_.image = image;
    data_.imageValues = values;
    // One that ends within what was there to zoom out to is shown whole.
    const auto ends = [](double size, const PlotScale& scale) {
        return size < (scale.home.second - scale.home.first) * (1.0 - 1e-9);
    };
    if (data_.equalScale && !image.isNull() &&
        (ends(values.width(), data_.x) || ends(values.height(), data_.left))) {
        data_.zoomed = false;
    }
    chartChanged();
}

void PlotView::setFaded(bool faded, const QString& text) {
    if (data_.faded != faded || data_.fadedText != text) {
        data_.fadedText = text;
        overlay(data_.faded, faded);
    }
}

QSize PlotView::minimumSizeHint() const {
    constexpr int chart = 106;  // with its axis
    const int header = static_cast<int>(std::ceil(data_.headerHeight));
    return {Theme::withText(200), std::max(Theme::withText(140), header + Theme::withText(chart))};
}

void PlotView::setPickable(bool pickable) {
    pickable_ = pickable;
    setCursor(pickable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setStatusTip(pickable ? tr("Click or drag: choose the value; wheel: zoom; middle button: pan; "
                               "double click: show all.")
                          : tr("Wheel: zoom, with Shift in y, with Ctrl in x; drag: pan; double "
                               "click: show all."));
}

void PlotView::resetZoom() {
    data_.zoomed = false;
    chartChanged();
}

void PlotView::updateChart() {
    update(chartRect());
}

void PlotView::curvesChanged() {
    chartStale_ = true;
    updateChart();
}

void PlotView::overCurvesChanged() {
    pictureStale_ = true;
    updateChart();
}

void PlotView::chartChanged() {
    axesStale_ = true;
    curvesChanged();
    update();
}

void PlotView::layoutHeader() {
    const double header = data_.headerHeight;
    // Title and legend in one row where they fit, else the legend flows in rows below the title.
    const auto placed = [](PlotView& plot) {
        const PlotTitle title(plot.data_.title, plot.width() - 2.0 * Theme::margin);
        const double row =
            std::ceil(QFontMetricsF(Theme::font(Theme::baseSize, true)).height()) + Theme::gap;
        double legendWidth = 0.0;
        const QList<LegendItem*> items = plot.shownLegend();
        for (const LegendItem* item : items) {
            legendWidth += item->sizeHint().width();
        }
        const double right = plot.width() - Theme::space;
        const bool oneRow = title.width + 2.0 * Theme::margin + legendWidth <= right;
        const double x0 = Theme::margin - Theme::gap;
        double x = oneRow ? right - legendWidth : x0;
        double y = Theme::gap + (oneRow ? 0.0 : title.height + Theme::gap);
        double below = items.empty() ? y + (oneRow ? row : 0.0) : y + row;  // the row
        for (LegendItem* item : items) {
            const int itemWidth = std::min(item->sizeHint().width(), static_cast<int>(right - x0));
            if (!oneRow && x + itemWidth > right && x > Theme::margin) {
                x = x0;
                y = below;
            }
            // A name that is longer than a row takes as many as it needs.
            const double itemHeight = std::max<double>(row, item->heightForWidth(itemWidth));
            item->setGeometry(QRectF(x, y, itemWidth, itemHeight).toAlignedRect());
            x += itemWidth;
            below = std::max(below, y + itemHeight);
        }
        if (legendWidth == 0.0 && plot.data_.title.isEmpty()) {
            below = Theme::gap;
        }
        return below + plot.keyHeight();
    };
    double highest = placed(*this);
    // Charts beside each other begin at one height.
    QList<PlotView*> row;
    if (parentWidget() != nullptr && !isHidden()) {
        row = parentWidget()->findChildren<PlotView*>(Qt::FindDirectChildrenOnly);
        row.removeIf([this](const PlotView* other) {
            return other->isHidden() || other->y() != y() || other->height() != height() ||
                   other->x() == x();
        });
    }
    for (PlotView* other : row) {
        highest = std::max(highest, placed(*other));
    }
    data_.headerHeight = highest;
    for (PlotView* other : row) {
        if (other->data_.headerHeight != highest) {
            other->chartChanged();
        }
    }
    if (data_.headerHeight != header) {
        updateGeometry();
        update();
    }
}

void PlotView::layoutChart() {
    layoutHeader();
    data_.locale = locale();
    PlotMargins maximum;
    for (PlotView* other : stack_) {
        if (!other->data_.x.spec.title.isEmpty()) {
            data_.xName = other->data_.x.spec.title;
        }
        if (!other->isHidden() && other->width() == width()) {
            other->data_.locale = other->locale();
            const PlotMargins theirs = plotMargins(other->data_, other->size());
            maximum = {std::max(maximum.left, theirs.left), std::max(maximum.right, theirs.right)};
        }
    }
    layOutPlot(data_, size(), maximum, axesStale_);
    // What stands over or under this one follows, unless it is to be laid out anyway.
    for (PlotView* other : stack_) {
        if (!other->chartStale_ && other->width() == width() &&
            (other->data_.area.left() != data_.area.left() ||
             other->data_.area.width() != data_.area.width())) {
            other->chartChanged();
        }
    }
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (drawsForFile(painter, *this)) {
        drawChart(painter);
        return;
    }
    const bool moves = std::exchange(chartStale_, false);
    if (moves) {
        layoutChart();
    }
    // What changes with every step is painted at once; a picture of it would be used once.
    if (std::exchange(axesStale_, false)) {
        axesPicture_ = QImage();
        paintAxes(painter);
        paintCurves(painter);
        pictureStale_ = true;
    } else {
        if (fitPicture(axesPicture_, *this)) {
            QPainter axes(&axesPicture_);
            paintAxes(axes);
            pictureStale_ = true;
        }
        pictureStale_ = pictureStale_ || moves;
        if (!moves && std::exchange(pictureStale_, false)) {
            fitPicture(picture_, *this);
            std::memcpy(picture_.bits(), axesPicture_.constBits(),
                        static_cast<std::size_t>(axesPicture_.sizeInBytes()));
            QPainter curves(&picture_);
            paintCurves(curves);
        }
        if (const double ratio = devicePixelRatioF(); ratio != std::floor(ratio)) {
            painter.fillRect(rect().adjusted(-1, -1, 1, 1), Theme::instance().panel());
        }
        painter.drawImage(0, 0, moves ? axesPicture_ : picture_);
        if (moves) {
            paintCurves(painter);
        }
    }
    paintPlotOverlay(painter, data_);
    paintTop(painter);
}

void PlotView::drawChart(QPainter& painter) {
    layoutChart();
    const auto cursor = std::exchange(data_.cursorX, std::nullopt);
    const auto point = std::exchange(data_.pointRead, std::nullopt);
    // A present value that goes where the cursor goes is the mouse's, too.
    const auto present = data_.presentX;
    if (isSignalConnected(QMetaMethod::fromSignal(&PlotView::cursorMoved))) {
        data_.presentX.reset();
    }
    paintAxes(painter);
    paintCurves(painter);
    paintPlotOverlay(painter, data_);
    paintTop(painter);
    data_.cursorX = cursor;
    data_.pointRead = point;
    data_.presentX = present;
    chartStale_ = true;
}

void PlotView::renderTo(QPainter& painter, const QRectF& target) {
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    drawChart(painter);
    for (const LegendItem* item : shownLegend()) {
        if (item->isChecked()) {
            item->draw(painter, QRectF(item->geometry()));
        }
    }
    painter.restore();
}

QString PlotView::dataAsCsv() const {
    return csv(CsvFormat());
}

void PlotView::paintAxes(QPainter& painter) {
    painter.fillRect(QRectF(rect()), Theme::instance().panel());
    paintPlotAxes(painter, data_);
    paintGround(painter);
}

void PlotView::paintCurves(QPainter& painter) {
    paintPlotCurves(painter, data_);
    paintOverCurves(painter);
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    const bool inside = plotArea().contains(event->position());
    if (inside && pickable_ && event->button() == Qt::LeftButton &&
        !event->modifiers().testFlag(Qt::ShiftModifier)) {
        picking_ = true;
        pickedFrom_ = data_.presentX;
        pick(event->position());
    } else if (inside &&
               (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton)) {
        panFrom_ = event->position();
    }
    event->accept();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    QToolTip::hideText();  // it would lie over what is read now
    if (picking_) {
        pick(event->position());
        moveCursor(event->position());  // what is read goes with the hand
        return;
    }
    if (panFrom_) {
        const QPointF moved = event->position() - *panFrom_;
        if (data_.zoomed || moved.manhattanLength() > QApplication::startDragDistance()) {
            data_.pan(moved);
            readPoint(std::nullopt);
            setCursorX({});
            chartChanged();
            panFrom_ = event->position();
        }
        return;
    }
    moveCursor(event->position());
}

void PlotView::mouseReleaseEvent(QMouseEvent* event) {
    picking_ = false;
    panFrom_.reset();
    moveCursor(event->position());
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (pickable_ && !data_.zoomed) {
        mousePressEvent(event);
        return;
    }
    if (pickable_ && pickedFrom_) {
        Q_EMIT picked(*pickedFrom_);  // the first of the two clicks was not meant to choose
    }
    resetZoom();
}

void PlotView::pick(const QPointF& position) {
    const double x = std::clamp(xAt(position.x()), data_.x.low, data_.x.high);
    Q_EMIT picked(x);
    Q_EMIT pickedAt(x, std::clamp(yAt(position.y()), data_.left.low, data_.left.high));
}

void PlotView::readPoint(const std::optional<PlotData::Point>& point) {
    overlay(data_.pointRead, point, data_.pointRead != point);
}

void PlotView::moveCursor(const QPointF& position) {
    if (!readsUnderPointer()) {
        return;
    }
    if (data_.readsPoints()) {
        readPoint(data_.nearestPoint(position));
    } else if (plotArea().contains(position)) {
        moveCursorTo(xAt(position.x()));
    } else {
        setCursorX({});
    }
}

void PlotView::moveCursorTo(double x) {
    setCursorX(x);
    Q_EMIT cursorMoved(x);
}

void PlotView::stopReading() {
    readPoint(std::nullopt);
    setCursorX({});
}

void PlotView::leaveEvent(QEvent* /*event*/) {
    stopReading();
}

bool PlotView::scrollsWithin() const {
    for (const QWidget* above = parentWidget(); above != nullptr; above = above->parentWidget()) {
        const auto* area = qobject_cast<const QAbstractScrollArea*>(above);
        if (area != nullptr && area->verticalScrollBar()->maximum() > 0) {
            return true;
        }
    }
    return false;
}

void PlotView::wheelEvent(QWheelEvent* event) {
    // A page that is scrolled goes on where a plot comes under the pointer.
    if (event->modifiers() == Qt::NoModifier && !isWheelOf(this) && scrollsWithin()) {
        stopReading();  // the plot goes away from under the pointer
        event->ignore();
        return;
    }
    // Alt and some desktops turn the wheel sideways: either axis counts.
    const double turned =
        event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const double factor = std::pow(zoomPerStep, -turned / 120.0);
    const bool onlyY = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool onlyX = event->modifiers().testFlag(Qt::ControlModifier);
    zoom(onlyY ? 1.0 : factor, onlyX ? 1.0 : factor, event->position());
    event->accept();
}

void PlotView::zoom(double factorX, double factorY, const QPointF& about) {
    data_.zoom(factorX, factorY, about);
    chartChanged();
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = plotArea().center();
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoom(1 / zoomPerStep, 1 / zoomPerStep, middle);
            return;
        case Qt::Key_Minus:
            zoom(zoomPerStep, zoomPerStep, middle);
            return;
        case Qt::Key_0:
        case Qt::Key_Home:
        case Qt::Key_Escape:
            resetZoom();
            return;
        case Qt::Key_Left:
        case Qt::Key_Right: {
            const int by = event->key() == Qt::Key_Left ? -1 : 1;
            const PlotScale& scale = data_.x;
            if (data_.readsPoints()) {
                readPoint(data_.nextPoint(by));
                return;
            }
            const double from = data_.cursorX.value_or(data_.presentX.value_or(scale.value(0.5)));
            moveCursorTo(scale.value(std::clamp(scale.fraction(from) + 0.01 * by, 0.0, 1.0)));
            return;
        }
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (pickable_ && data_.cursorX) {
                Q_EMIT picked(*data_.cursorX);
                return;
            }
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

void PlotView::resizeEvent(QResizeEvent* /*event*/) {
    chartStale_ = true;
    layoutHeader();
}

void PlotView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LocaleChange) {
        chartChanged();
    }
    QWidget::changeEvent(event);
}

void resetAllZoom(QWidget* page) {
    for (PlotView* plot : page->findChildren<PlotView*>()) {
        plot->resetZoom();
    }
}

}  // namespace ravnoves
