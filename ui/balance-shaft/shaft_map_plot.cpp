#include "balance-shaft/shaft_map_plot.h"

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/mechanism.h"
#include "balance-shaft/model/shaft_map_text.h"
#include "balance-shaft/shaft_map_signs.h"
#include "numerics/constants.h"
#include "numerics/units.h"
#include "plot/model/disc.h"
#include "plot/picture_file.h"
#include "plot/plot_painter.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using balance_shaft::FrontView;

namespace {

constexpr double handleRadius = 6.5;
constexpr double swatch = 20.0;

QString levelText(double fraction) {
    const double percent = 100.0 * fraction;
    // Levels are round numbers: as many digits as they have.
    QString text = QLocale().toString(std::abs(percent), 'g', 4);
    if (percent < 0.0) {
        text.prepend(QChar(0x2212));
    } else if (percent > 0.0) {
        text.prepend(QLatin1Char('+'));
    }
    return text;
}

}  // namespace

ShaftMapPlot::ShaftMapPlot(BalanceShaftModel* model, ShaftMapModel* map, QWidget* parent)
    : PlotView(QString(), parent), model_(model), map_(map) {
    setObjectName(QStringLiteral("shaft_map"));
    setEqualScale(true);
    setYAxis(Side::Left, {tr("y, mm")});
    setToolTip(
        tr("The engine from the front, to scale. Drag the shaft's axis, or move it by the arrow "
           "keys: 0.1 mm, with Shift 1 mm. A double click goes to a place; Page up and Page down "
           "choose a marker, Enter goes there. Where it is hatched the shaft cannot be built."));
    connect(map_, &ShaftMapModel::mapChanged, this, &ShaftMapPlot::showMap);
    connect(map_, &ShaftMapModel::staleChanged, this, [this] {
        standingStale_ = true;
        setFaded(map_->isStale());
    });
    setPaintsGhosts();
    connect(this, &PlotView::referenceChanged, this, &ShaftMapPlot::followReference);
    connect(map_, &ShaftMapModel::moved, this, qOverload<>(&QWidget::update));
    connect(model_, &BalanceShaftModel::crankAngleChanged, this, [this] {
        standingStale_ = true;
        update();
    });
    connect(&Theme::instance(), &Theme::changed, this, &ShaftMapPlot::showImage);
    showMap();
}

QPointF ShaftMapPlot::pixelOf(const ShaftMapModel::Position& position) const {
    return toPixel(position.x / units::mm, position.y / units::mm);
}

ShaftMapModel::Position ShaftMapPlot::placeAt(const QPointF& pixel) const {
    return {xAt(pixel.x()) * units::mm, yAt(pixel.y()) * units::mm};
}

QPolygonF ShaftMapPlot::pixels(const QPolygonF& metres) const {
    QPolygonF line;
    line.reserve(metres.size());
    for (const QPointF& point : metres) {
        line << pixelOf({point.x(), point.y()});
    }
    return line;
}

QString ShaftMapPlot::csv(const CsvFormat& format) const {
    return shaft_map_text::fieldCsv(*map_, format);
}

void ShaftMapPlot::showMap() {
    switch (map_->criterion()) {
        case ShaftMapModel::Criterion::Range:
            setTitle(tr("Range against no shaft, %"));
            break;
        case ShaftMapModel::Criterion::Rms:
            setTitle(tr("RMS against no shaft, %"));
            break;
        case ShaftMapModel::Criterion::Both:
            setTitle(tr("Weighted sum against no shaft, %"));
            break;
    }
    chosen_.reset();
    leadReference();
    const ShaftMap* map = map_->map();
    const double view = map != nullptr ? map->view / units::mm : 100.0;
    if (view != view_) {
        view_ = view;
        setXAxis({tr("x, mm"), -view, view});
        setYRange(Side::Left, -view, view);
    }
    showImage();
}

void ShaftMapPlot::showImage() {
    const ShaftMap* map = map_->map();
    if (map == nullptr || map_->changes().empty()) {
        setImage({}, {});
        return;
    }
    const balance_shaft::PositionMap& field = map->field;
    setImage(
        fieldImage(field, map_->changes(), map_->levels()),
        QRectF(field.left / units::mm, field.bottom / units::mm,
               (field.right - field.left) / units::mm, (field.top - field.bottom) / units::mm));
}

