#pragma once

#include "page/compared_figure.h"
#include "theme/theme.h"

class QPainter;

namespace ravnoves {

namespace bob_weights {
struct Metal;
}  // namespace bob_weights
struct CsvFormat;

class BobWeightsModel;

/// A correction plane as the machine sees it: the reading as an arrow to the heavy spot, the limit
/// as a circle, the holes in the rim, slugs opposite, what remains as a dot. 0° is above, angles
/// grow clockwise. Of a reference it shows reading and limit.
class PlaneView : public ComparedFigure {
    Q_OBJECT

  public:
    PlaneView(BobWeightsModel* model, std::size_t plane, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {Theme::withText(240), Theme::withText(250)}; }
    QSize minimumSizeHint() const override { return {Theme::withText(170), Theme::withText(190)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    /// "2885 g·mm at 73.1°"
    QString caption() const;
    /// What the plane's rows of the answer say.
    QString table(const CsvFormat& format) const;
    /// The longest of reading and limit, also of the reference.
    double longest() const;
    void drawSector(QPainter& painter, double rim) const;
    /// @param alpha  of their outlines; what was drilled earlier is paler
    void drawHoles(QPainter& painter, double rim, const bob_weights::Metal& metal,
                   float alpha) const;
    void drawVectors(QPainter& painter, double rim) const;

    BobWeightsModel* model_;
    std::size_t plane_;
};

}  // namespace ravnoves
