#include "theme/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QHash>
#include <QIcon>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QScreen>
#include <QStyleOptionComplex>
#include <QTabWidget>
#include <QtMath>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "text/text_width.h"
#include "theme/icons.h"

namespace ravnoves {

namespace {

/// How much wider than Fusion's a part is that goes with the text.
int beyondFusion(int pixels) {
    return std::max(0, Theme::withText(pixels) - pixels);
}

/// The same palette for all that have its colours. The pictures that Fusion keeps are found again
/// by their palette, and Qt 6.4 never drops the name of a picture: with the palettes that widgets
/// make for themselves, each page would draw its own and leave the names for ever.
QPalette lasting(const QPalette& palette) {
    static QList<QPalette> distinct;
    constexpr qsizetype themes = 64;  // with what tables and messages colour
    auto alike = std::find(distinct.cbegin(), distinct.cend(), palette);
    if (alike == distinct.cend()) {
        if (distinct.size() >= themes) {
            distinct.clear();
        }
        distinct << palette;
        alike = distinct.cend() - 1;
    }
    QPalette same = *alike;
    same.setCurrentColorGroup(palette.currentColorGroup());
    return same;
}

template <typename Option>
Option withLastingPalette(Option option) {
    option.palette = lasting(option.palette);
    return option;
}

/// With the outline of fields, which Fusion derives from the window's colour: on a dark window it
/// would be darker still.
template <typename Option>
Option outlined(Option option) {
    constexpr int darkening = 140;  // percent, Fusion's
    const QColor outline =
        Theme::instance().fieldBorder(option.state.testFlag(QStyle::State_Enabled));
    option.palette.setColor(QPalette::Window, outline.lighter(darkening));
    return withLastingPalette(option);
}

/// Fusion with narrower tabs, so that seven of them fit beside each other in a small window, with
/// outlines that are seen, and with marks, arrows and handles that go with the text.
class ProgramStyle : public QProxyStyle {
  public:
    ProgramStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

    /// Numbers, names and paths come from files, and what looks like HTML there would load pictures
    /// and hide the rest: a label, as of a box or a tip, is plain unless it says that it is rich.
    void polish(QWidget* widget) override {
        QProxyStyle::polish(widget);
        auto* label = qobject_cast<QLabel*>(widget);
        if (label != nullptr && label->textFormat() == Qt::AutoText) {
            label->setTextFormat(Qt::PlainText);
        }
    }
    using QProxyStyle::polish;

    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override {
        const int usual = QProxyStyle::pixelMetric(metric, option, widget);
        switch (metric) {
            case PM_TabBarTabHSpace:
                return 2 * (isCrowded(widget) ? Theme::gap : Theme::space);
            case PM_TabBarScrollButtonWidth:
            case PM_IndicatorWidth:
            case PM_IndicatorHeight:
            case PM_ExclusiveIndicatorWidth:
            case PM_ExclusiveIndicatorHeight:
            case PM_ScrollBarExtent:
                return std::max(Theme::withText(14), usual);
            case PM_CheckBoxLabelSpacing:
            case PM_RadioButtonLabelSpacing:
                return std::max(Theme::withText(6), usual);
            case PM_ButtonIconSize:
                return std::max(Theme::withText(16), usual);
            case PM_HeaderMargin:  // headings beside each other stay apart
                return usual + beyondFusion(4);
            case PM_MenuButtonIndicator:
                return usual + beyondFusion(12);
            case PM_SliderLength:
            case PM_SliderThickness:
            case PM_SliderControlThickness:
                return std::max(Theme::withText(15), usual);
            default:
                return usual;
        }
    }

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* returned) const override {
        switch (hint) {
            case SH_TabBar_PreferNoArrows:  // all tabs are seen, shortened where they must be
            case SH_Menu_Scrollable:
                return 1;
            case SH_TabBar_ElideMode:
                return Qt::ElideRight;
            default:
                return QProxyStyle::styleHint(hint, option, widget, returned);
        }
    }

    /// What leads to the actions that have no room has the theme's colour; and Qt loads all its
    /// readers of pictures for its own.
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option,
                       const QWidget* widget) const override {
        return icon == SP_ToolBarHorizontalExtensionButton
                   ? themedIcon(QStringLiteral("more"))
                   : QProxyStyle::standardIcon(icon, option, widget);
    }