// The reference.

const ShaftMapModel* ShaftMapPlot::referenceMap() const {
    const auto* other = qobject_cast<const ShaftMapPlot*>(reference());
    return other != nullptr && data().referenceShown ? other->map_ : nullptr;
}

void ShaftMapPlot::followReference() {
    disconnect(followed_);
    if (const auto* other = qobject_cast<const ShaftMapPlot*>(reference())) {
        followed_ = connect(other->map_, &ShaftMapModel::mapChanged, this,
                            &ShaftMapPlot::referenceMapChanged);
    }
    leadReference();
    Q_EMIT referenceMapChanged();
}

void ShaftMapPlot::leadReference() {
    if (const auto* other = qobject_cast<const ShaftMapPlot*>(reference())) {
        other->map_->setCriterion(map_->criterion());
        other->map_->setWeight(map_->weight());
    }
}

QString ShaftMapPlot::placeWords(const ShaftMapModel::Position& position, int decimals) const {
    const ShaftMapModel* other = referenceMap();
    const QString against = other != nullptr ? shaft_map_text::placeAgainst(
                                                   *map_, *other, data().referenceName, position)
                                             : QString();
    return shaft_map_text::place(*map_, position, decimals) +
           (against.isEmpty() ? QString() : QLatin1Char('\n') + against);
}

QString ShaftMapPlot::markerWords(const ShaftMapModel::Marker& marker) const {
    return marker.worst ? shaft_map_text::marker(*map_, marker) : placeWords(marker.position);
}

QString ShaftMapPlot::bestWords() const {
    const ShaftMapModel* other = referenceMap();
    const QString against = other != nullptr
                                ? shaft_map_text::bestAgainst(*map_, *other, data().referenceName)
                                : QString();
    return shaft_map_text::best(*map_) +
           (against.isEmpty() ? QString() : QLatin1Char('\n') + against);
}

void ShaftMapPlot::paintReference(QPainter& painter) const {
    const ShaftMapModel* other = referenceMap();
    if (other == nullptr || other->map() == nullptr) {
        return;
    }
    // Wide and pale, as ghosts of curves are.
    const Theme& theme = Theme::instance();
    const auto wide = [&](double alpha, double width) {
        return QPen(faint(theme.text(), alpha), strokeScale() * width, Qt::SolidLine, Qt::FlatCap,
                    Qt::BevelJoin);
    };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(wide(0.18, 4.0));
    for (const QPolygonF& line : other->map()->blocked) {
        painter.drawPolygon(pixels(line));
    }
    painter.setPen(wide(0.34, 6.0));
    for (const ShaftMapModel::Contour& contour : other->contours()) {
        for (const QPolygonF& line : contour.lines) {
            if (contour.level == 0.0) {
                painter.drawPolyline(pixels(line));
            }
        }
    }
    for (const ShaftMapModel::Marker& marker : other->markers()) {
        if (marker.criterion == map_->criterion()) {
            const QPainterPath shape =
                glyph(pixelOf(marker.position), marker, 1.25 * glyphRadius());
            painter.setPen(wide(0.34, 4.0));
            painter.drawPath(shape);
            painter.setPen(QPen(theme.panel(), 1.4 * strokeScale()));
            painter.drawPath(shape);
        }
    }
}

// The key.

bool ShaftMapPlot::isLow() const {
    constexpr int enough = 290;  // pixels for the key beside the map
    return height() < Theme::withText(enough);
}

