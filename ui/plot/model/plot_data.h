#pragma once

#include <QImage>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "plot/model/plot_scale.h"
#include "theme/model/role.h"

namespace ravnoves {

struct CsvFormat;
struct Figure;

namespace plot {

enum class Shape {
    Line,
    Points,  ///< the role's markers
    LineAndPoints,
    Rings,  ///< hollow markers
    Bars,   ///< from 0 to the value; barWidth and barShift in units of x
};

struct CurveStyle {
    QString name;               ///< in the legend and the readout
    Role role = Role::Neutral;  ///< its colour, dash and marker
    qreal width = 1.6;          ///< pen width, pixels
    Shape shape = Shape::Line;
    bool shown = true;
    bool inLegend = true;
    QString toolTip = {};
    double barWidth = 0.8;
    double barShift = 0.0;  ///< of the bar's middle, so that groups are side by side
    bool gaps = false;      ///< the line is broken where a point is not finite
    /// Of a vector's path: the angle φ that its points share out evenly, from 0, degrees. The
    /// cursor then reads the nearest point with its φ.
    double turn = 0.0;

    bool operator==(const CurveStyle&) const = default;
};

/// A curve of a figure.
struct Curve {
    std::string id = {};  ///< its word, one of the figure's own, by which a reference has it too
    CurveStyle style = {};
    std::vector<double> x = {};  ///< may be empty
    std::vector<double> y = {};
    /// Where it is drawn out of scale, the places that it represents; else empty.
    std::vector<double> trueX = {};
    std::vector<double> trueY = {};
    /// Reads out a point of the figure, as lines; null: the curve's value.
    std::function<QString(std::size_t point)> text = {};
};

/// A point worth seeing, with a label.
struct Mark {
    double x = 0.0;
    double y = 0.0;
    QString text;
    Role role = Role::Neutral;
    bool ring = false;       ///< a ring instead of a dot
    std::string curve = {};  ///< it is seen with this curve alone; empty: always

    bool operator==(const Mark&) const = default;
};

/// A shaded stretch of x (horizontal) or of y (vertical).
struct Band {
    double from = 0.0;
    double to = 0.0;
    Role role = Role::Limit;
    double strength = 0.12;  ///< of the colour, 0…1
    QString text = {};
    Qt::Orientation orientation = Qt::Horizontal;

    bool operator==(const Band&) const = default;
};

/// Scatter of a curve by the inputs, 5…95 %: amounts below and above each of its points.
struct Spread {
    std::vector<double> below = {};
    std::vector<double> above = {};
};
/// Of the curves with these words.
using Spreads = std::map<std::string, Spread>;

/// A straight line across the plot.
struct Line {
    double at = 0.0;
    Qt::Orientation orientation = Qt::Horizontal;
    Role role = Role::Neutral;
    QString text = {};
    bool keptAtEdge = false;  ///< beyond the shown range: its text at the edge, with its value

    bool operator==(const Line&) const = default;
};

}  // namespace plot

/// A drawn curve: the points that have a place, and how they hang together.
struct PlotCurve : plot::Curve {
    std::vector<std::size_t> starts = {};  ///< points that do not hang together with the one before
    std::vector<std::size_t> places = {};  ///< of the points among those that the figure has
    std::vector<double> below = {};        ///< of the spread, from each point; or none
    std::vector<double> above = {};
    bool ascending = true;  ///< x never decreases, so the cursor may interpolate
    bool shown = true;
    bool inFigure = true;                   ///< else of one that was shown before
    bool stale = true;                      ///< `stretches` are of other data
    std::vector<QPolygonF> stretches = {};  ///< the line as drawn, thinned, in pixels
    std::vector<QPolygonF> shades = {};     ///< its spread, likewise

    /// Takes the points that have a place on both axes.
    /// @return whether that changed anything
    bool set(std::vector<double> newX, std::vector<double> newY, const PlotScale& xScale,
             const PlotScale& yScale);
    bool isLine() const {
        return style.shape == plot::Shape::Line || style.shape == plot::Shape::LineAndPoints;
    }
    Qt::PenStyle pen() const { return lookOf(style.role).pen; }
    bool hasSpread() const { return !below.empty() && below.size() == x.size(); }
    bool isReadable() const { return shown && (style.turn > 0.0 || text); }
    /// φ of a point, degrees.
    double angleOf(std::size_t point) const {
        return style.turn * static_cast<double>(point) /
               static_cast<double>(std::max<std::size_t>(x.size(), 2) - 1);
    }
};

/// What a plot shows, without a window: curves, scales, marks, and where they are in a rectangle
/// of pixels.
struct PlotData {
    /// A curve and one of its points.
    using Point = std::pair<std::size_t, std::size_t>;

    QString title = {};
    QLocale locale = {};
    std::vector<PlotCurve> curves = {};
    PlotScale x = {};
    PlotScale left = {};                 ///< the y axis
    QSizeF size = {};                    ///< of the picture, pixels
    QRectF area = {};                    ///< the chart's inner rectangle
    double headerHeight = 0.0;           ///< title and legend
    std::array<double, 10> placed = {};  ///< sizes and scales of the lines made last
    bool equalScale = false;             ///< one unit is the same length on both axes
    bool zoomed = false;                 ///< the scales are the user's
    static inline bool steady = false;   ///< something is dragged: scales of all plots rest

