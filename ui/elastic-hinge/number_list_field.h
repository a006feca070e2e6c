#pragma once

#include <vector>

#include "case-file/range.h"
#include "widgets/entry_field.h"

namespace ravnoves {

/// A field for a few numbers with blanks or semicolons between them; decimal comma and point. Its
/// values are in the unit; what is written and read may be in another that the user has chosen.
class NumberListField : public ValueEntry<std::vector<double>> {
    Q_OBJECT

  public:
    NumberListField(const Range& range, const Unit& unit, int longest, QWidget* parent = nullptr);

    /// Room for as many numbers of three digits as it takes.
    QSize sizeHint() const override;

  Q_SIGNALS:
    void valuesEdited(const std::vector<double>& values);

  protected:
    Reading read(const QString& typed) const override;
    QString written() const override;
    QString rule() const override;
    void passOn() override { Q_EMIT valuesEdited(value()); }

  private:
    QString rangeText() const;

    Range range_;
    Unit unit_;
    int longest_;
};

}  // namespace ravnoves