std::vector<ShaftMapPlot::KeyEntry> ShaftMapPlot::keyEntries() const {
    std::vector<KeyEntry> entries;
    if (isLow()) {
        return entries;  // the map needs the room: its tip says it
    }
    const Theme& theme = Theme::instance();
    if (!map_->levels().empty()) {
        entries.push_back(
            {tr("0 %: no change"), [&theme](QPainter& painter, const QPointF& middle) {
                 painter.setPen(QPen(theme.text(), 2.4));
                 painter.drawLine(middle - QPointF(9, 0), middle + QPointF(9, 0));
             }});
    }
    entries.push_back({tr("shaft, and its l"), [&theme](QPainter& painter, const QPointF& middle) {
                           painter.setPen(QPen(theme.accent(), 1.4, Qt::DashLine));
                           painter.drawLine(middle - QPointF(9, 0), middle + QPointF(9, 0));
                           painter.setPen(QPen(theme.panel(), 1.0));
                           painter.setBrush(theme.accent());
                           painter.drawEllipse(middle, 4.0, 4.0);
                       }});
    if (map_->map() != nullptr && !map_->map()->blocked.empty()) {
        entries.push_back(
            {tr("cannot be built"), [&theme](QPainter& painter, const QPointF& middle) {
                 const QRectF box(middle - QPointF(8, 5), QSizeF(16, 10));
                 painter.save();
                 painter.setClipRect(box);
                 drawHatch(painter, box);
                 painter.restore();
                 painter.setPen(QPen(faint(theme.text(), 0.6), 1.0));
                 painter.setBrush(Qt::NoBrush);
                 painter.drawRect(box);
             }});
    }
    // One sign for each criterion, and one for what cannot be built.
    const auto& markers = map_->markers();
    const auto addSign = [&](const QString& text, const ShaftMapModel::Marker& marker) {
        entries.push_back({text, [marker](QPainter& painter, const QPointF& middle) {
                               drawGlyph(painter, middle, marker);
                           }});
    };
    const ShaftMapModel::Marker* hollow = nullptr;
    for (auto marker = markers.begin(); marker != markers.end(); ++marker) {
        if (marker == markers.begin() || std::prev(marker)->criterion != marker->criterion ||
            marker->worst) {
            addSign(marker->name, *marker);
        } else if (hollow == nullptr) {
            hollow = &*marker;
        }
    }
    if (hollow != nullptr) {
        addSign(tr("best of all"), *hollow);
    }
    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    const double row = std::ceil(metrics.height()) + 3.0;
    double x = Theme::margin;
    double y = map_->levels().empty() ? 0.0 : colourBarHeight() + row + 2.0;
    for (KeyEntry& entry : entries) {
        const double wide = swatch + 4.0 + metrics.horizontalAdvance(entry.text) + 12.0;
        if (x + wide > width() - Theme::space && x > Theme::margin) {
            x = Theme::margin;
            y += row;
        }
        entry.rect = QRectF(x, y, wide, row);
        x += wide;
    }
    return entries;
}

double ShaftMapPlot::keyHeight() const {
    const std::vector<KeyEntry> entries = keyEntries();
    const double bar =
        map_->levels().empty()
            ? 0.0
            : colourBarHeight() + QFontMetricsF(Theme::font(Theme::smallSize)).height() + 4.0;
    return entries.empty() ? bar : entries.back().rect.bottom() + 2.0;
}

QString ShaftMapPlot::signsInWords() const {
    QStringList signs;
    for (const ShaftMapModel::Marker& marker : map_->markers()) {
        const QString name =
            (marker.worst                                          ? QStringLiteral("■ ")
             : marker.criterion == ShaftMapModel::Criterion::Range ? QStringLiteral("◆ ")
             : marker.criterion == ShaftMapModel::Criterion::Rms   ? QStringLiteral("● ")
                                                                   : QStringLiteral("▲ ")) +
            marker.name;
        if (marker.isBuildable && !signs.contains(name)) {
            signs << name;
        }
    }
    return signs.join(QStringLiteral(", "));
}

