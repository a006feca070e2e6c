#pragma once

#include <array>
#include <memory>
#include <span>

#include "plot/model/plot_data.h"

class QChart;
class QGraphicsScene;
class QImage;
class QPainter;
class QPen;
class QBrush;
class QValueAxis;

namespace ravnoves {

/// Paints what a plot shows onto any device: grid and linear axes by Qt Charts, all else by hand.
/// What rests (axes), what moves (curves) and what goes on top are painted apart.
class PlotPainter {
  public:
    explicit PlotPainter(PlotData& data);
    ~PlotPainter();

    /// Places everything in a picture of this size below the header: scales, margins, ticks, lines.
    /// @param axesStale  the axes have changed; set where this moves them
    void layout(const QSizeF& size, bool& axesStale);
    /// Title, image, bands, grid, axes, the reference's curves.
    void paintAxes(QPainter& painter);
    void paintCurves(QPainter& painter) const;
    /// The same onto a picture of the screen, RGB32; lines by LineBrush.
    void paintCurves(QImage& picture) const;
    /// Lines, present value, marks, readout.
    void paintOverlay(QPainter& painter) const;

  private:
    struct Row {
        QString text;
        QColor colour;
    };

    void layoutArea();
    void layoutAxes();
    /// @param words  its text instead of its shade
    void paintBand(QPainter& painter, const plot::Band& band) const;
    /// @return where they stand; empty where there is no room for them
    QRectF paintBandWords(QPainter& painter, const plot::Band& band) const;
    QRectF shadeOf(const plot::Band& band) const;
    void paintOwnAxis(QPainter& painter, const PlotScale& scale, Qt::Edge edge) const;
    void paintGhosts(QPainter& painter) const;
    void paintShades(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    void paintBars(QPainter& painter, const PlotCurve& curve, const QPen& pen,
                   const QBrush& brush) const;
    /// What is no line has its spread as bars with caps.
    void paintSpreads(QPainter& painter, const PlotCurve& curve) const;
    void paintErrorBars(QPainter& painter, const PlotCurve& curve) const;
    void paintLines(QPainter& painter) const;
    /// @param taken  where their labels must not stand
    void paintMarks(QPainter& painter, std::vector<QRectF> taken) const;
    void paintReadout(QPainter& painter) const;
    void paintPointReadout(QPainter& painter) const;
    void paintRows(QPainter& painter, const std::vector<Row>& rows, const QPointF& at,
                   const QPointF& away, float opacity) const;
    QPointF pixel(const PlotCurve& curve, std::size_t point) const {
        return data_.toPixel(curve.x[point], curve.y[point], curve.style.side);
    }
    double across(double x) const { return data_.toPixel(x, data_.left.low).x(); }

    PlotData& data_;
    QSizeF size_;
    std::array<double, 10> placed_{};  ///< area and scales of the lines made last
    std::unique_ptr<QGraphicsScene> scene_;
    QChart* chart_;  // owned by the scene
    std::array<QValueAxis*, 3>
        axes_{};  ///< bottom, left, right; owned by the chart, made when used
};

}  // namespace ravnoves