    QImage image = {};
    QRectF imageValues = {};
    std::vector<plot::Mark> marks = {};
    std::vector<plot::Band> bands = {};
    std::vector<plot::Line> lines = {};
    std::optional<double> presentX = {};
    QString xName = {};  ///< of a scale without a title, as over another plot's
    std::optional<double> cursorX = {};
    std::optional<Point> pointRead = {};
    bool faded = false;
    bool spreadShown = true;
    QString fadedText = {};
    /// The same plot of a reference; each curve is under the one of the same word.
    std::shared_ptr<PlotData> reference = {};
    QString referenceName = {};
    bool referenceShown = true;

    /// The layer to be painted again.
    enum class Change { None, Top, Curves, Chart };
    /// Shows a figure in place of the one before, curve by curve of the same word. What the user
    /// has done stays: zoom, and which curves are switched off.
    Change show(const Figure& figure);

    PlotCurve& curve(int number) { return curves.at(static_cast<std::size_t>(number)); }
    const PlotCurve& curve(int number) const { return curves.at(static_cast<std::size_t>(number)); }
    /// The place of the curve with this word; empty without one.
    std::optional<std::size_t> find(std::string_view id) const;
    /// The same curve of the reference; null where it has none.
    const PlotCurve* curveOfReference(const PlotCurve& curve) const;
    /// The same where it is seen.
    const PlotCurve* ghostOf(const PlotCurve& curve) const;
    bool hasGhosts() const;
    /// A curve that is shown with its spread.
    bool showsSpread(const PlotCurve& curve) const {
        return spreadShown && curve.shown && curve.hasSpread();
    }
    bool hasSpread() const;
    /// Dashed over a wider curve that it may coincide with.
    bool liesOnAnother(const PlotCurve& curve) const;

    QPointF toPixel(double valueX, double valueY) const;
    QPointF pixelOf(const PlotCurve& curve, std::size_t point) const {
        return toPixel(curve.x[point], curve.y[point]);
    }
    double across(double value) const { return toPixel(value, left.low).x(); }
    double xAt(double pixelX) const;
    double yAt(double pixelY) const;

    /// The scales follow the data, unless the user has zoomed.
    void fitScales();
    /// Shrinks the rectangle of an equal scale to its contents: data or the whole image.
    void endWithData();
    /// Widens the axis with room to spare until one unit is as long on both; from the zoomed
    /// section, whatever the sizes of the plot have been since.
    void equalise();
    /// Zooms about a pixel.
    void zoom(double factorX, double factorY, const QPointF& about);
    void pan(const QPointF& pixels);
    void makeStale();
    /// Makes the lines of stale curves again: in pixels, without points that move no pixel.
    void thinCurves();
    /// The same of any curve, by this plot's scales.
    std::vector<QPolygonF> stretchesOf(const PlotCurve& curve) const;
    /// The ends of a curve's spread at one of its points, within the scale.
    std::pair<double, double> spreadAt(const PlotCurve& curve, std::size_t point) const;
    /// The same at x, between points along straight lines.
    std::optional<std::pair<double, double>> spreadAt(const PlotCurve& curve, double at) const;

    /// The middle of the bars at x, in a plot of bars alone; nothing beside them.
    std::optional<double> barsAt(double at) const;
    /// What the cursor reads.
    std::optional<double> readX() const {
        return cursorX ? std::optional(barsAt(*cursorX).value_or(*cursorX)) : cursorX;
    }
    /// The value of a curve at x along the line drawn; nothing outside its data and in gaps.
    std::optional<double> valueAt(const PlotCurve& curve, double at) const;
    /// Points are read, not curves at an x.
    bool readsPoints() const;
    /// The readable point next to a pixel, nothing beyond `reach` pixels.
    std::optional<Point> nearestPoint(const QPointF& pixel, double reach = 14.0) const;
    /// The readable point after or before pointRead, in a round; the first or last where none is.
    std::optional<Point> nextPoint(int by) const;
    /// The data of the shown curves as a table: one x, then a column for each curve, empty where it
    /// has no point there. A curve back and forth in x has its own x beside it. The reference's
    /// curve is beside its curve under its name.
    QString csv(const CsvFormat& format) const;
    /// The plot as text, curve by curve, with extremes and their places: "Over φ from 0 to 720 °.
    /// Mᵤₚ: from −512 at 372 to 551 N·m at 12; …".
    QString sentence() const;

  private:
    /// The x axis of a figure; where it is only extended, the zoomed section is kept.
    bool showX(const plot::Axis& axis);
    bool showY(const plot::Axis& axis, const std::optional<std::pair<double, double>>& range);
    void keepHome();
    std::vector<QPolygonF> shadesOf(const PlotCurve& curve) const;
};

}  // namespace ravnoves