    /// A title that fits but for a fraction of a pixel is not shortened.
    QRect subElementRect(SubElement element, const QStyleOption* option,
                         const QWidget* widget) const override {
        const QRect rect = QProxyStyle::subElementRect(element, option, widget);
        // Numbers leave their cursor room at the right; what is in their place goes with them.
        if (const auto* line = qobject_cast<const QLineEdit*>(widget);
            element == SE_LineEditContents && line != nullptr && line->text().isEmpty() &&
            line->alignment().testFlag(Qt::AlignRight)) {
            constexpr int cursor = 2;
            return rect.adjusted(0, 0, -cursor, 0);
        }
        return element == SE_TabBarTabText ? rect.adjusted(-2, 0, 2, 0) : rect;
    }

    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override {
        QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
        if (type == CT_ComboBox) {
            size.rwidth() += beyondFusion(comboArrow) + 2;
        }
        return size;
    }

    /// Arrows go with the text. A choice among the cells of a table leaves its few letters the room
    /// that its arrow can spare.
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                         const QWidget* widget) const override {
        const QRect rect = QProxyStyle::subControlRect(control, option, part, widget);
        const QRect whole = option->rect;
        const auto leftBy = [&](int more, bool isArrow) {
            return visualRect(option->direction, whole,
                              visualRect(option->direction, whole, rect)
                                  .adjusted(isArrow ? -more : 0, 0, isArrow ? 0 : -more, 0));
        };
        if (control != CC_ComboBox) {
            return rect;
        }
        if (widget == nullptr || !widget->property("isCell").toBool()) {
            return part == SC_ComboBoxArrow || part == SC_ComboBoxEditField
                       ? leftBy(beyondFusion(comboArrow), part == SC_ComboBoxArrow)
                       : rect;
        }
        const int arrow = Theme::withText(11);
        switch (part) {
            case SC_ComboBoxArrow:
                return visualRect(option->direction, whole,
                                  {whole.right() - arrow, rect.y(), arrow, rect.height()});
            case SC_ComboBoxEditField:
                return visualRect(
                    option->direction, whole,
                    {whole.x() + 3, rect.y(), whole.width() - arrow - 3, rect.height()});
            default:
                return rect;
        }
    }

    /// Choices that are too long end in dots; a tab with the focus has a frame.
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
        if (element == CE_TabBarTabLabel && tab != nullptr && tab->state.testFlag(State_HasFocus)) {
            QStyleOptionTab plain = *tab;  // its own mark goes past drawPrimitive()
            plain.state.setFlag(State_HasFocus, false);
            QProxyStyle::drawControl(element, &plain, painter, widget);
            plain.rect.adjust(2, 2, -2, -2);
            drawFocusFrame(painter, &plain);
            return;
        }
        const auto* section = qstyleoption_cast<const QStyleOptionHeader*>(option);
        if (element == CE_HeaderSection && section != nullptr) {
            const auto kept = withLastingPalette(*section);
            QProxyStyle::drawControl(element, &kept, painter, widget);
            return;
        }
        const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        if (element != CE_ComboBoxLabel || box == nullptr || box->editable) {
            QProxyStyle::drawControl(element, option, painter, widget);
            return;
        }
        QStyleOptionComboBox fitted = *box;
        const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - 2;
        fitted.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
        QProxyStyle::drawControl(element, &fitted, painter, widget);
    }

    /// Fusion's mark of the focus is hardly seen on a dark window.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        if (element == PE_FrameLineEdit && frame != nullptr) {
            const auto seen = outlined(*frame);
            QProxyStyle::drawPrimitive(element, &seen, painter, widget);
        } else if ((element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton) &&
                   button != nullptr) {
            const auto seen = outlined(*button);
            QProxyStyle::drawPrimitive(element, &seen, painter, widget);
        } else if (element == PE_PanelButtonCommand && button != nullptr) {
            const auto kept = withLastingPalette(*button);
            QProxyStyle::drawPrimitive(element, &kept, painter, widget);
        } else if (element == PE_IndicatorArrowDown && beyondFusion(comboArrow) > 0) {
            drawArrowDown(painter, option->rect, *option);
        } else if (element != PE_FrameFocusRect) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
        } else if (option->state.testFlag(State_KeyboardFocusChange)) {
            drawFocusFrame(painter, option);
        }
    }

    /// Fusion shows the focus of a choice only after Tab, and faintly.
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                            QPainter* painter, const QWidget* widget) const override {
        if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option)) {
            const auto seen = outlined(*box);
            QProxyStyle::drawComplexControl(control, &seen, painter, widget);
            // Fusion's arrow has one size: with larger text a larger one covers it.
            if (beyondFusion(comboArrow) > 0) {
                drawArrowDown(painter, subControlRect(control, box, SC_ComboBoxArrow, widget),
                              *box);
            }
        } else if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
                   slider != nullptr && control == CC_Slider) {
            const auto seen = outlined(*slider);
            QProxyStyle::drawComplexControl(control, &seen, painter, widget);
        } else if (slider != nullptr && control == CC_ScrollBar) {
            drawScrollBar(painter, *slider,
                          subControlRect(control, slider, SC_ScrollBarSlider, widget));
        } else {
            QProxyStyle::drawComplexControl(control, option, painter, widget);
        }
        if (control == CC_ComboBox && option->state.testFlag(State_HasFocus)) {
            drawFocusFrame(painter, option);
        }
    }

  private:
    /// Width of Fusion's arrow with the rim at its sides, pixels.
    static constexpr int comboArrow = 19;

    static void drawArrowDown(QPainter* painter, const QRectF& room, const QStyleOption& option) {
        const double half = std::min(Theme::withText(8) / 2.0, 0.4 * room.width());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        const bool isOn = option.state.testFlag(State_Enabled);
        painter->setBrush(option.palette.color(isOn ? QPalette::Active : QPalette::Disabled,
                                               QPalette::ButtonText));
        painter->translate(room.center());
        painter->drawPolygon(QPolygonF{QPointF(-half, -half / 2.0), QPointF(half, -half / 2.0),
                                       QPointF(0.0, half / 2.0)});
        painter->restore();
    }

    /// Flat and opaque: Fusion's lets what is below shine through, for which Qt wakes threads.
    static void drawScrollBar(QPainter* painter, const QStyleOptionSlider& bar,
                              const QRect& handle) {
        const Theme& theme = Theme::instance();
        const bool isHeld = bar.state.testFlag(State_MouseOver) || bar.state.testFlag(State_Sunken);
        const int rim = std::min(bar.rect.width(), bar.rect.height()) / 4;
        painter->fillRect(bar.rect, bar.palette.color(QPalette::Window));
        painter->fillRect(bar.orientation == Qt::Vertical ? handle.adjusted(rim, 0, -rim, 0)
                                                          : handle.adjusted(0, rim, 0, -rim),
                          isHeld ? theme.mutedText() : theme.fieldBorder(true));
    }

    static void drawFocusFrame(QPainter* painter, const QStyleOption* option) {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(option->palette.color(QPalette::Highlight), 2.0));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(QRectF(option->rect).adjusted(1.0, 1.0, -1.0, -1.0), 2.0, 2.0);
        painter->restore();
    }

    /// With the usual space around them, the titles of a page's tabs would not all be seen.
    static bool isCrowded(const QWidget* widget) {
        const auto* bar = qobject_cast<const QTabBar*>(widget);
        const auto* tabs =
            bar != nullptr ? qobject_cast<const QTabWidget*>(bar->parentWidget()) : nullptr;
        return tabs != nullptr && tabs->tabBar() == bar &&
               Theme::tabsWidth(*tabs, bar->font(), 2 * Theme::space) > tabs->width();
    }
};

