#pragma once

#include <QPaintDevice>
#include <QSize>
#include <QString>
#include <memory>

class QIODevice;

namespace ravnoves {

/// A device that writes SVG. QSvgGenerator leaves clipping out: hidden parts would cover the whole
/// sheet. This one cuts lines, areas and pictures to the box of the painter's clip and omits the
/// outside. Everything else, also a text at its edge, is written whole.
class ClippedSvg : public QPaintDevice {
  public:
    /// One unit of the drawing is a pixel of a screen with 96 to the inch.
    ClippedSvg(QIODevice& out, const QSize& size, const QString& title = {});
    ~ClippedSvg() override;

    QPaintEngine* paintEngine() const override;

  protected:
    int metric(PaintDeviceMetric metric) const override;

  private:
    class Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace ravnoves
