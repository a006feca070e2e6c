#pragma once

#include <QLineEdit>
#include <optional>

#include "case-file/range.h"

namespace ravnoves {

/// A field for one number with a range. Takes decimal comma and point.
///
/// While a valid number is typed, valueEdited() follows at once. What is not allowed is never
/// passed on and never thrown away: the text stays, the frame turns red, trouble() says what is
/// wrong, and the last valid value keeps holding until the text is mended or Escape brings that
/// value back.
class NumberField : public QLineEdit {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);
    NumberField(const FieldSpec& spec, QWidget* parent = nullptr);

    /// The range is in the unit shown; the unit is used in messages and by screen readers.
    void setRange(const Range& range, const QString& unit);
    /// An empty field is allowed and means "by formula"; its value is then empty.
    void setOptional(bool optional);
    /// Shows a value (in the unit shown) unless the user is at something not yet valid.
    void setValue(std::optional<double> value);
    std::optional<double> value() const { return value_; }
    /// What is wrong with the text now, in words; empty where nothing is.
    QString trouble() const { return trouble_; }
    /// The text that explains the field; the range is added.
    void setHint(const QString& hint);
    /// Significant digits shown; all that is typed is kept.
    void setDigits(int digits) { digits_ = digits; }

  Q_SIGNALS:
    /// The user gave a valid value; empty only where the field is optional.
    void valueEdited(std::optional<double> value);
    void troubleChanged(const QString& trouble);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void readText();
    void showValue();
    void setTrouble(const QString& trouble);
    void updateToolTip();

    Range range_;
    QString unit_;
    QString hint_;
    QString trouble_;
    std::optional<double> value_;
    int digits_ = 10;
    bool optional_ = false;
};

}  // namespace ravnoves
