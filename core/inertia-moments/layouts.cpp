#include "inertia-moments/layouts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>

#include "inertia-moments/fields.h"
#include "numerics/angle.h"
#include "numerics/demand.h"

namespace ravnoves::inertia_moments {

namespace {

using enum Arrangement;

constexpr std::string_view even;  // crankpins follow the firing order

// name, title, arrangement, N, γ°, side of bank 1, K, a/R, stagger/R, pins, firing order
constexpr std::array<LayoutSpec, 20> library{{
    {"i1", Text::tr("Single"), in_line, 1, 0, 0, 0, 2, 0, "0", "1"},
    {"i2-180", Text::tr("In-line 2, 180°"), in_line, 2, 0, 0, 0, 2, 0, "0 180", "1 2"},
    {"i2-360", Text::tr("In-line 2, 360°"), in_line, 2, 0, 0, 0, 2, 0, "0 0", "1 2"},
    {"i3", Text::tr("In-line 3"), in_line, 3, 0, 0, 0, 2, 0, even, "1 3 2"},
    {"i4", Text::tr("In-line 4"), in_line, 4, 0, 0, 0, 2, 0, even, "1 3 4 2"},
    {"i5", Text::tr("In-line 5"), in_line, 5, 0, 0, 0, 2, 0, even, "1 2 4 5 3"},
    {"i6", Text::tr("In-line 6"), in_line, 6, 0, 0, 0, 2, 0, even, "1 5 3 6 2 4"},
    {"v2-45", Text::tr("V-twin 45°"), v, 2, 45, 1, 0, 2, 0, "0 0", "1 2"},
    {"v2-60", Text::tr("V-twin 60°"), v, 2, 60, 1, 0, 2, 0, "0 0", "1 2"},
    {"v2-90", Text::tr("V-twin 90°"), v, 2, 90, 1, 0, 2, 0, "0 0", "1 2"},
    {"v6-60", Text::tr("V6 60°, split pins"), v, 6, 60, -1, 0, 2.4, 0, even, "1 2 3 4 5 6"},
    {"v6-90", Text::tr("V6 90°, split pins"), v, 6, 90, -1, 0, 2.4, 0, even, "1 2 3 4 5 6"},
    {"v8-cross-plane", Text::tr("V8, cross-plane"), v, 8, 90, 1, 0, 2.4, 0,
     "0 0 90 90 270 270 180 180", "1 8 4 3 6 5 7 2"},
    {"v8-flat-plane", Text::tr("V8, flat-plane"), v, 8, 90, -1, 0, 2.4, 0,
     "0 0 180 180 180 180 0 0", "1 2 5 6 7 8 3 4"},
    {"flat-2", Text::tr("Flat twin"), v, 2, 180, 1, 0, 2.4, 1, "0 180", "1 2"},
    {"flat-4", Text::tr("Flat 4"), v, 4, 180, 1, 0, 2.4, 1, "0 180 180 0", "1 3 2 4"},
    {"flat-6", Text::tr("Flat 6"), v, 6, 180, 1, 0, 2.4, 1, even, "1 4 5 2 3 6"},
    {"vr5", Text::tr("VR5"), vr, 5, 15, 1, 0.278, 1.4, 0, even, "1 2 4 5 3"},
    {"vr6", Text::tr("VR6"), vr, 6, 15, 1, 0.278, 1.4, 0, even, "1 5 3 6 2 4"},
    {"w12", Text::tr("W12"), double_vr, 12, 72, -1, 0.278, 1.5, 0.3, even,
     "1 12 5 8 3 10 6 7 2 11 4 9"},
}};

/// The number of stations along the crank.
int station_count(const Layout& layout) {
    const int cylinders = cylinder_count(layout);
    return has_paired_banks(layout) ? (cylinders + 1) / 2 : cylinders;
}

/// What a layout has from the library; "vr" of any number of cylinders has it from the VR5.
const LayoutSpec& spec_of(const Layout& layout) {
    const LayoutSpec* spec = find_layout(layout.name == "vr" ? "vr5" : layout.name);
    RAVNOVES_DEMAND(spec != nullptr, "a layout's name must be known");
    return *spec;
}

}  // namespace

std::span<const LayoutSpec> layout_library() {
    return library;
}

const LayoutSpec* find_layout(std::string_view name) {
    const auto* found = std::find_if(library.begin(), library.end(),
                                     [&](const LayoutSpec& spec) { return spec.name == name; });
    return found == library.end() ? nullptr : found;
}

Layout usual_layout(const LayoutSpec& spec, double crank_radius) {
    Layout layout;
    layout.name = spec.arrangement == vr ? "vr" : std::string(spec.name);
    layout.cylinders = spec.cylinders;
    layout.bank_angle = spec.bank_angle_deg * degree;
    layout.offset = rounded(spec.relative_offset * crank_radius, field::layout_offset, 6);
    layout.spacing = rounded(spec.relative_spacing * crank_radius, field::spacing, 6);
    layout.stagger = rounded(spec.relative_stagger * crank_radius, field::stagger, 6);
    layout.firing_order = whole_numbers(spec.firing_order);
    return layout;
}

Arrangement arrangement_of(const Layout& layout) {
    return spec_of(layout).arrangement;
}

int cylinder_count(const Layout& layout) {
    return layout.name == "vr" ? layout.cylinders : spec_of(layout).cylinders;
}

bool has_paired_banks(const Layout& layout) {
    return arrangement_of(layout) == v || arrangement_of(layout) == double_vr;
}

double centred_position(const Layout& layout) {
    const double length = layout.spacing * (station_count(layout) - 1) +
                          (has_paired_banks(layout) ? layout.stagger : 0.0);
    return rounded(length / 2.0, field::first_position, 12);
}

std::vector<Cylinder> make_cylinders(const Input& input) {
    const Layout& layout = *input.layout;
    const LayoutSpec& spec = spec_of(layout);
    const Arrangement arrangement = spec.arrangement;
    const int count = cylinder_count(layout);
    const double side = spec.first_bank_side;
    const std::vector<int> pins = whole_numbers(spec.pins_deg);
    const double first = layout.first_position.value_or(centred_position(layout));

    std::vector<Cylinder> cylinders;
    cylinders.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const bool blocks = arrangement == double_vr;
        const int stations = station_count(layout);
        const int station = blocks ? i % stations : arrangement == v ? i / 2 : i;
        const int bank = blocks ? i / stations : arrangement == in_line ? 0 : i % 2;
        const double tilt = bank == 0 ? side : -side;
        const double row = blocks ? (station % 2 == 0 ? 1.0 : -1.0) : 0.0;
        Cylinder& cylinder = cylinders.emplace_back();
        cylinder.axial_position = first - station * layout.spacing;
        if (has_paired_banks(layout)) {
            cylinder.axial_position -= bank * layout.stagger;
        }
        cylinder.bank_angle = tilt * layout.bank_angle / 2.0 + row * w_inner_angle / 2.0;
        cylinder.offset = (blocks ? row : arrangement == in_line ? 1.0 : tilt) * layout.offset;
        if (!pins.empty()) {
            cylinder.crankpin_angle = pins[static_cast<std::size_t>(i)] * degree;
        }
    }
    if (pins.empty()) {
        set_even_firing(cylinders, layout.firing_order, input);
    }
    return cylinders;
}

