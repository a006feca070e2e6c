#pragma once

#include <QAbstractButton>
#include <QColor>

#include "plot/model/plot_data.h"

namespace ravnoves {

/// One entry of a legend: a stroke or a point in the curve's colour and its name; a click switches
/// the curve.
class LegendItem : public QAbstractButton {
    Q_OBJECT

  public:
    explicit LegendItem(QWidget* parent);

    /// Of the curve, or of a variant: an & in it is one. A button's text would be a key by it.
    void setName(const QString& name);
    const QString& name() const { return name_; }
    /// @param pen  none: a shade
    void setSwatch(const QColor& colour, Qt::PenStyle pen, plot::Shape shape);
    /// Draws the entry into a rectangle, for pictures that hold no widgets.
    void draw(QPainter& painter, const QRectF& rect) const;

    QSize sizeHint() const override;
    /// The name in as many lines as it takes.
    int heightForWidth(int width) const override;
    /// True where there is too little room for the name: the tip has it then.
    bool isElided() const;

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    QString name_;
    QColor colour_;
    Qt::PenStyle pen_ = Qt::SolidLine;
    plot::Shape shape_ = plot::Shape::Line;
};

}  // namespace ravnoves
