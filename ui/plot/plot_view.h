#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class QChart;
class QGraphicsScene;

namespace ravnoves {

class LegendItem;

/// One chart: a title, a legend whose entries switch curves, curves over a common x axis with one
/// or two y axes, marks, a line at the present value, and a cursor that reads the curves.
///
/// Wraps Qt Charts, so that no page knows it. Axes and grid are drawn once into a picture and
/// redrawn only when range, size or theme change, the curves into a second one over it; marks,
/// present value and cursor are painted on top, so moving them costs next to nothing. Curves are
/// thinned to what a pixel can show.
///
/// Mouse: wheel zooms about the pointer (with Shift only y, with Ctrl only x), left drag pans,
/// double click resets. In a pickable plot a left click or drag picks x instead, and the middle
/// button pans. Keys: + and − zoom, arrows move the cursor, 0 or Home resets.
class PlotView : public QWidget {
    Q_OBJECT

  public:
    enum class Side { Left, Right };
    enum class Shape {
        Line,
        Points,
        LineAndPoints,
        Rings,  ///< hollow points
        Bars,   ///< from 0 to the value; barWidth and barShift in units of x
    };

    struct CurveStyle {
        QString name;            ///< in the legend and the readout
        int colour = 0;          ///< number of Theme::curve()
        Side side = Side::Left;  ///< which y axis
        qreal width = 1.6;       ///< pen width, pixels
        Qt::PenStyle pen = Qt::SolidLine;
        Shape shape = Shape::Line;
        bool shown = true;
        bool inLegend = true;
        QString toolTip = {};
        double barWidth = 0.8;
        double barShift = 0.0;  ///< of the bar's middle, so that groups stand side by side
        bool gaps = false;      ///< the line is broken where a point is not finite
    };

    /// A scale that is neither linear nor logarithmic: where values stand on it, and what stands
    /// at a place; both increase.
    struct Scale {
        std::function<double(double value)> place = {};
        std::function<double(double place)> value = {};
        std::vector<double> ticks = {};  ///< values that may get a label, the weightiest first
    };

    struct Axis {
        QString title;     ///< with the unit: "φ, °"
        double min = 0.0;  ///< ignored for y axes, which follow the data
        double max = 1.0;
        bool degrees = false;  ///< ticks at 15, 30, 45, 90, …
        bool logarithmic = false;
        Scale scale = {};  ///< of its own; linear or logarithmic where empty
        /// Text of ticks and of values read out, for a logarithmic axis or one with a scale of its
        /// own; powers of ten where empty.
        std::function<QString(double)> label = {};
    };

    /// A point worth seeing, with a label.
    struct Mark {
        double x = 0.0;
        double y = 0.0;
        QString text;
        int colour = 0;
        Side side = Side::Left;
        bool ring = false;  ///< a ring instead of a dot
    };

    /// A shaded stretch of x (horizontal) or of the left axis (vertical).
    struct Band {
        double from = 0.0;
        double to = 0.0;
        QColor colour;  ///< with alpha
        QString text = {};
        Qt::Orientation orientation = Qt::Horizontal;
    };

    /// A straight line across the plot.
    struct Line {
        static constexpr int muted = -1;  ///< a colour that is no curve's
        double at = 0.0;
        Qt::Orientation orientation = Qt::Horizontal;
        int colour = 0;
        QString text = {};
        Side side = Side::Left;
    };

    explicit PlotView(const QString& title, QWidget* parent = nullptr);
    ~PlotView() override;

    void setTitle(const QString& title);
    void setXAxis(const Axis& axis);
    void setYAxis(Side side, const Axis& axis);
    /// Keeps a y axis at this interval, with a little room, until it is changed or zoomed.
    void setYRange(Side side, double min, double max);
    /// The y axis follows the data again, with hysteresis.
    void followData(Side side);
    /// One unit is the same length on both axes (shapes, hodographs).
    void setEqualScale(bool equal);

    /// @return the curve's number
    int addCurve(const CurveStyle& style);
    /// Replaces the curve's data. Points that are not finite are left out. Closed shapes may have x
    /// in any order; the cursor then reads the nearest point.
    void setCurve(int curve, std::vector<double> x, std::vector<double> y);
    void setCurveStyle(int curve, const CurveStyle& style);
    void setCurveShown(int curve, bool shown);
    bool isCurveShown(int curve) const;
    /// Its name in the legend; a curve without a name has no entry there.
    QString curveName(int curve) const;
    int curveCount() const;
    /// Error bars from low to high at each point of the curve, in y (vertical) or in x
    /// (horizontal); empty lists remove them.
    void setErrorBars(int curve, std::vector<double> low, std::vector<double> high,
                      Qt::Orientation orientation = Qt::Vertical);
    /// What is read out of each point of the curve, as lines of text. In a plot with such texts the
    /// mouse and the arrow keys read points instead of the curves at an x.
    void setPointTexts(int curve, QStringList texts);