double wrap_turn(double angle) {
    const double wrapped = wrap(angle, two_pi);
    return wrapped > two_pi - 1e-11 ? 0.0 : wrapped;
}

bool is_firing_order(std::span<const int> order, int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 1);
    return std::ranges::is_permutation(order, numbers);
}

std::vector<int> whole_numbers(std::string_view text) {
    std::vector<int> numbers;
    for (const char* at = text.data(); at < text.data() + text.size(); ++at) {
        int number = 0;
        const auto read = std::from_chars(at, text.data() + text.size(), number);
        if (read.ptr != at && *at != '-') {
            numbers.push_back(number);
            at = read.ptr - 1;
        }
    }
    return numbers;
}

Message firing_order_trouble(std::span<const int> order, int count) {
    return is_firing_order(order, count)
               ? Message()
               : Message(Text::tr("must name each cylinder from 1 to %1 once"), count);
}

Message firing_order_text(std::span<const int> order) {
    std::string text;
    for (const int number : order) {
        text += (text.empty() ? "" : "-") + std::to_string(number);
    }
    return text.empty() ? Message(Text::tr("nothing")) : Message(text);
}

void set_even_firing(std::vector<Cylinder>& cylinders, std::span<const int> firing_order,
                     const Input& input) {
    const auto count = cylinders.size();
    std::vector<int> place(count, 0);  // in the firing order, of each cylinder
    for (std::size_t n = 0; n < count; ++n) {
        place[static_cast<std::size_t>(firing_order[n]) - 1] = static_cast<int>(n);
    }
    const auto top = [&](const Cylinder& cylinder) {
        return SliderCrank<double>{1.0, 1.0 / input.ratio(), cylinder.offset / input.crank_radius}
            .top_dead_centre();
    };
    const Cylinder first = cylinders.front();
    const double top_1 = top(first);
    const double interval = input.cycle() / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        Cylinder& cylinder = cylinders[i];
        const double firing = interval * (place[i] - place[0]);
        cylinder.crankpin_angle =
            wrap_turn((top(cylinder) - top_1) + (cylinder.bank_angle - first.bank_angle) - firing);
    }
}

