#pragma once

#include <QPen>
#include <QPointer>
#include <QWidget>

namespace ravnoves {

class SceneModel;

/// A picture of the result that shows, beside its own, what the same picture of a page with another
/// input shows.
class ComparedFigure : public QWidget {
    Q_OBJECT

  public:
    explicit ComparedFigure(QWidget* parent = nullptr);

    /// It shows the variant that a model's case is seen against, as the model has it.
    void followReference(SceneModel* model);
    /// It follows that picture. Null: none.
    void setReference(ComparedFigure* figure, const QString& name);
    const ComparedFigure* reference() const { return reference_; }
    QString referenceName() const { return referenceName_; }
    /// Pictures made later have a greater number.
    int number() const { return number_; }

  Q_SIGNALS:
    void pictureChanged();

  protected:
    /// The pen of what the reference has: wide and pale, as its curves are in plots.
    static QPen ghostPen(QColor colour, double width = 6.0);
    /// Its name with that pen at the top right of a rectangle; nothing where there is none.
    void sayReference(QPainter& painter, const QRectF& corner) const;

  private:
    QPointer<ComparedFigure> reference_;
    QString referenceName_;
    int number_;
};

}  // namespace ravnoves
