#include <QMetaMethod>
#include <QPainter>
#include <utility>

#include "pictures/figure.h"
#include "plot/legend_item.h"
#include "plot/plot_painter.h"
#include "plot/plot_view.h"
#include "text/csv_format.h"
#include "theme/theme.h"

namespace ravnoves {

QString PlotView::csv(const CsvFormat& format) const {
    return data_.csv(format);
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
    painter_->paintOverlay(painter);
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

}  // namespace ravnoves
