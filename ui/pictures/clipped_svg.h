#pragma once

#include <QSvgGenerator>
#include <memory>

namespace ravnoves {

/// A device that writes SVG. The engine of QSvgGenerator leaves clipping out: hidden parts would
/// cover the whole sheet. This one writes the box of the painter's clip, and omits the elements
/// outside.
class ClippedSvg : public QSvgGenerator {
  public:
    /// One unit of the drawing is a pixel of a screen with 96 to the inch.
    /// @param out  open
    ClippedSvg(QIODevice& out, const QSize& size, const QString& title = {});
    ~ClippedSvg() override;

  protected:
    QPaintEngine* paintEngine() const override;

  private:
    class Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace ravnoves
