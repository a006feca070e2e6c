#include "methods/validation/rows.h"

#include <charconv>
#include <cmath>

#include "numerics/demand.h"

namespace ravnoves::methods {

namespace {

constexpr std::string_view degree_sign = "°";
constexpr std::string_view minute_sign = "′";

double number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    RAVNOVES_DEMAND(error == std::errc() && end == text.data() + text.size(),
                    "a printed number must be one: " + std::string(text));
    return value;
}

Printed read_angle(std::string_view text, std::size_t degrees_end) {
    const double degrees = number(text.substr(0, degrees_end));
    const std::string_view rest = text.substr(degrees_end + degree_sign.size());
    if (rest.empty()) {
        return {degrees, 1.0};
    }
    RAVNOVES_DEMAND(rest.ends_with(minute_sign),
                    "a printed angle must end in its minutes: " + std::string(text));
    const double minutes = number(rest.substr(0, rest.size() - minute_sign.size()));
    return {degrees + std::copysign(minutes / 60.0, degrees), 1.0 / 60.0};
}

}  // namespace

Printed read_printed(std::string_view text) {
    if (const std::size_t angle = text.find(degree_sign); angle != std::string_view::npos) {
        return read_angle(text, angle);
    }
    const std::size_t point = text.find('.');
    const std::size_t decimals = point == std::string_view::npos ? 0 : text.size() - point - 1;
    return {number(text), std::pow(10.0, -static_cast<double>(decimals))};
}

Verdict decide(Verdict claim, double printed, double tolerance, std::optional<double> ours,
               std::optional<double> by_slip) {
    // The printed digits are decimal, so a difference of exactly half a digit carries rounding.
    const double limit = tolerance * (1.0 + 1e-9) + 1e-12 * std::abs(printed);
    const auto agrees = [&](const std::optional<double>& value) {
        return value && std::abs(*value - printed) <= limit;
    };
    const bool is_slip = claim == Verdict::artefact || claim == Verdict::slip;
    const bool is_finite =
        std::isfinite(ours.value_or(0.0)) && std::isfinite(by_slip.value_or(0.0));
    const bool holds = claim == Verdict::not_derivable || (claim == Verdict::given && !ours) ||
                       agrees(is_slip ? by_slip : ours);
    if (!is_finite || !holds) {
        return Verdict::differs;
    }
    return is_slip && agrees(ours) ? Verdict::reproduced : claim;
}

Message in_text(Message place) {
    return joined(Text::tr("text"), std::move(place));
}
Message table(int number) {
    return {Text::tr("Table %1"), number};
}
Message figure(int number) {
    return {Text::tr("Fig. %1"), number};
}
Message equation(int number) {
    return {Text::tr("eq. (%1)"), number};
}
Message after_equation(int number) {
    return {Text::tr("after eq. (%1)"), number};
}
Message lower_end(Text quantity) {
    return joined(quantity, Text::tr("from"));
}
Message upper_end(Text quantity) {
    return joined(quantity, Text::tr("to"));
}

void PaperRows::add(Verdict claim, Message quantity, std::string unit, std::string_view printed,
                    std::optional<double> ours, std::optional<double> by_slip, Message reason,
                    double tolerance) {
    const Printed number = read_printed(printed);
    ValidationRow row;
    row.scene = scene_;
    row.place = place_;
    row.quantity = std::move(quantity);
    row.unit = std::move(unit);
    row.printed_text = printed;
    row.printed = number.value;
    row.last_digit = number.last_digit;
    row.tolerance = tolerance > 0.0 ? tolerance : 0.5 * number.last_digit;
    row.ours = ours;
    row.by_slip = by_slip;
    row.verdict = decide(claim, row.printed, row.tolerance, ours, by_slip);
    row.reason = std::move(reason);
    rows_.push_back(std::move(row));
}

Message PaperRows::stated() {
    return Text::tr("Stated by the paper; our value is the program's input.");
}

}  // namespace ravnoves::methods