QString bundledFamily() {
    static const QString family = [] {
        const int id =
            QFontDatabase::addApplicationFont(QStringLiteral(":/fonts/DejaVuSansCondensed.ttf"));
        QFontDatabase::addApplicationFont(QStringLiteral(":/fonts/DejaVuSansCondensed-Bold.ttf"));
        const QStringList families = QFontDatabase::applicationFontFamilies(id);
        return families.value(0, QApplication::font().family());
    }();
    return family;
}

}  // namespace

Theme& Theme::instance() {
    static Theme theme;
    return theme;
}

void Theme::install(Mode mode) {
    QApplication::setStyle(new ProgramStyle);
    if (const QScreen* screen = QGuiApplication::primaryScreen()) {
        // The desktop's large text; what differs little from the usual resolution is that.
        constexpr double usualDpi = 96.0;
        const double wanted = screen->logicalDotsPerInchY() / usualDpi;
        desktopScale_ = wanted > 1.1 ? std::min(wanted, largestText) : 1.0;
    }
    QApplication::setFont(font());
    mode_ = mode;
    desktopDark_ = QApplication::palette().color(QPalette::Window).lightness() < 128;
    apply();
}

void Theme::setMode(Mode mode) {
    mode_ = mode;
    apply();
}

void Theme::setTextScale(double scale) {
    textScale_ = std::clamp(scale, 0.8, largestText);
    QApplication::setFont(font());
}

int Theme::withText(int pixels) {
    return static_cast<int>(std::lround(pixels * instance().textScale_ * instance().desktopScale_));
}

