#pragma once

#include "page/compared_figure.h"
#include "theme/theme.h"

namespace ravnoves {

class WorkshopModel;

/// A correction plane as the machine sees it, as drawPlane() draws it. Of a reference it shows
/// reading and limit.
class PlaneView : public ComparedFigure {
    Q_OBJECT

  public:
    PlaneView(WorkshopModel* model, std::size_t plane, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {Theme::withText(240), Theme::withText(250)}; }
    QSize minimumSizeHint() const override { return {Theme::withText(170), Theme::withText(190)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    /// "2885 g·mm at 73.1°"
    QString caption() const;
    WorkshopModel* model_;
    std::size_t plane_;
};

}  // namespace ravnoves