void ShaftMapPlot::paintKey(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const double top = keyTop();
    const std::vector<double>& levels = map_->levels();
    painter.setFont(Theme::font(Theme::smallSize));
    if (!levels.empty()) {
        const std::vector<QRgb> colours = bandColours(levels);
        const double whole = std::min(width() - 2.0 * Theme::margin, longestColourBar());
        const double each = whole / static_cast<double>(colours.size());
        const QRectF bar(Theme::margin, top, whole, colourBarHeight());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            painter.fillRect(QRectF(bar.left() + each * static_cast<double>(i), top, each + 0.5,
                                    colourBarHeight()),
                             QColor(colours[i]));
        }
        painter.setPen(QPen(theme.border(), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(bar);
        const QFontMetricsF metrics(painter.font());
        const double row = std::ceil(metrics.height()) + 1.0;
        std::vector<QRectF> taken;
        // No change first: its number stands in any case.
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < levels.size(); ++i) {
            levels[i] == 0.0 ? order.insert(order.begin(), i) : order.insert(order.end(), i);
        }
        for (const std::size_t i : order) {
            const double x = bar.left() + each * static_cast<double>(i + 1);
            const bool zero = levels[i] == 0.0;
            painter.setPen(QPen(theme.text(), zero ? 2.4 : 1.0));
            painter.drawLine(QPointF(x, zero ? top - 1.0 : bar.bottom() - 3.0),
                             QPointF(x, bar.bottom() + (zero ? 2.0 : 1.0)));
            const QString text = levelText(levels[i]);
            const double wide = metrics.horizontalAdvance(text) + metrics.averageCharWidth() + 6.0;
            const QRectF box(x - wide / 2.0, bar.bottom() + 1.0, wide, row);
            if (std::none_of(taken.begin(), taken.end(),
                             [&](const QRectF& other) { return other.intersects(box); })) {
                taken.push_back(box);
                painter.drawText(box, Qt::AlignCenter, text);
            }
        }
    }
    for (const KeyEntry& entry : keyEntries()) {
        const QRectF rect = entry.rect.translated(0.0, top);
        entry.draw(painter, QPointF(rect.left() + swatch / 2.0, rect.center().y()));
        painter.setPen(theme.text());
        painter.drawText(rect.adjusted(swatch + 4.0, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         entry.text);
    }
}

// What rests.

void ShaftMapPlot::paintGround(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    paintKey(painter);
    labels_.clear();
    standingStale_ = true;
    if (map_->map() == nullptr) {
        return;
    }
    painter.save();
    painter.setClipRect(plotArea());
    paintBlocked(painter);
    paintReference(painter);
    labelMarkers();  // first: the contours' numbers give way to theirs
    paintContours(painter);
    paintMarkers(painter);
    painter.restore();
}

std::vector<QPointF> ShaftMapPlot::signPlaces() const {
    const auto& markers = map_->markers();
    std::vector<QPointF> places;
    places.reserve(markers.size());
    for (const ShaftMapModel::Marker& marker : markers) {
        places.push_back(pixelOf(marker.position));
    }
    const double apart = 2.7 * glyphRadius();
    const QRectF inside = plotArea().adjusted(apart, apart, -apart, -apart);
    constexpr int rounds = 40;  // what is left then may touch
    bool moved = inside.isValid();
    for (int round = 0; round < rounds && moved; ++round) {
        moved = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t other = i + 1; other < places.size(); ++other) {
                QPointF way = places[other] - places[i];
                const double distance = std::hypot(way.x(), way.y());
                constexpr double same = 0.5;
                if (distance >= apart - same || !inside.contains(places[i]) ||
                    !inside.contains(places[other])) {
                    continue;
                }
                way = distance < same ? QPointF(0.0, 1.0) : way / distance;
                places[i] -= 0.5 * (apart - distance) * way;
                places[other] += 0.5 * (apart - distance) * way;
                moved = true;
            }
        }
    }
    return places;
}

void ShaftMapPlot::paintMarkers(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const auto& markers = map_->markers();
    const std::vector<QPointF> places = signPlaces();
    // A sign that stands beside its place has a line to it.
    constexpr double beside = 3.0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const QPointF at = pixelOf(markers[i].position);
        if (const QPointF away = places[i] - at; std::hypot(away.x(), away.y()) > beside) {
            painter.setPen(QPen(theme.panel(), 3.2 * strokeScale()));
            painter.drawLine(at, places[i]);
            painter.setPen(QPen(theme.text(), 1.2 * strokeScale()));
            painter.drawLine(at, places[i]);
            painter.setPen(QPen(theme.panel(), 1.0));
            painter.setBrush(theme.text());
            painter.drawEllipse(at, 2.6 * strokeScale(), 2.6 * strokeScale());
        }
    }
    // Those of the criterion shown lie on top.
    for (const bool shown : {false, true}) {
        for (std::size_t i = 0; i < markers.size(); ++i) {
            if ((markers[i].criterion == map_->criterion()) == shown) {
                drawGlyph(painter, places[i], markers[i]);
            }
        }
    }
}

