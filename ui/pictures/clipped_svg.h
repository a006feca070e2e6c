#pragma once

#include <QPaintDevice>
#include <QSize>
#include <QString>
#include <memory>

class QIODevice;

namespace ravnoves {

/// A device that writes SVG. QSvgGenerator leaves clipping out: what is hidden on the screen would
/// cover the whole sheet. This one cuts lines, areas and pictures to the box of the painter's clip
/// and leaves out what lies outside. All else, a text at its edge too, it writes whole.
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
