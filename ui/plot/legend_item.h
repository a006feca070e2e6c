#pragma once

#include <QAbstractButton>
#include <optional>

#include "plot/model/plot_data.h"

namespace ravnoves {

/// One entry of a legend: the look of the curve's role and its name; a click switches the curve.
class LegendItem : public QAbstractButton {
    Q_OBJECT

  public:
    explicit LegendItem(QWidget* parent);

    /// Of the curve, or of a variant: an & in it is one. A button's text would be a key by it.
    void setName(const QString& name);
    const QString& name() const { return name_; }
    /// @param role  none: a translucent layer of all curves, a stroke or (bars) a shade
    void setSwatch(std::optional<Role> role, plot::Shape shape);
    /// Draws the entry into a rectangle, for pictures without widgets.
    void draw(QPainter& painter, const QRectF& rect) const;

    QSize sizeHint() const override;
    /// The name in as many lines as it takes.
    int heightForWidth(int width) const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString name_;
    std::optional<Role> role_;
    plot::Shape shape_ = plot::Shape::Line;
};

}  // namespace ravnoves
