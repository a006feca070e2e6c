// The colours of curves are distinguished by all eyes: normal ones, and those without one of the
// three kinds of cones, after G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, A
// physiologically-based model for simulation of color vision deficiency, IEEE TVCG 15 (2009),
// severity 1.0.

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <array>
#include <cmath>

#include "theme/theme.h"

namespace ravnoves {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

struct Eyes {
    const char* name;
    Matrix seen;  ///< linear RGB as they see it
};

const std::array eyes{
    Eyes{"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    Eyes{"protanopia",
         {{{0.152286, 1.052583, -0.204868},
           {0.114503, 0.786281, 0.099216},
           {-0.003882, -0.048116, 1.051998}}}},
    Eyes{"deuteranopia",
         {{{0.367322, 0.860646, -0.227968},
           {0.280085, 0.672501, 0.047413},
           {-0.011820, 0.042940, 0.968881}}}},
    Eyes{"tritanopia",
         {{{1.255528, -0.076749, -0.178779},
           {-0.078411, 0.930809, 0.147602},
           {0.004733, 0.691367, 0.303900}}}},
};

Triple times(const Matrix& matrix, const Triple& v) {
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i) {
        product[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
    }
    return product;
}

Triple linear(const QColor& colour) {
    const auto channel = [](double value) {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return {channel(colour.redF()), channel(colour.greenF()), channel(colour.blueF())};
}

/// CIE L*a*b* under D65.
Triple lab(const QColor& colour, const Eyes& by) {
    Triple rgb = times(by.seen, linear(colour));
    for (double& channel : rgb) {
        channel = std::clamp(channel, 0.0, 1.0);
    }
    const Triple xyz = times({{{0.4124564, 0.3575761, 0.1804375},
                               {0.2126729, 0.7151522, 0.0721750},
                               {0.0193339, 0.1191920, 0.9503041}}},
                             rgb);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f(xyz[0] / 0.95047);
    const double y = f(xyz[1]);
    const double z = f(xyz[2] / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double difference(const QColor& a, const QColor& b, const Eyes& by) {
    const Triple p = lab(a, by);
    const Triple q = lab(b, by);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double contrast(const QColor& a, const QColor& b) {
    const auto luminance = [](const QColor& colour) {
        const Triple rgb = linear(colour);
        return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    };
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

class CurveColours : public ::testing::TestWithParam<Theme::Mode> {
  protected:
    CurveColours() { theme.setMode(GetParam()); }
    ~CurveColours() override { theme.setMode(Theme::Mode::Light); }

    Theme& theme = Theme::instance();
};

TEST_P(CurveColours, AreDistinguishableByAllEyes) {
    constexpr double clear = 15.0;  // ΔE; 2.3 is just noticed between patches that touch
    EXPECT_NEAR(difference(Qt::white, Qt::black, eyes[0]), 100.0, 1e-3);
    EXPECT_LT(difference(QColor(0xb35900), QColor(0x8a6d00), eyes[2]), 5.0);  // two browns
    for (const Eyes& each : eyes) {
        for (int i = 0; i < Theme::curveColours; ++i) {
            for (int k = 0; k < i; ++k) {
                EXPECT_GE(difference(theme.curve(i), theme.curve(k), each), clear)
                    << each.name << ": " << k << " and " << i;
            }
        }
    }
}

TEST_P(CurveColours, StandOutFromThePanel) {
    constexpr double graphical = 3.0;  // WCAG 2.1, 1.4.11
    for (int i = 0; i < Theme::curveColours; ++i) {
        EXPECT_GE(contrast(theme.curve(i), theme.panel()), graphical) << i;
        EXPECT_GE(contrast(theme.readable(theme.curve(i)), theme.panel()), 4.5) << i;
    }
    for (const RoleLook& look : roleLooks()) {
        EXPECT_GE(contrast(theme.colour(look.role), theme.panel()), graphical) << look.word;
    }
}

TEST_P(CurveColours, OutlinesAndSelectedTextAreSeen) {
    for (const QColor& ground : {theme.panel(), theme.window()}) {
        EXPECT_GE(contrast(theme.fieldBorder(), ground), 3.0);
        EXPECT_GE(contrast(theme.fieldBorder(false), ground), 2.0);
    }
    const QPalette palette = QApplication::palette();
    EXPECT_GE(
        contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)),
        4.5);
    // As they are drawn: the edge of the box is of that contrast.
    QCheckBox box;
    box.resize(20, 20);
    const QImage drawn = box.grab().toImage();
    double maximum = 1.0;
    for (int x = 0; x < drawn.width(); ++x) {
        maximum =
            std::max(maximum, contrast(drawn.pixelColor(x, drawn.height() / 2), theme.window()));
    }
    EXPECT_GE(maximum, 2.7);
}

INSTANTIATE_TEST_SUITE_P(Themes, CurveColours,
                         ::testing::Values(Theme::Mode::Light, Theme::Mode::Dark),
                         [](const auto& mode) {
                             return mode.param == Theme::Mode::Dark ? "dark" : "light";
                         });

}  // namespace
}  // namespace ravnoves