void ShaftMapPlot::paintBlocked(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    QPainterPath path;
    for (const QPolygonF& line : map_->map()->blocked) {
        path.addPolygon(pixels(line));
        path.closeSubpath();
    }
    if (path.isEmpty()) {
        return;
    }
    painter.save();
    painter.fillPath(path, faint(theme.panel(), 0.38));
    painter.setClipPath(path, Qt::IntersectClip);
    drawHatch(painter, plotArea());
    painter.restore();
    painter.setPen(QPen(faint(theme.text(), 0.7), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

bool ShaftMapPlot::addLabel(const QRectF& box, const QString& text, bool isBold) {
    const bool free = std::none_of(labels_.begin(), labels_.end(),
                                   [&](const Label& other) { return other.box.intersects(box); });
    if (!free || !plotArea().adjusted(2, 2, -2, -2).contains(box)) {
        return false;
    }
    labels_.push_back({box, text, isBold});
    return true;
}

void ShaftMapPlot::paintLabels(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    if (isFaded()) {
        // The numbers are old; that newer ones come stands where they do not meet the drawing.
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(theme.text());
        painter.drawText(plotArea().adjusted(Theme::space, Theme::space, -Theme::space, 0),
                         Qt::AlignTop | Qt::AlignRight, tr("computing …"));
        return;
    }
    for (const Label& label : labels_) {
        if (label.text.isEmpty()) {
            continue;  // a marker's own place
        }
        painter.setFont(Theme::font(Theme::smallSize, label.isBold));
        painter.setPen(Qt::NoPen);
        painter.setBrush(faint(theme.panel(), 0.8));
        painter.drawRoundedRect(label.box, 3, 3);
        painter.setPen(theme.text());
        painter.drawText(label.box, Qt::AlignCenter, label.text);
    }
}

void ShaftMapPlot::labelMarkers() {
    const QFontMetricsF metrics(Theme::font(Theme::smallSize, true));
    const std::vector<QPointF> places = signPlaces();
    const double half = glyphRadius() + 3.5;
    for (const QPointF& place : places) {
        labels_.push_back({QRectF(place - QPointF(half, half), 2.0 * QSizeF(half, half)), {}});
    }
    // No number under the handle, as it stands now.
    const double room = handleRadius + 2.0;
    labels_.push_back(
        {QRectF(pixelOf(map_->present()) - QPointF(room, room), QSizeF(2.0 * room, 2.0 * room)),
         {}});
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ShaftMapModel::Marker& marker = map_->markers()[i];
        const auto change = marker.worst ? marker.worst : map_->change(marker.criteria);
        if (!change || marker.criterion != map_->criterion()) {
            continue;
        }
        const QPointF at = places[i];
        const QString text = signedPercentText(*change);
        const QSizeF size(metrics.horizontalAdvance(text) + 6.0, metrics.height());
        const double away = 2.0 * glyphRadius();
        const std::array corners{
            QPointF(away, -size.height() / 2),
            QPointF(-away - size.width(), -size.height() / 2),
            QPointF(-size.width() / 2, -away - size.height()),
            QPointF(-size.width() / 2, away),
            QPointF(away, -size.height() - 2),
            QPointF(away, 2),
        };
        // Any that fits does.
        static_cast<void>(std::any_of(corners.begin(), corners.end(), [&](const QPointF& corner) {
            return addLabel(QRectF(at + corner, size), text, true);
        }));
    }
}

void ShaftMapPlot::paintContours(QPainter& painter) {
    const Theme& theme = Theme::instance();
    const auto& contours = map_->contours();
    std::vector<QPolygonF> longest(contours.size());
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < contours.size(); ++i) {
        const bool zero = contours[i].level == 0.0;
        painter.setPen(zero ? QPen(theme.text(), 2.4) : QPen(faint(theme.text(), 0.38), 1.0));
        for (const QPolygonF& metres : contours[i].lines) {
            const QPolygonF line = pixels(metres);
            painter.drawPolyline(line);
            if (line.size() > longest[i].size()) {
                longest[i] = line;
            }
        }
    }
    labelContours(longest);
}

/// Each line's number where the line is nearest to a ray from the best place, so that the numbers
/// stand in a row; the ray turns on where that has no room.
void ShaftMapPlot::labelContours(const std::vector<QPolygonF>& lines) {
    const auto& contours = map_->contours();
    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    const ShaftMapModel::Marker* best = nullptr;
    for (const ShaftMapModel::Marker& marker : map_->markers()) {
        if (marker.criterion == map_->criterion() && !marker.worst) {
            best = &marker;  // the last is the one of all places
        }
    }
    const QPointF centre = best != nullptr ? pixelOf(best->position) : plotArea().center();
    constexpr std::array turns{90.0, 110.0, 70.0, 130.0, 150.0, 180.0,
                               50.0, 20.0,  0.0,  220.0, 320.0, 270.0};
    // In a small map every second or third line has its number, that of no change in any case.
    const double room =
        plotArea().width() * plotArea().height() / (Theme::withText(120) * Theme::withText(80));
    const auto most = static_cast<std::size_t>(std::max(3.0, room));
    const std::size_t each = std::max<std::size_t>(1, (contours.size() + most - 1) / most);
    const auto zero = static_cast<std::size_t>(
        std::find_if(contours.begin(), contours.end(),
                     [](const auto& contour) { return contour.level == 0.0; }) -
        contours.begin());
    for (std::size_t i = 0; i < contours.size(); ++i) {
        if (i % each != zero % each) {
            continue;
        }
        const QString text = withUnit(levelText(contours[i].level), unitText("%"));
        const QSizeF size(metrics.horizontalAdvance(text) + 6.0, metrics.height() - 1.0);
        static_cast<void>(std::any_of(turns.begin(), turns.end(), [&](double turn) {
            const QPointF ray(std::cos(turn * degree), std::sin(turn * degree));
            double nearest = 0.98;  // cosine to the ray
            std::optional<QPointF> at;
            for (const QPointF& point : lines[i]) {
                const QPointF to = point - centre;
                const double along = QPointF::dotProduct(to, ray) / std::hypot(to.x(), to.y());
                if (along > nearest) {
                    nearest = along;
                    at = point;
                }
            }
            return at && addLabel(QRectF(*at - QPointF(size.width(), size.height()) / 2.0, size),
                                  text, contours[i].level == 0.0);
        }));
    }
}

// What moves.

void ShaftMapPlot::paintTop(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plotArea();
    painter.save();
    painter.setClipRect(area);
    // An exported picture has pixels of its own, or none.
    if (painter.device() != this || drawsForFile(painter, *this)) {
        paintMechanism(painter);
        paintLabels(painter);
    } else {
        if (const QSizeF pixels = area.size() * devicePixelRatioF();
            standingStale_ || standing_.size() != pixels.toSize()) {
            standing_ = QPixmap(pixels.toSize());
            standing_.setDevicePixelRatio(devicePixelRatioF());
            standing_.fill(Qt::transparent);
            QPainter standing(&standing_);
            standing.setRenderHint(QPainter::Antialiasing);
            standing.translate(-area.topLeft());
            paintMechanism(standing);
            paintLabels(standing);
            standingStale_ = false;
        }
        painter.drawPixmap(area.topLeft(), standing_);
    }
    paintShaft(painter);
    if (chosen_ && *chosen_ < map_->markers().size()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(Theme::instance().accent(), 2.0));
        painter.drawEllipse(signPlaces()[*chosen_], 12.0 * strokeScale(), 12.0 * strokeScale());
    }
    painter.restore();
}

