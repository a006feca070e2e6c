#include "pictures/clipped_svg.h"

#include <QPaintEngine>
#include <QPainter>
#include <QSvgGenerator>
#include <algorithm>
#include <cmath>
#include <optional>

#include "pictures/model/clip_shape.h"

namespace ravnoves {

namespace {

constexpr int svgDots = 96;  ///< to the inch; at others text comes out smaller

QPaintEngine::PaintEngineFeatures featuresOf(const QPaintEngine& engine) {
    QPaintEngine::PaintEngineFeatures features;
    for (uint bit = 1; bit != 0; bit <<= 1) {
        const auto feature = static_cast<QPaintEngine::PaintEngineFeature>(bit);
        features.setFlag(feature, engine.hasFeature(feature));
    }
    return features;
}

/// The generator makes black of a pen with a gradient.
QPen withoutGradient(QPen pen) {
    const QGradient* gradient = pen.brush().gradient();
    if (gradient != nullptr && !gradient->stops().isEmpty()) {
        pen.setColor(gradient->stops().first().second);
    }
    return pen;
}

/// The generator's engine, to be asked for by a device that stands before it.
class Generator : public QSvgGenerator {
  public:
    using QSvgGenerator::metric;
    using QSvgGenerator::paintEngine;
};

}  // namespace

/// Paints what it is told with a painter of its own on a QSvgGenerator, once it is cut.
class ClippedSvg::Engine : public QPaintEngine {
  public:
    explicit Engine(std::unique_ptr<Generator> generator)
        : QPaintEngine(featuresOf(*generator->paintEngine())), generator_(std::move(generator)) {}

    const Generator& generator() const { return *generator_; }
    Type type() const override { return SVG; }

    bool begin(QPaintDevice* /*device*/) override {
        clip_.reset();
        return painter_.begin(generator_.get());
    }
    bool end() override { return painter_.end(); }

    void updateState(const QPaintEngineState& state) override {
        const DirtyFlags dirty = state.state();
        if (dirty.testFlag(DirtyTransform)) {
            painter_.setTransform(state.transform());
        }
        if (dirty.testFlag(DirtyPen)) {
            painter_.setPen(withoutGradient(state.pen()));
        }
        if (dirty.testFlag(DirtyBrush)) {
            painter_.setBrush(state.brush());
        }
        if (dirty.testFlag(DirtyBrushOrigin)) {
            painter_.setBrushOrigin(state.brushOrigin());
        }
        if (dirty.testFlag(DirtyFont)) {
            painter_.setFont(state.font());
        }
        if (dirty.testFlag(DirtyOpacity)) {
            painter_.setOpacity(state.opacity());
        }
        if (dirty.testFlag(DirtyHints)) {
            const QPainter::RenderHints hints = state.renderHints();
            painter_.setRenderHints(~hints, false);
            painter_.setRenderHints(hints);
        }
        if (dirty.testFlag(DirtyClipEnabled)) {
            isClipping_ = state.isClipEnabled();
        }
        if (dirty.testFlag(DirtyClipRegion)) {
            clipTo(QRectF(state.clipRegion().boundingRect()), state);
        }
        if (dirty.testFlag(DirtyClipPath)) {
            clipTo(state.clipPath().boundingRect(), state);
        }
    }

