#pragma once

#include <functional>
#include <optional>

#include "case-file/field.h"
#include "text/shown_units.h"
#include "widgets/entry_field.h"

namespace ravnoves {

/// A field for one number with a range. Takes decimal comma and point. The value of a core field is
/// in the field's unit; its text may be in another that the user has chosen.
class NumberField : public ValueEntry<std::optional<double>> {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);
    NumberField(const Field& field, QWidget* parent = nullptr);

    /// The range is in the unit of the value, which is used in messages and by screen readers.
    void setRange(const Range& range, const QString& unit);
    /// The unit that the text is in.
    const QString& unit() const { return unit_; }
    /// An empty field is allowed and means "by formula"; its value is then empty.
    /// A blank text that was rejected is read again once it is allowed.
    void setOptional(bool optional);
    bool isOptional() const { return optional_; }
    /// Only whole numbers are allowed.
    void setWhole(bool whole) {
        whole_ = whole;
        step_ = whole ? 1.0 : 0.0;
    }
    /// Says how a text was read that may mean thousands: "1.100" as 1.1.
    void setSaysHowRead(bool says) { saysHowRead_ = says; }
    /// Of an unbalance: a mass may be typed instead, at so far from the axis; empty where that is
    /// not known yet.
    void setLever(std::function<std::optional<double>()> lever) { lever_ = std::move(lever); }
    /// Step of the arrows up and down; 0: no effect.
    void setStep(double step) { step_ = step; }
    /// The unit that the text is in, where it is given by itself.
    void setShownUnit(const ShownUnit& unit);
    /// Digits after the point; more where a number was given with more.
    void setPlaces(int places) { places_ = places; }
    /// A value as text.
    QString textOf(double value) const;
    /// Significant digits shown; all that is typed is kept.
    void setDigits(int digits);
    QString wholeText() const override;

  Q_SIGNALS:
    /// The user gave a valid value; empty only where the field is optional.
    void valueEdited(std::optional<double> value);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    Reading read(const QString& typed) const override;
    QString written() const override;
    QString rule() const override;
    void passOn() override { Q_EMIT valueEdited(value()); }
    bool isNone(const std::optional<double>& value) const override { return !value; }
    /// Changing its unit there and back does not change the number.
    bool same(const std::optional<double>& a, const std::optional<double>& b) const override;

  private:
    double shown(double value) const;

    Range own_;            ///< in the unit of the value
    Range range_;          ///< in the unit shown
    QString unit_;         ///< as shown
    double factor_ = 1.0;  ///< numbers shown per number of the value
    int digits_ = 10;
    std::function<std::optional<double>()> lever_;
    std::optional<int> places_;
    double step_ = 0.0;
    bool optional_ = false;
    bool whole_ = false;
    bool saysHowRead_ = false;
};

}  // namespace ravnoves
