#include "pictures/clipped_svg.h"

#include <QBuffer>
#include <QPaintEngine>
#include <QPainterPath>
#include <QXmlStreamWriter>
#include <optional>

namespace ravnoves {

namespace {

constexpr int svgDots = 96;  ///< to the inch; at others text comes out smaller

QString text(double number) {
    return QString::number(number, 'g', 7);
}
QString text(const QPointF& point) {
    return text(point.x()) + QLatin1Char(',') + text(point.y());
}

class Attributes : public QXmlStreamAttributes {
  public:
    void add(const char* name, const QString& value) { append(QLatin1String(name), value); }
    void add(const char* name, double value) { add(name, text(value)); }
    void add(const QRectF& box) {
        add("x", box.x());
        add("y", box.y());
        add("width", box.width());
        add("height", box.height());
    }
};

/// Of a gradient, which buttons have, its first colour.
QColor colourOf(const QBrush& brush) {
    return brush.gradient() != nullptr ? brush.gradient()->stops().first().second : brush.color();
}

void addStroke(const QPen& pen, double opacity, Attributes& group) {
    if (pen.style() == Qt::NoPen) {
        group.add("stroke", QStringLiteral("none"));
        return;
    }
    const double width = pen.widthF() > 0.0 ? pen.widthF() : 1.0;
    const auto word = [](bool isFirst, const char* first, bool isSecond, const char* second) {
        return QLatin1String(isFirst ? first : isSecond ? second : "round");
    };
    group.add("stroke", colourOf(pen.brush()).name());
    group.add("stroke-opacity", opacity * colourOf(pen.brush()).alphaF());
    group.add("stroke-width", width);
    group.add("stroke-linecap", word(pen.capStyle() == Qt::FlatCap, "butt",
                                     pen.capStyle() == Qt::SquareCap, "square"));
    group.add("stroke-linejoin", word(pen.joinStyle() == Qt::BevelJoin, "bevel",
                                      pen.joinStyle() == Qt::MiterJoin, "miter"));
    if (pen.isCosmetic()) {
        group.add("vector-effect", QStringLiteral("non-scaling-stroke"));
    }
    if (pen.style() != Qt::SolidLine) {
        QStringList dashes;
        for (const double each : pen.dashPattern()) {
            dashes << text(each * width);
        }
        group.add("stroke-dasharray", dashes.join(QLatin1Char(',')));
        group.add("stroke-dashoffset", pen.dashOffset() * width);
    }
}

}  // namespace

/// Writes what is drawn in groups of one pen and brush within one clip, in the device's pixels.
class ClippedSvg::Engine : public QPaintEngine {
  public:
    Engine(QIODevice& out, const QSize& size, const QString& title)
        : QPaintEngine(PrimitiveTransform | PixmapTransform | LinearGradientFill |
                       RadialGradientFill | ObjectBoundingModeGradients | AlphaBlend |
                       PainterPaths | Antialiasing | BrushStroke | ConstantOpacity |
                       PaintOutsidePaintEvent),
          xml_(&out),
          size_(size),
          title_(title) {}

    Type type() const override { return SVG; }

    bool begin(QPaintDevice* /*device*/) override {
        Attributes head;
        head.add("width", size_.width());
        head.add("height", size_.height());
        head.add("viewBox", QStringLiteral("0 0 %1 %2").arg(size_.width()).arg(size_.height()));
        head.add("xmlns", QStringLiteral("http://www.w3.org/2000/svg"));
        head.add("xmlns:xlink", QStringLiteral("http://www.w3.org/1999/xlink"));
        xml_.writeStartDocument();
        xml_.writeStartElement(QStringLiteral("svg"));
        xml_.writeAttributes(head);
        xml_.writeTextElement(QStringLiteral("title"), title_);
        xml_.writeStartElement(QStringLiteral("g"));
        return !xml_.hasError();
    }
    bool end() override {
        xml_.writeEndDocument();
        return !xml_.hasError();
    }

    void updateState(const QPaintEngineState& to) override {
        const bool isRegion = to.state().testFlag(DirtyClipRegion);
        if (!isRegion && !to.state().testFlag(DirtyClipPath)) {
            return;
        }
        const QRectF box =
            isRegion ? QRectF(to.clipRegion().boundingRect()) : to.clipPath().boundingRect();
        const QRectF onDevice = to.transform().mapRect(box);
        clip_ = to.clipOperation() == Qt::NoClip ? std::nullopt
                : to.clipOperation() == Qt::IntersectClip && clip_
                    ? std::optional(*clip_ & onDevice)
                    : std::optional(onDevice);
    }