    void drawRects(const QRectF* rects, int count) override {
        for (int i = 0; i < count; ++i) {
            QPainterPath path;
            path.addRect(rects[i]);
            draw(path, [&] { painter_.drawRect(rects[i]); });
        }
    }
    void drawEllipse(const QRectF& box) override {
        QPainterPath path;
        path.addEllipse(box);
        draw(path, [&] { painter_.drawEllipse(box); });
    }
    void drawPath(const QPainterPath& path) override {
        draw(path, [&] { painter_.drawPath(path); });
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        const QPolygonF polygon(QList<QPointF>(points, points + count));
        if (mode == PolylineMode) {
            const QPolygonF line = transform().map(polygon);
            if (isWhole(line.boundingRect())) {
                painter_.drawPolyline(polygon);
            } else if (meets(line.boundingRect())) {
                strokeCut(line);
            }
            return;
        }
        const Qt::FillRule rule = mode == WindingMode ? Qt::WindingFill : Qt::OddEvenFill;
        QPainterPath path;
        path.addPolygon(polygon);
        path.closeSubpath();
        path.setFillRule(rule);
        draw(path, [&] { painter_.drawPolygon(polygon, rule); });
    }
    void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override {
        drawImage(target, pixmap.toImage(), source, Qt::AutoColor);
    }
    void drawImage(const QRectF& target, const QImage& whole, const QRectF& source,
                   Qt::ImageConversionFlags flags) override {
        QImage image = whole;
        image.setDevicePixelRatio(1.0);
        const QRectF device = transform().mapRect(target);
        if (isWhole(device)) {
            // The generator writes the whole image, whatever part is wanted.
            const QRect part = source.toAlignedRect() & image.rect();
            if (part != image.rect()) {
                image = image.copy(part);
            }
            painter_.drawImage(target, image, QRectF(image.rect()), flags);
            return;
        }
        if (!meets(device) || target.isEmpty()) {
            return;
        }
        const QRectF seen = transform().inverted().mapRect(device & clip_->bounds()) & target;
        if (seen.isEmpty()) {
            return;
        }
        const double acrossImage = source.width() / target.width();
        const double downImage = source.height() / target.height();
        const QRectF part(source.left() + (seen.left() - target.left()) * acrossImage,
                          source.top() + (seen.top() - target.top()) * downImage,
                          seen.width() * acrossImage, seen.height() * downImage);
        // Its edge runs through pixels: drawn again in smaller ones.
        constexpr double finer = 2.0;
        const auto pixels = [dense = finer * scale()](double shown, double own) {
            constexpr double maximum = 4096.0;
            return static_cast<int>(
                std::ceil(std::clamp(std::max(dense * shown, own), 1.0, maximum)));
        };
        QImage cut(
            pixels(seen.width(), part.width()), pixels(seen.height(), part.height()),
            image.hasAlphaChannel() ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
        cut.fill(Qt::transparent);
        QPainter painter(&cut);
        painter.setRenderHint(QPainter::SmoothPixmapTransform,
                              painter_.testRenderHint(QPainter::SmoothPixmapTransform));
        painter.drawImage(QRectF(cut.rect()), image, part);
        painter.end();
        painter_.drawImage(seen, cut, QRectF(cut.rect()), flags);
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QRectF line(at.x(), at.y() - item.ascent(), item.width(),
                          item.ascent() + item.descent());
        if (!isClipping() || clip_->meets(transform().mapRect(line))) {
            painter_.drawTextItem(at, item);
        }
    }

  private:
    QTransform transform() const { return painter_.transform(); }
    bool isClipping() const { return isClipping_ && clip_; }
    bool isWhole(const QRectF& device) const { return !isClipping() || clip_->contains(device); }

    /// With the width of its line.
    bool meets(const QRectF& device) const {
        const double half = 0.5 * lineWidth() + 0.01;
        return clip_->meets(device.adjusted(-half, -half, half, half));
    }
    /// In the device's pixels.
    double lineWidth() const {
        const QPen pen = painter_.pen();
        const double width = std::max(pen.widthF(), pen.isCosmetic() ? 1.0 : 0.0);
        return pen.style() == Qt::NoPen ? 0.0 : pen.isCosmetic() ? width : width * scale();
    }
    double scale() const { return std::sqrt(std::abs(transform().determinant())); }

    void clipTo(const QRectF& box, const QPaintEngineState& state) {
        const QRectF onDevice = state.transform().mapRect(box);
        switch (state.clipOperation()) {
            case Qt::NoClip:
                clip_.reset();
                break;
            case Qt::ReplaceClip:
                clip_.emplace(onDevice);
                break;
            case Qt::IntersectClip:
                clip_.emplace(clip_ ? clip_->bounds() & onDevice : onDevice);
                break;
        }
    }

    /// @param whole  draws the same where nothing of it is cut
    template <typename Whole>
    void draw(const QPainterPath& path, const Whole& whole) {
        const QRectF device = transform().map(path).controlPointRect();
        if (isWhole(device)) {
            whole();
        } else if (meets(device)) {
            drawCut(path);
        }
    }
    void drawCut(const QPainterPath& path) {
        const QPen pen = painter_.pen();
        painter_.setPen(Qt::NoPen);
        painter_.drawPath(transform().inverted().map(clip_->cutArea(transform().map(path))));
        painter_.setPen(pen);
        for (const QPolygonF& line : flattened(transform().map(path))) {
            strokeCut(line);
        }
    }
    /// @param line  in the device's pixels
    void strokeCut(const QPolygonF& line) {
        const QPen pen = painter_.pen();
        if (pen.style() == Qt::NoPen) {
            return;
        }
        const QTransform back = transform().inverted();
        for (const ClipShape::Stretch& stretch : clip_->cutLine(line)) {
            QPen cut = pen;
            if (stretch.points.size() < line.size() || stretch.points.last() != line.last()) {
                cut.setCapStyle(Qt::FlatCap);
            }
            if (pen.style() != Qt::SolidLine && stretch.before > 0.0 && lineWidth() > 0.0) {
                cut.setDashOffset(pen.dashOffset() + stretch.before / lineWidth());
            }
            painter_.setPen(cut);
            painter_.drawPolyline(back.map(stretch.points));
        }
        painter_.setPen(pen);
    }

    std::unique_ptr<Generator> generator_;
    QPainter painter_;
    std::optional<ClipShape> clip_;
    bool isClipping_ = false;
};

ClippedSvg::ClippedSvg(QIODevice& out, const QSize& size, const QString& title) {
    auto generator = std::make_unique<Generator>();
    generator->setOutputDevice(&out);
    generator->setResolution(svgDots);
    generator->setSize(size);
    generator->setViewBox(QRect(QPoint(), size));
    generator->setTitle(title);
    engine_ = std::make_unique<Engine>(std::move(generator));
}

ClippedSvg::~ClippedSvg() = default;

QPaintEngine* ClippedSvg::paintEngine() const {
    return engine_.get();
}

int ClippedSvg::metric(PaintDeviceMetric metric) const {
    return engine_->generator().metric(metric);
}

}  // namespace ravnoves
