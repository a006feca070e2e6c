#include "v8-plugs/plug_geometry.h"

#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "numerics/units.h"

namespace ravnoves::v8_plugs {

namespace {

const double root_three = std::sqrt(3.0);

double disc(double diameter) {
    return pi / 4.0 * diameter * diameter;
}

/// To hundredths, as one measures.
Number millimetres(double length) {
    return {length / units::mm, units::mm, -2, false, true};
}

}  // namespace

double Thread::pitch_diameter() const {
    return diameter - 3.0 / 8.0 * root_three * pitch;
}

double Thread::root_diameter() const {
    return diameter - 17.0 / 24.0 * root_three * pitch;
}

Thread parse_thread(std::string_view text, const std::string& where) {
    std::string_view rest = text;
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    std::optional<double> diameter;
    std::optional<double> pitch;
    for (const std::string_view letter : {"M", "m", "М", "м"}) {
        for (const std::string_view sign : {"x", "X", "×", "х", "Х", "*"}) {
            const std::size_t cross = rest.find(sign);
            if (rest.starts_with(letter) && cross != std::string_view::npos && !diameter) {
                diameter =
                    parse_decimal(rest.substr(0, cross).substr(std::min(letter.size(), cross)));
                pitch = parse_decimal(rest.substr(cross + sign.size()));
            }
        }
    }
    if (!diameter || !pitch) {
        throw InputError(where,
                         {Text::tr("must be a metric thread with its pitch, like %1"), "M22x1.5"},
                         show(std::string(text)));
    }
    if (!thread_diameter_range.contains(*diameter)) {
        throw InputError(where, {Text::tr("the diameter %1 mm"), thread_diameter_range.message()},
                         Number{*diameter});
    }
    if (!thread_pitch_range.contains(*pitch) || *pitch > *diameter / 3.0) {
        throw InputError(
            where,
            {Text::tr("the pitch %1 mm and a third of the diameter"), thread_pitch_range.message()},
            Number{*pitch});
    }
    return {*diameter * units::mm, *pitch * units::mm};
}

std::string thread_name(const Thread& thread) {
    return std::string("M") + format_number(rounded_to_digits(thread.diameter / units::mm, 9)) +
           "x" + format_number(rounded_to_digits(thread.pitch / units::mm, 9));
}

double PlugGeometry::volume() const {
    return disc(thread.pitch_diameter()) * height - disc(bore_diameter) * bore_depth;
}

double PlugGeometry::centre_of_mass() const {
    const double solid = disc(thread.pitch_diameter()) * height;
    const double bore = disc(bore_diameter) * bore_depth;
    return (solid * height / 2.0 - bore * (height - bore_depth / 2.0)) / (solid - bore);
}

std::optional<Message> geometry_fault(const PlugGeometry& plug) {
    if (plug.bore_depth > 0.0 && plug.bore_depth >= plug.height) {
        return Text::tr("The bore is as deep as the plug: no bottom remains.");
    }
    if (plug.bore_diameter >= plug.thread.root_diameter()) {
        return Message(
            Text::tr("The bore is wider than the root of the thread, %1: no wall remains."),
            millimetres(plug.thread.root_diameter()));
    }
    return std::nullopt;
}

double bored_mass(const PlugGeometry& plug, double cutter_diameter, double depth, double density) {
    const double cut = disc(cutter_diameter) * depth;
    const double already_gone = std::min(disc(cutter_diameter), disc(plug.bore_diameter)) *
                                std::min(depth, plug.bore_depth);
    return density * (cut - already_gone);
}

Boring plan_boring(const BoreSetup& setup, double reduction) {
    const PlugGeometry& plug = setup.plug;
    const BoreLimits& limits = setup.limits;
    const double area = disc(limits.cutter_diameter);
    const bool wider = limits.cutter_diameter > plug.bore_diameter;
    const double ring = wider ? area - disc(plug.bore_diameter) : 0.0;
    const double volume = reduction / setup.density;

    Boring boring;
    boring.cuts = reduction > 0.0;
    boring.is_wider = wider;
    if (volume < ring * plug.bore_depth) {
        boring.depth = volume / ring;  // a wider mouth of the bore that is there is enough
    } else {
        boring.depth = plug.bore_depth + (volume - ring * plug.bore_depth) / area;
    }
    boring.deeper = std::max(0.0, boring.depth - plug.bore_depth);
    const double widest =
        std::max(reduction > 0.0 ? limits.cutter_diameter : 0.0, plug.bore_diameter);
    boring.wall = (plug.thread.root_diameter() - widest) / 2.0;
    boring.bottom = plug.height - std::max(boring.depth, plug.bore_depth);

    // Sizes are typed to hundredths of a millimetre: a nanometre of rounding is no violation.
    constexpr double rounding = 1e-9;
    const double cutter_wall = (plug.thread.root_diameter() - limits.cutter_diameter) / 2.0;
    const bool wall_allows = cutter_wall > 0.0 && cutter_wall >= limits.minimum_wall - rounding;
    // Walls that are too thin already are not the cutter's doing: what it cuts counts.
    const double deepest = std::max(plug.height - limits.minimum_bottom, plug.bore_depth);
    if (wall_allows) {
        boring.max_reduction =
            std::max(0.0, bored_mass(plug, limits.cutter_diameter, deepest, setup.density));
    }
    if (reduction > 0.0) {
        if (!wall_allows) {
            boring.limit = Boring::Limit::wall;
        } else if (boring.deeper > 0.0 &&
                   (boring.bottom <= 0.0 || boring.bottom < limits.minimum_bottom - rounding)) {
            boring.limit = Boring::Limit::bottom;
        }
    }
    // Moment of what is cut off about the old centre of mass, over the mass that stays.
    const double old_centre = plug.centre_of_mass();
    const double old_volume = plug.volume();
    // The cut lies between the faces of the cutter's way that were still full of metal.
    double moment = 0.0;
    double cut = 0.0;
    const auto remove = [&](double section, double from, double to) {
        cut += section * (to - from);
        moment += section * (to - from) * (plug.height - (from + to) / 2.0 - old_centre);
    };
    remove(ring, 0.0, std::min(boring.depth, plug.bore_depth));
    if (boring.depth > plug.bore_depth) {
        remove(area, plug.bore_depth, boring.depth);
    }
    boring.cut_distance = cut > 0.0 ? moment / cut : 0.0;
    if (boring.limit == Boring::Limit::none) {
        boring.shift = moment / (old_volume - cut);
    }
    return boring;
}

Message describe(const Boring& boring, const BoreLimits& limits) {
    const Number cutter = millimetres(limits.cutter_diameter);
    const Number depth = millimetres(boring.depth);
    if (!boring.cuts) {
        return {};
    }
    switch (boring.limit) {
        case Boring::Limit::wall:
            return {
                Text::tr("A cutter of %1 leaves a wall of %2 under the thread; the minimum is %3."),
                cutter, millimetres(boring.wall), millimetres(limits.minimum_wall)};
        case Boring::Limit::bottom:
            return {Text::tr("A cutter of %1 needs a depth of %2; the bottom must be at least %3."),
                    cutter, depth, millimetres(limits.minimum_bottom)};
        case Boring::Limit::none:
            break;
    }
    if (!boring.is_wider && boring.deeper > 0.0 && boring.deeper < boring.depth) {
        return {Text::tr("Bore %1 deeper with a cutter of %2, to %3 from the face."),
                millimetres(boring.deeper), cutter, depth};
    }
    return {Text::tr("Bore with a cutter of %1 to %2 from the face."), cutter, depth};
}

bool mass_fits(double typed_mass, double geometry_mass) {
    return std::abs(typed_mass - geometry_mass) <= mass_mismatch * geometry_mass;
}

}  // namespace ravnoves::v8_plugs
