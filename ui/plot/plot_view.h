#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "plot/model/figure.h"

namespace ravnoves {

class LegendItem;
struct CsvFormat;

/// One chart: a title, a legend whose entries switch curves, curves over a common x axis, marks, a
/// line at the present value, and a cursor that reads the curves.
///
/// PlotData has the content, plot_painter.h paints it; this is the widget: legend, layers, mouse
/// and keys. Axes and grid are drawn once into a picture and redrawn only when range, size or theme
/// change, the curves into a second one over it; marks, present value and cursor are painted on
/// top, so moving them is cheap.
///
/// Mouse: wheel zooms about the pointer (with Shift only y, with Ctrl only x), left drag pans,
/// double click resets. In a pickable plot a left click or drag picks x instead, and the middle
/// button pans. Keys: + and − zoom, arrows move the cursor, 0 or Home resets.
class PlotView : public QWidget {
    Q_OBJECT

  public:
    explicit PlotView(QWidget* parent = nullptr);
    ~PlotView() override;

    /// Shows a figure in place of the one before (PlotData::show()).
    void showFigure(const Figure& figure);
    /// Shows under the curves, dimmed, the same figure's curves of another input. Null: none.
    void showReference(const Figure* figure, const QString& name);
    void setCurveShown(int curve, bool shown);
    /// The scatter of the curves, which moves with them; those without one have none any more.
    void setSpreads(const plot::Spreads& spreads);
    void setMarks(std::vector<plot::Mark> marks) { overlay(data_.marks, std::move(marks)); }
    /// The present value of what the x axis shows: a line through the plot with a dot on each
    /// curve; nothing removes it.
    void setPresentX(std::optional<double> x) { overlay(data_.presentX, x, data_.presentX != x); }
    QString title() const { return data_.title; }
    /// What the plot shows, as text, for those who do not see it; made when it is asked for.
    QString sentence() const { return data_.sentence(); }
    /// Dims the drawing, because newer data are being computed, with a text in the middle.
    void setFaded(bool faded, const QString& text = {});
    bool isFaded() const { return data_.faded; }
    /// The cursor at x, as if the mouse were there; nothing removes it.
    void setCursorX(std::optional<double> x) { overlay(data_.cursorX, x, data_.cursorX != x); }
    /// The charts of plots above one another begin and end at the same pixels, because they share
    /// x.
    static void stack(const QList<PlotView*>& plots);
    /// A click or drag picks x (picked()) instead of panning.
    void setPickable(bool pickable);

    /// The content, for tests and for comparisons of plots.
    const PlotData& data() const { return data_; }

    void resetZoom();
    bool isZoomed() const { return data_.zoomed; }
    /// Axes of all plots rest as far as they can, while something is dragged.
    static void setSteady(bool steady) { PlotData::steady = steady; }
    /// Fits the axes to the present content.
    void fitAxes() { curvesChanged(); }
    /// The chart's inner rectangle in this widget, and the mapping of values to it.
    QRectF plotArea() const { return data_.area; }
    QPointF toPixel(double x, double y) const { return data_.toPixel(x, y); }
    double xAt(double pixelX) const { return data_.xAt(pixelX); }
    double yAt(double pixelY) const { return data_.yAt(pixelY); }
    /// The value of a curve at x by linear interpolation; nothing outside its data.
    std::optional<double> valueAt(int curve, double x) const {
        return data_.valueAt(data_.curve(curve), x);
    }
    /// The data of the shown curves as a table (PlotData::csv()).
    virtual QString csv(const CsvFormat& format) const { return data_.csv(format); }
    /// The same as the user's spreadsheet reads it.
    QString dataAsCsv() const;
    /// Draws title, legend, chart and marks onto any device; used for pictures, SVG, PDF and print.
    /// What only follows the mouse is left out.
    void renderTo(QPainter& painter, const QRectF& target);
    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    /// A click or drag in a pickable plot.
    void picked(double x);
    /// The same with the value on the y axis (maps).
    void pickedAt(double x, double y);
    /// The cursor is over x.
    void cursorMoved(double x);

  protected:
    // For a chart that is a drawing, too: what rests is painted over grid and axes into their
    // picture or over the curves into theirs, what moves on top of all; all three also into
    // exported pictures.
    virtual void paintGround(QPainter& /*painter*/) {}
    virtual void paintOverCurves(QPainter& /*painter*/) {}
    virtual void paintTop(QPainter& /*painter*/) {}
    /// A picture under the curves that fills a rectangle of values (a map over x and y); a null
    /// image removes it. Row 0 of the image is the top.
    void setImage(const QImage& image, const QRectF& values);
    /// Repaints the layer over the curves.
    void overCurvesChanged();
    /// The values under the pointer are read out as it moves.
    virtual bool readsUnderPointer() const { return true; }
    /// Height of a key of its own between title and chart, pixels.
    virtual double keyHeight() const { return 0.0; }
    /// The pointer is no longer where it read something.
    virtual void stopReading();
    double keyTop() const { return data_.headerHeight - keyHeight(); }
    /// All but title and legend.
    QRect chartRect() const { return rect().adjusted(0, static_cast<int>(keyTop()), 0, 0); }

    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) final;
    void changeEvent(QEvent* event) override;

  private:
    /// Replaces a part of the top layer.
    template <typename Value>
    void overlay(Value& shown, Value value, bool isNew = true) {
        shown = std::move(value);
        if (isNew) {
            updateChart();
        }
    }
    /// An entry that switches something else than a curve.
    LegendItem* addSwitch(bool& shown, plot::Shape shape);
    /// The entry of a curve, made where it has none yet.
    void dressLegend(std::size_t number);
    QList<LegendItem*> shownLegend() const;
    /// Entries for curves that are there.
    void showLegend();
    /// Repaints the part below title and legend.
    void updateChart();
    void curvesChanged();
    void chartChanged();
    void layoutHeader();
    void layoutChart();
    /// Title, grid and axes, over the ground.
    void paintAxes(QPainter& painter);
    void paintCurves(QPainter& painter);
    void drawChart(QPainter& painter);
    void zoom(double factorX, double factorY, const QPointF& about);
    void moveCursor(const QPointF& position);
    void moveCursorTo(double x);
    /// Its container can be scrolled.
    bool scrollsWithin() const;
    void readPoint(const std::optional<PlotData::Point>& point);
    void pick(const QPointF& position);

    PlotData data_;
    std::vector<LegendItem*> legend_;  ///< one for each curve, or null
    LegendItem* referenceItem_ = nullptr;
    LegendItem* spreadItem_ = nullptr;
    QList<PlotView*> stack_;  ///< those whose charts are aligned with this one
    bool pickable_ = false;
    bool picking_ = false;
    std::optional<double> pickedFrom_;  ///< present value before the last click
    std::optional<QPointF> panFrom_;

    QImage axesPicture_;  ///< title, grid and axes, which rest while the curves move
    QImage picture_;      ///< these with the curves
    bool axesStale_ = true;
    bool pictureStale_ = true;
    bool chartStale_ = true;  ///< is to be laid out again
};

/// Resets the zoom of every plot below a widget.
void resetAllZoom(QWidget* page);

}  // namespace ravnoves
