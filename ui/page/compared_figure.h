#pragma once

#include <QPen>
#include <QWidget>

namespace ravnoves {

class SceneModel;

/// A picture of the result that also shows the result of the reference variant.
class ComparedFigure : public QWidget {
    Q_OBJECT

  public:
    explicit ComparedFigure(QWidget* parent = nullptr);

    /// It shows the variant that a model's case is seen against, as the model has it.
    void followReference(SceneModel* model);
    QString referenceName() const { return referenceName_; }

    /// The pen of the reference: wide and dimmed, as its curves are in plots.
    static QPen ghostPen(QColor colour, double width = 6.0);

  protected:
    /// Its name with that pen at the top right of a rectangle; nothing without a reference.
    void paintReference(QPainter& painter, const QRectF& corner) const;

  private:
    QString referenceName_;
};

}  // namespace ravnoves
