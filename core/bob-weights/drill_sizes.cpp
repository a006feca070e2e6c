#include "bob-weights/drill_sizes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "numerics/units.h"

namespace ravnoves::bob_weights {

namespace {

constexpr double mil = 0.001 * units::inch;

/// From #1 on, thousandths of an inch.
constexpr std::array number_drills{
    228.0, 221.0, 213.0, 209.0, 205.5, 204.0, 201.0, 199.0, 196.0, 193.5, 191.0, 189.0,
    185.0, 182.0, 180.0, 177.0, 173.0, 169.5, 166.0, 161.0, 159.0, 157.0, 154.0, 152.0,
    149.5, 147.0, 144.0, 140.5, 136.0, 128.5, 120.0, 116.0, 113.0, 111.0, 110.0, 106.5,
    104.0, 101.5, 99.5,  98.0,  96.0,  93.5,  89.0,  86.0,  82.0,  81.0,  78.5,  76.0,
    73.0,  70.0,  67.0,  63.5,  59.5,  55.0,  52.0,  46.5,  43.0,  42.0,  41.0,  40.0};
/// From A on, likewise.
constexpr std::array letter_drills{234.0, 238.0, 242.0, 246.0, 250.0, 257.0, 261.0, 266.0, 272.0,
                                   277.0, 281.0, 290.0, 295.0, 302.0, 316.0, 323.0, 332.0, 339.0,
                                   348.0, 358.0, 368.0, 377.0, 386.0, 397.0, 404.0, 413.0};

std::optional<unsigned> whole(std::string_view text) {
    unsigned number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

std::optional<double> fraction_of_an_inch(std::string_view text) {
    if (text.ends_with('"')) {
        text.remove_suffix(1);
    }
    const std::size_t dash = text.find('-');
    const auto inches = dash == text.npos ? std::optional(0U) : whole(text.substr(0, dash));
    text.remove_prefix(dash == text.npos ? 0 : dash + 1);
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto above = whole(text.substr(0, slash));
    const auto below = slash < text.size() ? whole(text.substr(slash + 1)) : std::nullopt;
    constexpr unsigned finest = 64;
    if (!inches || !above || !below || *above == 0 || *above >= *below ||
        !std::has_single_bit(*below) || *below > finest) {
        return std::nullopt;
    }
    return (*inches + static_cast<double>(*above) / *below) * units::inch;
}

}  // namespace

std::optional<double> named_drill(std::string_view name) {
    if (name.size() > 1 && name.front() == '#') {
        const auto number = whole(name.substr(1));
        return number && *number >= 1 && *number <= number_drills.size()
                   ? std::optional(number_drills[*number - 1] * mil)
                   : std::nullopt;
    }
    if (name.size() == 1) {
        const char letter = static_cast<char>(name.front() & ~0x20);  // a is A
        return letter >= 'A' && letter <= 'Z'
                   ? std::optional(letter_drills[static_cast<std::size_t>(letter - 'A')] * mil)
                   : std::nullopt;
    }
    return fraction_of_an_inch(name);
}

bool is_usual_drill(double diameter) {
    constexpr double rounding = 0.006 * units::mm;
    const auto is_multiple = [&](double step) {
        return std::abs(std::remainder(diameter, step)) < rounding;
    };
    const auto is_among = [&](const auto& sizes) {
        return std::any_of(sizes.begin(), sizes.end(),
                           [&](double size) { return std::abs(size * mil - diameter) < rounding; });
    };
    return is_multiple(0.05 * units::mm) || is_multiple(units::inch.to_si / 64.0) ||
           is_among(number_drills) || is_among(letter_drills);
}

}  // namespace ravnoves::bob_weights
