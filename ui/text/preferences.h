#pragma once

#include <QObject>
#include <QString>
#include <array>

namespace ravnoves {

/// The user's choice of numbers and texts: language, digits, units. One for the application, kept
/// for the next start; it is read when something is written, so visible texts are made again at
/// changed().
class Preferences : public QObject {
    Q_OBJECT

  public:
    static Preferences& instance();

    /// Adopts what the user chose in a session before.
    void load();

    /// Significant digits of the numbers of results; 0: as many as each page takes.
    int digits() const { return digits_; }
    void setDigits(int digits);
    static constexpr int fewestDigits = 3;
    static constexpr int maxDigits = 8;

    /// What can be shown in other units than its own.
    enum Quantity { Length, Mass, Torque, Force, Speed, Unbalance };
    static constexpr int quantities = 6;
    /// Own: mm, kg, N·m, N, each page's unit of speed, unbalance by the unit of masses.
    enum class Units {
        Own,
        Imperial,
        Gram,
        Rpm,
        RadPerSecond,
        GramMillimetre,
        GramInch,
        OunceInch
    };
    Units units(Quantity quantity) const { return units_[static_cast<std::size_t>(quantity)]; }
    void setUnits(Quantity quantity, Units units);

    void setLanguage(const QString& code);
    /// Another change that shows only in new widgets, for example the size of the text.
    void tell() { Q_EMIT changed(); }

  Q_SIGNALS:
    /// What writes numbers or texts in another thread ends before this returns.
    void aboutToChange();
    /// All that is shown is to be made again.
    void changed();

  private:
    int digits_ = 0;
    std::array<Units, quantities> units_{};
};

}  // namespace ravnoves