namespace {

/// φ of a top dead centre, rad, in any turn.
double top_dead_centre(const Engine& engine, int number) {
    const auto cylinder = static_cast<std::size_t>(number) - 1;
    return engine.top_dead_centre(cylinder) - engine.crank_phase(engine.cylinders[cylinder]);
}

constexpr double at_once = 1e-9;  ///< rad, between firings that are one

/// From one angle forward to another, 0…2π; what rounding makes of 0 is 0.
double angle_forward(double from, double to) {
    const double way = wrap_turn(to - from);
    return way > two_pi - at_once ? 0.0 : way;
}

}  // namespace

std::vector<int> dead_centre_order(const Engine& engine) {
    std::vector<int> order(engine.cylinders.size());
    std::iota(order.begin(), order.end(), 1);
    std::vector<double> tops;
    tops.reserve(order.size());
    for (const int number : order) {
        tops.push_back(top_dead_centre(engine, number));
    }
    const auto after_first = [&](int number) {
        const double way = angle_forward(tops.front(), tops[static_cast<std::size_t>(number) - 1]);
        return std::round(way / at_once);  // those that come together stay in their order
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return after_first(a) < after_first(b); });
    return order;
}

bool fires_evenly(std::span<const FiringEvent> firing) {
    return !firing.empty() &&
           std::all_of(firing.begin(), firing.end(), [&](const FiringEvent& event) {
               return std::abs(event.interval - firing.front().interval) < 1e-6;
           });
}

Message describe_misfit(const Engine& engine, std::span<const int> firing_order, double cycle) {
    if (cycle > two_pi) {
        return {Text::tr("This crank cannot fire in the order %1 in two turns."),
                firing_order_text(firing_order)};
    }
    return {Text::tr("This crank cannot fire in the order %1 in one turn (two-stroke); the order "
                     "of its dead centres is %2."),
            firing_order_text(firing_order), firing_order_text(dead_centre_order(engine))};
}

std::vector<FiringEvent> firing_events(const Engine& engine, std::span<const int> firing_order,
                                       double cycle) {
    const auto count = engine.cylinders.size();
    const bool two_stroke = cycle < 1.5 * two_pi;
    if (two_stroke && firing_order.empty()) {
        return firing_events(engine, dead_centre_order(engine), cycle);
    }
    if (!is_firing_order(firing_order, static_cast<int>(count))) {
        return {};
    }
    std::vector<FiringEvent> events(count);
    for (std::size_t n = 0; n < count; ++n) {
        events[n].cylinder = firing_order[n];
        // In one turn; intervals below lift it into the cycle.
        events[n].crank_angle = top_dead_centre(engine, firing_order[n]);
    }
    double sum = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
        FiringEvent& event = events[n];
        const FiringEvent& next = events[(n + 1) % count];
        event.interval = angle_forward(event.crank_angle, next.crank_angle);
        if (event.interval < at_once && !two_stroke) {
            event.interval = two_pi;  // one cylinder at a time
        }
        sum += event.interval;
    }
    if (std::abs(sum - (cycle - two_pi)) < 1e-6) {
        // The order fits in one turn less (twins, single cylinders; all at once): that is a pause.
        events.back().interval += two_pi;
        sum += two_pi;
    }
    if (std::abs(sum - cycle) > 1e-6) {
        return {};
    }
    double angle = 0.0;
    for (FiringEvent& event : events) {
        event.crank_angle = angle;
        angle += event.interval;
    }
    return events;
}

}  // namespace ravnoves::inertia_moments
