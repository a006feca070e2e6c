#include "plot/model/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/number_text.h"

namespace ravnoves {

double niceStep(double span, int wanted, bool degrees) {
    if (!(span > 0.0) || !std::isfinite(span)) {
        return 1.0;
    }
    static constexpr std::array<double, 4> decimal{1, 2, 2.5, 5};
    static constexpr std::array<double, 10> angles{1, 2, 5, 10, 15, 30, 45, 60, 90, 120};
    const double rough = span / std::max(1, wanted);
    const auto choose = [rough](const auto& steps, double unit, double last) {
        const auto found =
            std::ranges::find_if(steps, [&](double step) { return step * unit >= rough * 0.999; });
        return (found != steps.end() ? *found : last) * unit;
    };
    return degrees && rough >= angles.front()
               ? choose(angles, 1.0, 180.0)
               : choose(decimal, std::pow(10.0, std::floor(std::log10(rough))), 10.0);
}

double readableStep(double low, double high, int wanted, bool degrees) {
    const auto choose = [&](int ticks) {
        const double step = niceStep(high - low, ticks, degrees);
        // 2.5 needs a digit more than 1, 25 does not.
        return tickDecimals(step) > tickDecimals(step / 2.5) ? 2.0 * step : step;
    };
    constexpr double rounding = 1e-9;
    constexpr int maximum = 4;  // times as many as wanted: by then two must lie in any interval
    double step = choose(wanted);
    for (int ticks = wanted + 1; ticks <= maximum * wanted; ++ticks) {
        if (std::floor(high / step + rounding) - std::ceil(low / step - rounding) >= 1.0) {
            break;
        }
        step = choose(ticks);
    }
    constexpr double many = 50.0;  // an axis of more is no axis
    return (high - low) / step <= many ? step : niceStep(high - low, wanted);
}

std::pair<double, double> niceInterval(double min, double max, int wanted) {
    // Beyond these neither spans nor their squares are numbers.
    constexpr double largest = 1e150;
    min = std::clamp(min, -largest, largest);
    max = std::clamp(max, -largest, largest);
    const double size = std::max(std::abs(min), std::abs(max));
    // What is less is rounding, and no axis can number it.
    constexpr double minimum = 1e-9;
    constexpr double zero = 1e-12;
    if (!(max - min > minimum * size)) {
        const double pad = size > zero ? 0.1 * size : 1.0;
        min -= pad;
        max += pad;
    } else if (size <= zero) {
        min = -1.0;
        max = 1.0;
    }
    const double step = niceStep(max - min, wanted);
    return {std::floor(min / step + 1e-9) * step, std::ceil(max / step - 1e-9) * step};
}

int tickDecimals(double step) {
    for (int decimals = 0; decimals < 12; ++decimals) {
        const double scaled = step * std::pow(10.0, decimals);
        // A step that would read 0 needs more.
        if (scaled > 0.5 && std::abs(scaled - std::round(scaled)) < 1e-6 * std::max(1.0, scaled)) {
            return decimals;
        }
    }
    return 12;
}

std::vector<double> logarithmicTicks(double low, double high, int wanted) {
    constexpr double rounding = 1e-9;
    const int first = static_cast<int>(std::ceil(std::log10(low) - rounding));
    const int last = static_cast<int>(std::floor(std::log10(high) + rounding));
    const int decades = last - first;
    std::vector<double> ticks;
    const auto take = [&](double value) {
        if (value >= low * (1.0 - rounding) && value <= high * (1.0 + rounding)) {
            ticks.push_back(value);
        }
    };
    if (std::log10(high / low) < 1.0) {
        const double step = niceStep(high - low, wanted);
        const double start = std::ceil(low / step);
        for (int i = 0; i <= 4 * wanted && (start + i) * step <= high; ++i) {
            take((start + i) * step);
        }
        return ticks;
    }
    const bool between = 3 * (decades + 1) <= wanted;
    const int every = std::max(1, (decades + wanted) / std::max(1, wanted));
    for (int decade = first - 1; decade <= last; ++decade) {
        if (decade % every != 0) {
            continue;
        }
        const double power = std::pow(10.0, decade);
        take(power);
        if (between) {
            take(2.0 * power);
            take(5.0 * power);
        }
    }
    return ticks;
}

QString powerText(double value, const QLocale& locale, int significant) {
    if (value == 0.0 || !std::isfinite(value)) {
        return value == 0.0 ? QStringLiteral("0") : QStringLiteral("–");
    }
    const QString digits = QLocale::c().toString(std::abs(value), 'e', significant - 1);
    const int exponent = digits.section(QLatin1Char('e'), 1).toInt();
    const double mantissa = digits.section(QLatin1Char('e'), 0, 0).toDouble();
    const QString sign = value < 0.0 ? QString(QChar(0x2212)) : QString();
    const bool isPower = mantissa == 1.0;
    if ((isPower && (exponent == 0 || exponent == 1)) ||
        (!isPower && exponent >= -3 && exponent <= 3)) {
        QLocale plain = locale;
        plain.setNumberOptions(QLocale::OmitGroupSeparator);
        return sign + plain.toString(std::abs(value), 'g', std::max(significant, exponent + 1));
    }
    const QString factor =
        isPower ? QString() : locale.toString(mantissa, 'g', significant) + QChar(0x00B7);
    return sign + factor + powerOfTen(exponent);
}

}  // namespace ravnoves