    /// A picture under the curves that fills a rectangle of values (a map over x and y); a null
    /// image removes it. Row 0 of the image is the top.
    void setImage(const QImage& image, const QRectF& values);
    void setMarks(std::vector<Mark> marks);
    void setBands(std::vector<Band> bands);
    void setLines(std::vector<Line> lines);
    /// The present value of what the x axis shows: a line through the plot with a dot on each
    /// curve; nothing removes it.
    void setPresentX(std::optional<double> x);
    QString title() const { return title_; }
    /// Pales what is drawn, because newer data are on the way, and says so in the middle.
    void setFaded(bool faded, const QString& text = {});
    bool isFaded() const { return faded_; }
    /// The cursor at x, as if the mouse were there; nothing removes it.
    void setCursorX(std::optional<double> x);
    /// A click or drag picks x (picked()) instead of panning.
    void setPickable(bool pickable);
    /// Text of a readout value: decimals after the point. Default: three significant digits more
    /// than the tick labels.
    void setReadoutDecimals(int decimals) { readoutDecimals_ = decimals; }

    void resetZoom();
    bool isZoomed() const { return zoomed_; }
    /// The chart's inner rectangle in this widget, and the mapping of values to it.
    QRectF plotArea() const;
    QPointF toPixel(double x, double y, Side side = Side::Left) const;
    double xAt(double pixelX) const;
    double yAt(double pixelY, Side side = Side::Left) const;
    /// The interval shown now.
    std::pair<double, double> xInterval() const;
    std::pair<double, double> yInterval(Side side) const;

    /// The value of a curve at x by linear interpolation; nothing outside its data.
    std::optional<double> valueAt(int curve, double x) const;
    /// The data of the shown curves as CSV text: x, then one column per curve.
    QString dataAsCsv() const;
    /// Draws title, legend, chart and marks onto any device; used for pictures, SVG and print.
    void renderTo(QPainter& painter, const QRectF& target);
    /// Writes a PNG (twice the size on screen) or SVG, by the file's ending.
    /// @return an empty string, or what went wrong
    QString exportPicture(const QString& path);
    /// Writes what `draw` draws as exportPicture() does, for pages that put several plots into one.
    /// @param draw  gets the painter and the pixels that one of the size stands for
    static QString writePicture(const QString& path, const QSize& size, const QString& title,
                                const std::function<void(QPainter&, double)>& draw);

    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

  Q_SIGNALS:
    /// A click or drag in a pickable plot.
    void picked(double x);
    /// The same with the value on the left axis (maps).
    void pickedAt(double x, double y);
    /// The cursor is over x.
    void cursorMoved(double x);
    void cursorLeft();
    /// A curve was switched on or off, by its legend entry or by setCurveShown().
    void curveToggled(int curve, bool shown);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    struct Curve;
    struct AxisState;

    AxisState& axis(Side side);
    const AxisState& axis(Side side) const;
    bool sideUsed(Side side) const;
    void curvesChanged();
    void chartChanged();
    void layoutHeader();
    void paintTitle(QPainter& painter);
    void layoutChart();
    void updateRanges();
    void updateTicks();
    void updateSeries();
    void applyTheme();
    void zoom(double factorX, double factorY, const QPointF& about);
    void pan(const QPointF& pixels);
    void moveCursor(const QPointF& position);
    bool readsPoints() const;
    void readPointNear(const QPointF& position);
    void stepPoint(int by);
    void pick(const QPointF& position);
    void renderAxes(QPainter& painter);
    void renderOwnAxis(QPainter& painter, const AxisState& state, Qt::Edge edge);
    void renderErrorBars(QPainter& painter, const Curve& curve);
    void renderCurves(QPainter& painter);
    void paintOverlay(QPainter& painter);
    void paintMarks(QPainter& painter, const QRectF& area);
    void paintReadout(QPainter& painter, const QRectF& area);
    void paintPointReadout(QPainter& painter, const QRectF& area);
    void paintLines(QPainter& painter, const QRectF& area);
    QString axisNumber(double value, const AxisState& state) const;
    QString readoutNumber(double value, const AxisState& state) const;

    QString title_;
    double headerHeight_ = 0.0;
    std::unique_ptr<QGraphicsScene> scene_;
    QChart* chart_ = nullptr;  // owned by the scene
    std::vector<std::unique_ptr<Curve>> curves_;
    std::unique_ptr<AxisState> x_;
    std::unique_ptr<AxisState> left_;
    std::unique_ptr<AxisState> right_;

    QImage image_;
    QRectF imageValues_;
    std::vector<Mark> marks_;
    std::vector<Band> bands_;
    std::vector<Line> lines_;
    std::optional<double> presentX_;
    std::optional<double> cursorX_;
    std::optional<std::pair<std::size_t, std::size_t>> pointRead_;  ///< curve, point
    bool faded_ = false;
    QString fadedText_;
    bool pickable_ = false;
    bool equalScale_ = false;
    bool zoomed_ = false;
    bool picking_ = false;
    std::optional<QPointF> panFrom_;
    int readoutDecimals_ = -1;

    QPixmap axesPicture_;  ///< title, grid and axes, which rest while the curves move
    QPixmap picture_;      ///< these with the curves
    bool axesStale_ = true;
    bool pictureStale_ = true;
    bool seriesStale_ = true;
};

}  // namespace ravnoves
