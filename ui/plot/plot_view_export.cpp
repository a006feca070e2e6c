#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMetaMethod>
#include <QPainter>
#include <utility>

#include "plot/legend_item.h"
#include "plot/picture_file.h"
#include "plot/plot_painter.h"
#include "plot/plot_view.h"
#include "text/csv_format.h"
#include "text/write_file.h"
#include "theme/theme.h"

namespace ravnoves {

void PlotView::drawChart(QPainter& painter) {
    layoutChart();
    const auto cursor = std::exchange(data_.cursorX, std::nullopt);
    const auto point = std::exchange(data_.pointRead, std::nullopt);
    // A present value that goes where the cursor goes is the mouse's, too.
    const auto present = data_.presentX;
    if (isSignalConnected(QMetaMethod::fromSignal(&PlotView::cursorMoved))) {
        data_.presentX.reset();
    }
    painter.fillRect(QRectF(rect()), Theme::instance().panel());
    painter_->paintAxes(painter);
    paintGround(painter);
    painter_->paintCurves(painter);
    painter_->paintOverlay(painter);
    paintTop(painter);
    data_.cursorX = cursor;
    data_.pointRead = point;
    data_.presentX = present;
    pictureStale_ = true;
}

void PlotView::renderTo(QPainter& painter, const QRectF& target) {
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    drawChart(painter);
    for (const LegendItem* item : shownLegend()) {
        if (item != nullptr && item->isChecked() && !item->isHidden()) {
            item->draw(painter, QRectF(item->geometry()));
        }
    }
    painter.restore();
}

QString PlotView::dataAsCsv() const {
    return csv(CsvFormat());
}

QString PlotView::exportPicture(const QString& path, int pixels) {
    const auto draw = [this](QPainter& painter, double scale) {
        renderTo(painter, QRectF(QPointF(), QSizeF(size()) * scale));
    };
    return writePicture(path, size(), data_.title, draw, pixels);
}

QString PlotView::exportTo(const QString& path, int pixels) {
    if (!path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        return exportPicture(path, pixels);
    }
    return writeFile(path, [this] { return csv(CsvFormat(QLocale::c())).toStdString(); });
}

void PlotView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Reset zoom"), this, &PlotView::resetZoom);
    menu.addSeparator();
    menu.addAction(tr("Copy data"), this, [this] {
        CsvFormat cells;
        cells.separator = QLatin1Char('\t');
        QApplication::clipboard()->setText(csv(cells));
    });
    menu.addAction(tr("Copy picture"), this, [this] {
        QImage image(size() * 2, QImage::Format_RGB32);
        QPainter painter(&image);
        renderTo(painter, QRectF(QPointF(), QSizeF(image.size())));
        painter.end();
        QApplication::clipboard()->setImage(image);
    });
    menu.addAction(tr("Save picture or data…"), this, [this] {
        savePictureWithDialog(
            this, tr("Save picture or data"), QStringLiteral("plot.png"), size(), {csvFormat()},
            [this](const QString& path, int pixels) { return exportTo(path, pixels); });
    });
    menu.exec(event->globalPos());
}

}  // namespace ravnoves
