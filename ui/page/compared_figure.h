#pragma once

#include <QPen>
#include <QWidget>

namespace ravnoves {

class SceneModel;

/// A picture of the result that shows, beside its own, that of the variant that the case is seen
/// against.
class ComparedFigure : public QWidget {
    Q_OBJECT

  public:
    explicit ComparedFigure(QWidget* parent = nullptr);

    /// It shows the variant that a model's case is seen against, as the model has it.
    void followReference(SceneModel* model);
    QString referenceName() const { return referenceName_; }

    /// The pen of what the reference has: wide and pale, as its curves are in plots.
    static QPen ghostPen(QColor colour, double width = 6.0);

  protected:
    /// Its name with that pen at the top right of a rectangle; nothing where there is none.
    void sayReference(QPainter& painter, const QRectF& corner) const;

  private:
    QString referenceName_;
};

}  // namespace ravnoves