int Theme::tabsWidth(const QTabWidget& tabs, const QFont& font, int beside) {
    const QWidget* before = tabs.cornerWidget(Qt::TopLeftCorner);
    int width = before != nullptr ? before->sizeHint().width() : 0;
    for (int i = 0; i < tabs.count(); ++i) {
        if (tabs.isTabVisible(i)) {
            width += qCeil(textWidth(font, tabs.tabText(i).remove(QLatin1Char('&')))) + beside;
        }
    }
    return width;
}

QFont Theme::font(int pixelSize, bool bold) {
    // The same object again, as a new one would have to find its letters again. Never destroyed:
    // what the letters are made of is gone before.
    static auto& made = *new QHash<int, QFont>;
    const int size = withText(pixelSize);
    const int key = 2 * size + (bold ? 1 : 0);
    const auto known = made.constFind(key);
    if (known != made.constEnd()) {
        return *known;
    }
    QFont font(bundledFamily());
    font.setPixelSize(size);
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferNoHinting);
    return *made.insert(key, font);
}

QColor Theme::colour(Role role) const {
    const int ink = lookOf(role).ink;
    switch (ink) {
        case RoleLook::Muted:
            return mutedText();
        case RoleLook::Error:
            return error();
        case RoleLook::Accent:
            return accent();
        default:
            return curve(ink);
    }
}

QColor Theme::curve(int i) const {
    // The hues of Okabe and Ito's palette, moved apart in lightness until eyes without one kind of
    // cones tell every two of them apart as well.
    static constexpr std::array<QRgb, curveColours> light{0x4f5054, 0xcc7d00, 0x3d479e, 0x36825f,
                                                          0x9a6f97, 0x9a5700, 0x2385ff, 0x810000};
    static constexpr std::array<QRgb, curveColours> dark{0x9e9f98, 0xe09a30, 0x6fa0ff, 0x5fe8a8,
                                                         0xa272a8, 0xf6f060, 0xe0eeff, 0xd85055};
    const auto index = static_cast<std::size_t>(i % curveColours);
    return QColor(dark_ ? dark[index] : light[index]);
}

namespace {

/// Of light that a colour sends back, as WCAG counts it.
double luminance(const QColor& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

}  // namespace

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto part = static_cast<float>(share);
    const auto mix = [part](float a, float b) { return a + part * (b - a); };
    return QColor::fromRgbF(mix(from.redF(), to.redF()), mix(from.greenF(), to.greenF()),
                            mix(from.blueF(), to.blueF()));
}

QColor Theme::readable(const QColor& colour) const {
    constexpr double enough = 4.6;  // WCAG asks for 4.5 of small letters
    const double ground = luminance(panel());
    const auto contrast = [ground](const QColor& of) {
        const double light = luminance(of);
        return (std::max(light, ground) + 0.05) / (std::min(light, ground) + 0.05);
    };
    QColor found = colour;
    for (int part = 1; part <= 10 && contrast(found) < enough; ++part) {
        found = mixed(colour, text(), 0.1 * part);
    }
    return found;
}

void Theme::apply() {
    dark_ = mode_ == Mode::Dark || (mode_ == Mode::System && desktopDark_);
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, const QColor& colour) {
        palette.setColor(role, colour);
    };
    set(QPalette::Window, window());
    set(QPalette::WindowText, text());
    set(QPalette::Base, panel());
    set(QPalette::AlternateBase, of(0xf6f7f9, 0x292e35));
    set(QPalette::Text, text());
    set(QPalette::Button, of(0xf4f5f7, 0x2d3239));
    set(QPalette::ButtonText, text());
    set(QPalette::BrightText, error());
    set(QPalette::ToolTipBase, of(0xfffbe6, 0x2d3239));
    set(QPalette::ToolTipText, text());
    set(QPalette::PlaceholderText, mutedText());
    set(QPalette::Highlight, accent());
    set(QPalette::HighlightedText, of(0xffffff, 0x0d1116));
    set(QPalette::Link, accent());
    set(QPalette::LinkVisited, accent());
    set(QPalette::Light, of(0xffffff, 0x3a4048));
    set(QPalette::Midlight, of(0xe9ebee, 0x333941));
    set(QPalette::Mid, of(0xc3c8ce, 0x2a2e34));
    set(QPalette::Dark, of(0xa3a9b0, 0x14171a));
    set(QPalette::Shadow, of(0x6d747c, 0x000000));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, of(0x9aa1a9, 0x6b737d));
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, border());
    QApplication::setPalette(palette);
    Q_EMIT changed();
}

}  // namespace ravnoves
