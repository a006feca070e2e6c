#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>

#include "theme/model/role.h"

class QTabWidget;

namespace ravnoves {

/// The look of the program: palette, colours of curves, type and spacing scale.
///
/// One instance for the application. It is light or dark as the palette of the desktop at the
/// start, until the user chooses; changed() tells custom-painted widgets to repaint.
class Theme : public QObject {
    Q_OBJECT

  public:
    enum class Mode { System, Light, Dark };
    Q_ENUM(Mode)

    static Theme& instance();

    /// Loads the bundled font, sets Fusion and the palette. Call once after QApplication exists.
    void install(Mode mode);
    void setMode(Mode mode);
    Mode mode() const { return mode_; }
    bool isDark() const { return dark_; }

    // Surfaces and text.
    QColor window() const { return of(0xeef0f3, 0x1b1e23); }  ///< behind panels
    QColor panel() const { return of(0xffffff, 0x24282e); }   ///< forms, plots, pictures
    QColor border() const { return of(0xd3d7dd, 0x3a4048); }  ///< hairlines between panels
    /// Of what one types in, ticks or pulls: seen against panels and window by itself.
    QColor fieldBorder(bool isEnabled = true) const {
        return isEnabled ? of(0x757e88, 0x7d8793) : of(0xa0a7af, 0x5c646e);
    }
    QColor text() const { return of(0x1d2126, 0xe6e8eb); }
    QColor mutedText() const { return of(0x5c6670, 0x9aa3ad); }  ///< units, captions
    QColor grid() const { return of(0xe4e7eb, 0x363c44); }       ///< grid lines of plots
    QColor accent() const { return of(0x1f6fbf, 0x4c9be8); }     ///< selection, the present value
    QColor error() const { return of(0xc0281c, 0xff7b72); }
    QColor warning() const { return of(0x9a6700, 0xe3b341); }
    QColor good() const { return of(0x1a7f37, 0x56d364); }
    QColor colour(Role role) const;
    /// Ink number i of the roles: distinguishable with colour-blind eyes, light and dark.
    QColor curve(int i) const;
    static constexpr int curveColours = 8;
    /// A colour for small letters on a panel: the same, or nearer to the text's until it is
    /// legible.
    QColor readable(const QColor& colour) const;

    // Type scale, pixels.
    static constexpr int smallSize = 11;
    static constexpr int baseSize = 13;
    static constexpr int titleSize = 15;
    static constexpr int displaySize = 20;
    static QFont font(int pixelSize = baseSize, bool bold = false);

    /// All text, in parts of its normal size. Widgets made afterwards have it.
    void setTextScale(double scale);
    double textScale() const { return textScale_; }
    static constexpr double largestText = 2.0;
    /// A length that grows with the text: of rows, of fields for a number of digits.
    static int withText(int pixels);
    /// Width that the titles of tabs and the widget before them take.
    /// @param beside  room that each title has beside it
    static int tabsWidth(const QTabWidget& tabs, const QFont& font, int beside);

    // Spacing scale, pixels.
    static constexpr int gap = 4;
    static constexpr int space = 8;
    static constexpr int margin = 12;

  Q_SIGNALS:
    void changed();

  private:
    Theme() = default;
    void apply();
    QColor of(QRgb light, QRgb dark) const { return QColor(dark_ ? dark : light); }

    Mode mode_ = Mode::System;
    bool dark_ = false;
    bool desktopDark_ = false;
    double textScale_ = 1.0;
    double desktopScale_ = 1.0;  ///< of the desktop's text
};

/// A colour between two.
/// @param share  of the second, 0…1
QColor mixed(const QColor& from, const QColor& to, double share);

}  // namespace ravnoves
