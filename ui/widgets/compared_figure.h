#pragma once

#include <QPointer>
#include <QWidget>

namespace ravnoves {

/// A picture of the result that shows, beside its own, what the same picture of a page with another
/// input shows.
class ComparedFigure : public QWidget {
    Q_OBJECT

  public:
    explicit ComparedFigure(QWidget* parent = nullptr);

    /// It follows that picture. Null: none.
    void setReference(ComparedFigure* figure, const QString& name);
    const ComparedFigure* reference() const { return reference_; }
    QString referenceName() const { return referenceName_; }
    /// Pictures made later have a greater number.
    int number() const { return number_; }

  Q_SIGNALS:
    void pictureChanged();

  private:
    QPointer<ComparedFigure> reference_;
    QString referenceName_;
    int number_;
};

}  // namespace ravnoves
