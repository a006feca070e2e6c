#include "plot/model/plot_scale.h"

#include <tuple>

#include "case-file/decimal.h"
#include "plot/model/ticks.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

int ticksThatFit(double pixels, double pixelsPerTick) {
    return std::clamp(static_cast<int>(pixels / pixelsPerTick), 2, 16);
}

}  // namespace

bool PlotScale::setSpec(const plot::Axis& axis) {
    const ShownTitle shown = shownTitle(axis.title);
    plot::Axis wanted = axis;
    wanted.title = shown.text;
    wanted.factor = shown.factor;
    return std::exchange(spec, wanted) != wanted;
}

double PlotScale::number(double value) const {
    // There and back again makes no tick at the end of the axis fall off it.
    return spec.factor == 1.0 ? value : rounded_to_digits(spec.factor * value, 12);
}

void PlotScale::fit(double minimum, double maximum, bool steady) {
    if (fixed) {
        std::tie(low, high) = *fixed;
        return;
    }
    if (!(minimum <= maximum)) {
        return;
    }
    if (spec.logarithmic) {
        constexpr double smallest = 1e-300;  // as scaled() has it
        constexpr double largest = 1e300;
        minimum = std::clamp(minimum, smallest, largest);
        maximum = std::clamp(maximum, smallest, largest);
        low = std::pow(10.0, std::floor(std::log10(minimum)));
        high = std::pow(10.0, std::ceil(std::log10(maximum)));
        if (low == high) {
            high *= 10.0;
        }
        return;
    }
    if (steady && minimum >= low && maximum <= high && maximum - minimum > 0.5 * (high - low)) {
        return;
    }
    const double pad = 0.04 * (maximum - minimum);
    std::tie(low, high) =
        niceInterval(spec.factor * (minimum < 0.0 || minimum > pad ? minimum - pad : minimum),
                     spec.factor * (maximum > 0.0 || maximum < -pad ? maximum + pad : maximum), 24);
    low /= spec.factor;
    high /= spec.factor;
}

bool PlotScale::fix(double min, double max) {
    const double pad = spec.logarithmic ? 0.0 : 0.03 * (max - min);
    const std::pair wanted(min - pad, max + pad);
    if (!std::isfinite(wanted.second - wanted.first) || !(wanted.first < wanted.second) ||
        fixed == wanted) {
        return false;
    }
    fixed = wanted;
    return true;
}

void PlotScale::zoom(double factor, double about) {
    constexpr double narrowest = 1e-9;
    constexpr double widest = 1e15;
    const double from = value(about * (1.0 - factor));
    const double to = value(about + (1.0 - about) * factor);
    const double size = std::max({std::abs(from), std::abs(to), 1e-12});
    if (std::isfinite(from) && std::isfinite(to) && to - from > narrowest * size && size < widest) {
        const double room = scaled(home.second) - scaled(home.first);
        const bool isFar = factor > 1.0 && scaled(to) - scaled(from) >= room * (1.0 - 1e-9);
        std::tie(low, high) = isFar ? home : std::pair(from, to);
    }
    section = interval();
}

void PlotScale::shift(double by) {
    section = {value(by), value(1.0 + by)};
    std::tie(low, high) = section;
}

void PlotScale::widen(double span) {
    const double middle = 0.5 * (low + high);
    low = middle - 0.5 * span;
    high = middle + 0.5 * span;
}

void PlotScale::chooseStep(double pixels, double pixelsPerTick,
                           const std::function<double(const QString&)>& width,
                           const QLocale& locale) {
    constexpr int attempts = 4;
    constexpr double apart = 8.0;  // pixels between labels
    for (int attempt = 0; attempt < attempts; ++attempt) {
        step = readableStep(number(low), number(high), ticksThatFit(pixels, pixelsPerTick),
                            spec.degrees);
        if (!width || spec.logarithmic) {  // what has no room there is left out
            return;
        }
        const double widest = std::max(width(tickText(low, locale)), width(tickText(high, locale)));
        const double spacing = pixels * step / (number(high) - number(low));
        if (!(spacing < widest + apart)) {
            return;
        }
        pixelsPerTick = std::max(1.3 * pixelsPerTick, widest + apart);
    }
}

std::vector<double> PlotScale::ticks(double pixels, double pixelsPerTick) const {
    if (spec.logarithmic) {
        std::vector<double> ticks =
            logarithmicTicks(number(low), number(high), ticksThatFit(pixels, pixelsPerTick));
        for (double& tick : ticks) {
            tick /= spec.factor;
        }
        return ticks;
    }
    constexpr double rounding = 1e-9;
    constexpr int many = 200;
    const double first = std::ceil(number(low) / step - rounding);
    const double last = std::floor(number(high) / step + rounding);
    std::vector<double> ticks;
    for (int i = 0; i <= many && first + i <= last; ++i) {
        ticks.push_back((first + i) * step / spec.factor);
    }
    return ticks;
}

QString PlotScale::tickText(double value, const QLocale& locale) const {
    if (spec.logarithmic) {
        return spec.label != nullptr ? spec.label(number(value)) : powerText(number(value), locale);
    }
    // What is far less than a step is the rounding of 0.
    const double shown = std::abs(number(value)) < 1e-6 * step ? 0.0 : number(value);
    constexpr double longest = 1e9;
    const double size = std::max(std::abs(number(low)), std::abs(number(high)));
    if (size < longest) {
        return trueMinus(locale.toString(shown, 'f', tickDecimals(step)));
    }
    const double digits = 1.0 + std::floor(std::log10(size)) - std::floor(std::log10(step));
    return trueMinus(locale.toString(shown, 'e', static_cast<int>(std::clamp(digits, 1.0, 10.0))));
}

QString PlotScale::readout(double value, const QLocale& locale) const {
    if (spec.logarithmic) {
        return tickText(value, locale);
    }
    if (!(high > low)) {
        return trueMinus(locale.toString(number(value), 'g', 3));
    }
    const double fine = std::ceil(3.0 - std::log10(spec.factor * (high - low)));
    return fixedNumber(number(value), std::clamp(static_cast<int>(fine), 0, 9), locale);
}

}  // namespace ravnoves
