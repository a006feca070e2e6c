#pragma once

#include <QLineEdit>
#include <vector>

#include "case-file/range.h"

namespace ravnoves {

/// A field for a few numbers with blanks or semicolons between them; decimal comma and point. What
/// is not allowed is not passed on: the text stays and trouble() says what is wrong.
class NumberListField : public QLineEdit {
    Q_OBJECT

  public:
    NumberListField(const Range& range, int longest, QWidget* parent = nullptr);

    void setValues(const std::vector<double>& values);
    const std::vector<double>& values() const { return values_; }
    QString trouble() const { return trouble_; }
    /// The text that explains the field; the rule is added.
    void setHint(const QString& hint);

  Q_SIGNALS:
    void valuesEdited(const std::vector<double>& values);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void readText();
    void setTrouble(const QString& trouble);

    Range range_;
    int longest_;
    QString hint_;
    QString trouble_;
    std::vector<double> values_;
};

}  // namespace ravnoves
