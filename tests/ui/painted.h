#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPicture>
#include <QWidget>
#include <vector>

namespace ravnoves::test {

/// A text as a widget paints it, in the widget's pixels.
struct PaintedText {
    QString text;
    QRectF ink;
    bool isCut = false;  ///< by the clipping that it is painted with
    int pixelSize = 0;   ///< as it is scaled
};

struct Painted {
    std::vector<PaintedText> texts;
    std::vector<QPolygonF> polygons;
};

/// Takes what is painted and keeps the corners of polygons, and the texts that none covers later.
class Recorder : public QPaintDevice, public QPaintEngine {
  public:
    Recorder(const QSize& size, Painted& painted)
        : QPaintEngine(AllFeatures), size_(size), painted_(painted) {}

    QPaintEngine* paintEngine() const override { return const_cast<Recorder*>(this); }
    bool begin(QPaintDevice* /*device*/) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& /*state*/) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {
    }
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode) override {
        QPolygonF polygon;
        for (int i = 0; i < count; ++i) {
            polygon << painter()->transform().map(points[i]);
        }
        painted_.polygons.push_back(polygon);
        if (painter()->brush().style() == Qt::SolidPattern &&
            painter()->brush().color().alphaF() > 0.8F) {
            std::erase_if(painted_.texts, [&](const PaintedText& text) {
                return polygon.containsPoint(text.ink.center(), Qt::OddEvenFill);
            });
        }
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        constexpr double tolerance = 1.0;
        const QRectF ink = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
        const bool isCut =
            painter()->hasClipping() && !painter()->clipBoundingRect().contains(ink.adjusted(
                                            tolerance, tolerance, -tolerance, -tolerance));
        if (!ink.isEmpty()) {
            painted_.texts.push_back(
                {item.text(), painter()->transform().mapRect(ink), isCut,
                 qRound(item.font().pixelSize() * painter()->transform().m22())});
        }
    }

  protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
            case PdmWidth:
                return size_.width();
            case PdmHeight:
                return size_.height();
            case PdmDevicePixelRatio:
                return 1;
            case PdmDevicePixelRatioScaled:
                return static_cast<int>(devicePixelRatioFScale());
            default:
                return 96;
        }
    }

  private:
    QSize size_;
    Painted& painted_;
};

inline Painted painted(const QPicture& picture, const QSize& size) {
    Painted painted;
    Recorder recorder(size, painted);
    QPainter(&recorder).drawPicture(0, 0, picture);
    return painted;
}

/// What a widget paints of itself, without its children.
inline Painted painted(QWidget& widget) {
    QPicture picture;
    widget.render(&picture, QPoint(), QRegion(), QWidget::RenderFlags());
    return painted(picture, widget.size());
}

}  // namespace ravnoves::test