void ShaftMapPlot::paintMechanism(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const FrontView& sizes = model_->solver().front_view();
    const auto pose = balance_shaft::mechanism_pose(
        model_->solver(), model_->crankAngleDeg() * degree, model_->input().shaft_angle);
    const double k = (toPixel(1.0, 0.0).x() - toPixel(0.0, 0.0).x()) / units::mm.to_si;
    const auto at = [this](double x, double y) { return pixelOf({x, y}); };
    const QColor line = faint(theme.text(), 0.75);
    const QColor metal = faint(drawing::metal(), 0.72);
    const QPointF crank = at(0, 0);
    const QPointF pin = at(pose.crankpin.x, pose.crankpin.y);
    const QPointF piston = at(pose.piston_pin.x, pose.piston_pin.y);

    const double e = sizes.offset;
    const double bore = sizes.cylinder_bore;
    const double wall = std::max(sizes.cylinder_wall, 2.0 / k);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(metal);
    for (const double side : {-1.0, 1.0}) {
        painter.drawRect(QRectF(at(e + side * bore / 2, sizes.cylinder_top),
                                at(e + side * (bore / 2 + wall), sizes.cylinder_bottom))
                             .normalized());
    }
    const double height = 0.75 * bore;
    const double top = std::min(pose.piston_pin.y + 0.45 * height, sizes.cylinder_top);
    painter.setBrush(faint(drawing::brightMetal(), 0.72));
    painter.drawRoundedRect(QRectF(at(e - bore / 2, top), at(e + bore / 2, top - height)), 3, 3);
    painter.setPen(QPen(line, 1.0, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(crank, sizes.crank_swing_radius * k, sizes.crank_swing_radius * k);
    const double thick = std::clamp(0.3 * sizes.crank_radius * k, 4.0, 14.0);
    drawing::drawBar(painter, pin, piston, 0.6 * thick, metal, line);
    drawing::drawBar(painter, crank, pin, thick, metal, line);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(theme.panel());
    for (const QPointF& joint : {crank, pin, piston}) {
        painter.drawEllipse(joint, 0.24 * thick + 1.5, 0.24 * thick + 1.5);
    }
}

void ShaftMapPlot::paintShaft(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const FrontView& sizes = model_->solver().front_view();
    const auto present = map_->present();
    const double k = (toPixel(1.0, 0.0).x() - toPixel(0.0, 0.0).x()) / units::mm.to_si;
    const QPointF crank = pixelOf({0.0, 0.0});
    const QPointF axis = pixelOf(present);
    const bool canBeBuilt =
        map_->map() != nullptr ? map_->isBuildable(present) : model_->result().is_buildable;
    const QColor colour = canBeBuilt ? theme.accent() : theme.error();
    painter.setBrush(Qt::NoBrush);
    if (const ShaftMapModel* other = referenceMap()) {
        const auto was = other->present();
        painter.setPen(QPen(faint(theme.text(), 0.55), 1.2));
        drawDashedCircle(painter, crank, was.centre_distance() * k);
        paintDisc(painter, pixelOf(was), handleRadius);
    }
    painter.setPen(QPen(theme.accent(), 1.4));
    drawDashedCircle(painter, crank, present.centre_distance() * k);
    painter.setPen(QPen(faint(theme.text(), 0.6), 1.0, Qt::DashDotLine));
    painter.drawLine(crank, axis);
    const double swing = sizes.shaft_swing_radius * k;
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(faint(colour, 0.1));
    paintDisc(painter, axis, swing);
    painter.setPen(QPen(theme.panel(), 1.6));
    painter.setBrush(colour);
    paintDisc(painter, axis, handleRadius);
    if (!dragging_) {
        return;
    }
    painter.setFont(Theme::font(Theme::smallSize, true));
    const ShaftMap* map = map_->map();
    const auto change = map != nullptr ? map_->change(map->study.at(present)) : std::nullopt;
    if (change) {
        const QString text = signedPercentText(*change, 2);
        const QFontMetricsF metrics(painter.font());
        const QSizeF size(metrics.horizontalAdvance(text) + 12.0, metrics.height() + 4.0);
        QRectF box(axis + QPointF(12.0, -8.0 - size.height()), size);
        if (box.right() > plotArea().right()) {
            box.moveRight(axis.x() - 12.0);
        }
        box.moveTop(std::max(box.top(), plotArea().top() + 2.0));
        painter.setPen(QPen(theme.border(), 1.0));
        painter.setBrush(faint(theme.panel(), 0.93));
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(theme.text());
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

}  // namespace ravnoves