    void drawPath(const QPainterPath& path) override {
        QString data;
        for (int i = 0; i < path.elementCount(); ++i) {
            const QPainterPath::Element& each = path.elementAt(i);
            data += QLatin1Char(each.isMoveTo()    ? 'M'
                                : each.isLineTo()  ? 'L'
                                : each.isCurveTo() ? 'C'
                                                   : ' ') +
                    text(each);
        }
        Attributes shape;
        shape.add("d", data);
        if (path.fillRule() == Qt::OddEvenFill) {
            shape.add("fill-rule", QStringLiteral("evenodd"));
        }
        draw("path", path.controlPointRect(), shape);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        const QPolygonF polygon(QList<QPointF>(points, points + count));
        QStringList places;
        for (const QPointF& each : polygon) {
            places << text(each);
        }
        Attributes shape;
        shape.add("points", places.join(QLatin1Char(' ')));
        if (mode == PolylineMode) {
            shape.add("fill", QStringLiteral("none"));
        } else if (mode == OddEvenMode) {
            shape.add("fill-rule", QStringLiteral("evenodd"));
        }
        draw(mode == PolylineMode ? "polyline" : "polygon", polygon.boundingRect(), shape);
    }
    void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override {
        drawImage(target, pixmap.toImage(), source, Qt::AutoColor);
    }
    void drawImage(const QRectF& target, const QImage& image, const QRectF& source,
                   Qt::ImageConversionFlags /*flags*/) override {
        QBuffer png;
        image.copy(source.toAlignedRect()).save(&png, "PNG");
        Attributes picture;
        picture.add(target);
        picture.add("preserveAspectRatio", QStringLiteral("none"));
        picture.add("opacity", state->opacity());
        picture.add("xlink:href", QStringLiteral("data:image/png;base64,") +
                                      QLatin1String(png.data().toBase64()));
        draw("image", target, picture);
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QFont font = item.font();
        Attributes letters;
        letters.add("x", at.x());
        letters.add("y", at.y());
        letters.add("xml:space", QStringLiteral("preserve"));
        letters.add("stroke", QStringLiteral("none"));
        letters.add("fill", state->pen().color().name());
        letters.add("fill-opacity", state->opacity() * state->pen().color().alphaF());
        letters.add("font-family", font.family());
        letters.add("font-size", QFontInfo(font).pixelSize());
        letters.add("font-weight", font.weight());
        letters.add("font-style", QLatin1String(font.italic() ? "italic" : "normal"));
        draw("text", {at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent()},
             letters, item.text());
    }

  private:
    /// @param box  what it covers, in its own units
    void draw(const char* name, const QRectF& box, Attributes& own, const QString& content = {}) {
        const QTransform& to = state->transform();
        const double room = state->pen().widthF() + 1.0;
        const bool isClipping = state->isClipEnabled() && clip_;
        if (isClipping && !clip_->intersects(to.mapRect(box.adjusted(-room, -room, room, room)))) {
            return;
        }
        Attributes group;
        if (isClipping) {
            group.add("clip-path", QStringLiteral("url(#%1)").arg(clipName()));
        }
        const QBrush& brush = state->brush();
        addStroke(state->pen(), state->opacity(), group);
        group.add("fill",
                  brush.style() == Qt::NoBrush ? QStringLiteral("none") : colourOf(brush).name());
        group.add("fill-opacity", state->opacity() * colourOf(brush).alphaF());
        if (group != group_) {
            xml_.writeEndElement();
            xml_.writeStartElement(QStringLiteral("g"));
            xml_.writeAttributes(group);
            group_ = group;
        }
        if (!to.isIdentity()) {
            own.add("transform", QStringLiteral("matrix(%1 %2 %3 %4 %5 %6)")
                                     .arg(text(to.m11()), text(to.m12()), text(to.m21()),
                                          text(to.m22()), text(to.dx()), text(to.dy())));
        }
        xml_.writeStartElement(QLatin1String(name));
        xml_.writeAttributes(own);
        xml_.writeCharacters(content);
        xml_.writeEndElement();
    }

    /// Of the present clip, which is written where it is new.
    QString clipName() {
        const qsizetype known = clips_.indexOf(*clip_);
        const QString name = QStringLiteral("clip%1").arg(known < 0 ? clips_.size() : known);
        if (known < 0) {
            clips_ << *clip_;
            Attributes box;
            box.add(*clip_);
            xml_.writeStartElement(QStringLiteral("clipPath"));
            xml_.writeAttribute(QStringLiteral("id"), name);
            xml_.writeEmptyElement(QStringLiteral("rect"));
            xml_.writeAttributes(box);
            xml_.writeEndElement();
        }
        return name;
    }

    QXmlStreamWriter xml_;
    QSize size_;
    QString title_;
    std::optional<QRectF> clip_;
    QList<QRectF> clips_;  ///< that are written
    Attributes group_;     ///< that is open
};

ClippedSvg::ClippedSvg(QIODevice& out, const QSize& size, const QString& title)
    : engine_(std::make_unique<Engine>(out, size, title)) {
    setResolution(svgDots);
    setSize(size);
}

ClippedSvg::~ClippedSvg() = default;

QPaintEngine* ClippedSvg::paintEngine() const {
    return engine_.get();
}

}  // namespace ravnoves
