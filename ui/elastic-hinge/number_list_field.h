#pragma once

#include <vector>

#include "text/typed_number.h"
#include "widgets/entry_field.h"

namespace ravnoves {

/// A field for a few numbers, as readNumberList() takes them.
class NumberListField : public ValueEntry<std::vector<double>> {
    Q_OBJECT

  public:
    /// @param field  describes each of them; it outlives the widget
    NumberListField(const Field& field, int longest, QWidget* parent = nullptr);

    /// Room for as many numbers of three digits as it takes.
    QSize sizeHint() const override;

  Q_SIGNALS:
    void valuesEdited(const std::vector<double>& values);

  protected:
    Reading read(const QString& typed) const override;
    QString written() const override { return numberListText(value(), field_); }
    QString rule() const override;
    void passOn() override { Q_EMIT valuesEdited(value()); }

  private:
    const Field& field_;
    int longest_;
};

}  // namespace ravnoves
