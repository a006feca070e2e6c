#include "balance-shaft/speed_map_plot.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/shaft_map_labels.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"

namespace ravnoves {

SpeedMapPlot::SpeedMapPlot(BalanceShaftModel* model, QWidget* parent)
    : PartPlot(model, "speed-map", parent), study_(model->speedStudy()) {
    setPickable(true);
    connect(this, &PlotView::pickedAt, study_, &SpeedStudyModel::pick);
    connect(study_, &SpeedStudyModel::mapChanged, this, &SpeedMapPlot::showMap);
    connect(&Theme::instance(), &Theme::changed, this, &SpeedMapPlot::showMap);
    showMap();
}

void SpeedMapPlot::showMap() {
    setToolTip(map() == nullptr ? QString()
                                : tr("Blue: smaller with the shaft; orange: larger; thick line: no "
                                     "change; shaded: does not fit. Click to set α and, with a "
                                     "computed torque, the speed."));
    setImage(map() == nullptr ? QImage() : changeImage(*map()),
             map() == nullptr ? QRectF() : map()->where);
}

double SpeedMapPlot::keyHeight() const {
    return map() != nullptr ? changeKeyHeight() : 0.0;
}

void SpeedMapPlot::paintGround(QPainter& painter) {
    lines_.clear();
    if (map() == nullptr) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintChangeKey(painter, map()->levels, QPointF(2.0 * Theme::margin, keyTop()),
                   width() - 4.0 * Theme::margin);
    painter.setClipRect(plotArea());
    lines_ = drawContours(painter, *map(), *this);
    painter.restore();
}

void SpeedMapPlot::paintOverCurves(QPainter& painter) {
    if (lines_.empty()) {
        return;
    }
    ShaftMapLabels labels;
    labels.clear(plotArea());
    for (const PlotCurve& curve : data().curves) {
        constexpr double apart = 3.0;  // pixels
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            labels.keepFree(toPixel(curve.x[i], curve.y[i]), apart);
        }
    }
    labels.addContours(*map(), lines_, plotArea().center());
    painter.setRenderHint(QPainter::Antialiasing);
    labels.paint(painter);
}

QString SpeedMapPlot::wordsAt(double angleDeg, double speed) const {
    if (map() == nullptr) {
        return {};
    }
    const double change = study_->changeAt(angleDeg, speed);
    const QLocale locale;
    return tr("α %1°, n %2: %3")
        .arg(fixedNumber(angleDeg, 1, locale), shownNumber(speed * units::rpm, units::rpm, 0),
             (change > 0.0 ? tr("%1 % worse") : tr("%1 % better"))
                 .arg(fixedNumber(100.0 * std::abs(change), 1, locale)));
}

bool SpeedMapPlot::event(QEvent* event) {
    // Over the chart what is under the pointer stays; elsewhere stands how to read the map.
    if (event->type() == QEvent::ToolTip && map() != nullptr &&
        plotArea().contains(static_cast<QHelpEvent*>(event)->pos())) {
        return true;
    }
    return PlotView::event(event);
}

void SpeedMapPlot::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    const QString words = plotArea().contains(at) ? wordsAt(xAt(at.x()), yAt(at.y())) : QString();
    QToolTip::showText(event->globalPosition().toPoint(), words, this);
    if (event->buttons() != Qt::NoButton) {
        PlotView::mouseMoveEvent(event);
    }
}

QString SpeedMapPlot::csv(const CsvFormat& format) const {
    if (map() == nullptr) {
        return {};
    }
    const ShownTitle speed = shownTitle(tr("n, min⁻¹"));
    QString text = format.line({speed.text, tr("α, °"), title()});
    const QRectF& where = map()->where;
    const std::size_t columns = map()->columns;
    const std::size_t rows = map()->changes.size() / columns;
    const auto number = [&format](double from, double span, std::size_t i, std::size_t count) {
        return format.number(from + span * static_cast<double>(i) / static_cast<double>(count - 1));
    };
    for (std::size_t i = 0; i < map()->changes.size(); ++i) {
        text += format.line(
            {number(speed.factor * where.top(), speed.factor * where.height(), i / columns, rows),
             number(where.left(), where.width(), i % columns, columns),
             format.number(100.0 * map()->changes[i])});
    }
    return text;
}

}  // namespace ravnoves
