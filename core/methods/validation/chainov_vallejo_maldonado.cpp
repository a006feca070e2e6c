/// The numbers of [chainov-vallejo-maldonado].

#include <array>
#include <cmath>
#include <iterator>

#include "inertia-moments/layouts.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/result.h"
#include "methods/validation/rows.h"
#include "numerics/units.h"

namespace ravnoves::methods {

namespace {

using inertia_moments::Complex;
using inertia_moments::Input;
using inertia_moments::Result;
using inertia_moments::wrap_turn;

constexpr double minute = 1.0 / 60.0;  // °

/// An angle in degrees, 0…360.
double deg(double angle) {
    return wrap_turn(angle) / degree;
}

/// The preset with its four shafts designed for the paper's two-term orders.
Input paper_input() {
    Input input = inertia_moments::preset_vw_vr5();
    input.shaft_basis = inertia_moments::DesignBasis::two_term;
    return input;
}

void sizes(const Result& result, const Input& input, PaperRows& rows) {
    const double shift = input.layout->bank_angle + 2.0 * result.engine.top_dead_centre(0);
    rows.at(in_text(Text::tr("introduction")));
    const auto quoted = [&](Message quantity, const char* unit, const char* printed) {
        rows.not_derivable(std::move(quantity), unit, printed,
                           Text::tr("Quoted from other papers."));
    };
    quoted(lower_end(Text::tr("displacement of five-cylinder engines")), "l", "2.3");
    quoted(upper_end(Text::tr("displacement of five-cylinder engines")), "l", "3.0");
    quoted(lower_end(Text::tr("angle between the banks of VR engines")), "°", "8");
    quoted(upper_end(Text::tr("angle between the banks of VR engines")), "°", "20");
    rows.at(in_text(Text::tr("parameters of the engine")));
    rows.given(Text::tr("angle between the banks γ"), "°", "15", input.layout->bank_angle / degree);
    constexpr const char* offset = "12.5";  // mm
    rows.given(Text::tr("offset e"), "mm", offset, input.layout->offset / units::mm,
               Text::tr("Stated by the paper; the program's input is 12.51 mm, which gives the "
                        "printed K = 0.278."));
    rows.given("λ", "", "0.265", input.lambda);
    rows.reproduced(Text::tr("relative offset K"), "", "0.278",
                    read_printed(offset).value * units::mm / input.crank_radius,
                    Text::tr("e / R, both as printed."));
    rows.reproduced(Text::tr("crank angle at top dead centre"), "°", "3°20′",
                    result.engine.top_dead_centre(0) / degree, Text::tr("arcsin(λK / (1 + λ))."));
    rows.reproduced(Text::tr("shift of the crankpins of bank 2"), "°", "21°40′", shift / degree,
                    Text::tr("To 1′, from the exact top dead centre. Correct is γ + 2 φ; the "
                             "printed γ + φ would give 18°20′."),
                    minute);
}

/// Of the figures 5 and 6.
void stated(const Input& input, PaperRows& rows) {
    rows.at(figure(6));
    rows.given("m_j", "kg", "0.622", input.reciprocating_mass);
    rows.given("R", "m", "0.045", input.crank_radius);
    rows.given("n", "min⁻¹", "6200", input.angular_speed / units::rpm);
    rows.given("a", "m", "0.063", input.layout->spacing);
    // From crankpin 4, three spacings behind the first.
    rows.given("l", "m", "0.0158",
               input.layout->first_position.value() - 3.0 * input.layout->spacing);
}

void crankpins(const Result& result, PaperRows& rows) {
    const auto pin = [&](std::size_t cylinder) {
        return result.engine.cylinders[cylinder - 1].crankpin_angle / degree;
    };
    const Text reason = Text::tr("To 1′: the paper adds up angles rounded to minutes.");
    rows.at(Text::tr("Fig. 2a"));
    rows.reproduced({Text::tr("angle from crankpin %1 to %2"), 1, 4}, "°", "50°20′",
                    pin(4) - pin(1), reason, minute);
    rows.reproduced({Text::tr("angle from crankpin %1 to %2"), 2, 1}, "°", "165°40′",
                    360.0 - pin(2), reason, minute);
    rows.reproduced({Text::tr("angle from crankpin %1 to %2"), 5, 2}, "°", "93°40′",
                    pin(5) - pin(2), reason, minute);
    rows.at(Text::tr("Fig. 2b"));
    rows.reproduced({Text::tr("angle from crankpin %1 to %2"), 4, 3}, "°", "93°40′",
                    pin(3) - pin(4), reason, minute);
    rows.reproduced({Text::tr("angle from crankpin %1 to %2"), 5, 4}, "°", "122°20′",
                    360.0 - pin(5) + pin(4), reason, minute);
}

/// The moment of one order as the paper writes it: what a unit of a (with l = 0) and of l (with
/// a = 0) counts for, in units of m_j R ω² cos(γ/2) or sin(γ/2), for order 2 also of λ.
struct Coefficients {
    Harmonic<double> vertical;
    Harmonic<double> horizontal;
};

Coefficients coefficients(int order, double a, double l) {
    Input input = inertia_moments::preset_vw_vr5();
    input.cylinders = inertia_moments::make_cylinders(input);
    const double half = 0.5 * input.layout->bank_angle;
    input.layout.reset();
    input.shafts.clear();
    input.end_webs.reset();
    // l_cm is measured from crankpin 4.
    for (std::size_t i = 0; i < input.cylinders.size(); ++i) {
        input.cylinders[i].axial_position = a * (3.0 - static_cast<double>(i)) + l;
    }
    const inertia_moments::Engine engine = inertia_moments::make_engine(input);
    const auto orders = inertia_moments::two_term_orders(engine);
    const auto& moment = orders.order(order).moment;
    const double unit = engine.force_unit() * (order == 2 ? input.lambda : 1.0);
    const double vertical = unit * std::cos(half);
    const double horizontal = -unit * std::sin(half);  // bank 1 lies on the negative side of x
    return {{moment.vertical().cos / vertical, moment.vertical().sin / vertical},
            {moment.horizontal().cos / horizontal, moment.horizontal().sin / horizontal}};
}

/// The four printed numbers of one moment: (a, l) of the cosine, (a, l) of the sine.
void printed_moment(PaperRows& rows, Message place, const char* name, int order,
                    const Harmonic<double>& of_a, const Harmonic<double>& of_l,
                    const std::array<const char*, 4>& printed) {
    const double values[] = {of_a.cos, of_l.cos, of_a.sin, of_l.sin};
    const Text coefficients[2][4] = {
        {Text::tr("coefficient of a cos φ"), Text::tr("coefficient of l cos φ"),
         Text::tr("coefficient of a sin φ"), Text::tr("coefficient of l sin φ")},
        {Text::tr("coefficient of a cos 2φ"), Text::tr("coefficient of l cos 2φ"),
         Text::tr("coefficient of a sin 2φ"), Text::tr("coefficient of l sin 2φ")}};
    rows.at(std::move(place));
    for (std::size_t i = 0; i < printed.size(); ++i) {
        rows.reproduced({Text{"%1: %2"}, name, coefficients[order - 1][i]}, "", printed[i],
                        values[i],
                        Text::tr("To one unit of the last digit: the paper adds up sines of "
                                 "angles rounded to minutes. l counts from crankpin 4."),
                        read_printed(printed[i]).last_digit);
    }
}

void moments(PaperRows& rows) {
    const Coefficients a1 = coefficients(1, 1.0, 0.0);
    const Coefficients l1 = coefficients(1, 0.0, 1.0);
    const Coefficients a2 = coefficients(2, 1.0, 0.0);
    const Coefficients l2 = coefficients(2, 0.0, 1.0);
    printed_moment(rows, equation(1), "ΣM₁y", 1, a1.vertical, l1.vertical,
                   {"0.324", "-0.012", "-0.293", "0.0146"});
    printed_moment(rows, equation(2), "ΣM₂y", 2, a2.vertical, l2.vertical,
                   {"5.158", "0.368", "-1.345", "-0.0738"});
    printed_moment(rows, equation(3), "ΣM₁x", 1, a1.horizontal, l1.horizontal,
                   {"3.667", "0.959", "-2.509", "0.786"});
    printed_moment(rows, equation(4), "ΣM₂x", 2, a2.horizontal, l2.horizontal,
                   {"3.078", "0.632", "2.072", "3.151"});
}

void shafts(const Result& result, PaperRows& rows) {
    // Direction of what each shaft cancels, at φ = 0; the preset has them at +ω, −ω, +2ω, −2ω.
    const auto plane = [&](std::size_t i) { return deg(std::arg(result.shafts[i].target)); };
    const Text reason = Text::tr(
        "To 1′, from the two-term orders: the paper computes on with rounded coefficients.");
    rows.at(in_text(Text::tr("Fig. 7a")));
    rows.reproduced(
        joined(Text::tr("plane of the moment of the shaft at +ω"), Text::tr("from the x axis")),
        "°", "1°10′", 180.0 - plane(0), reason, minute);
    rows.at(in_text(Text::tr("Fig. 7b")));
    rows.reproduced(
        joined(Text::tr("plane of the moment of the shaft at −ω"), Text::tr("from the y axis")),
        "°", "19°51′", plane(1) - 90.0, reason, minute);
    rows.at(in_text(Text::tr("Fig. 8a")));
    rows.reproduced(
        joined(Text::tr("plane of the moment of the shaft at +2ω"), Text::tr("from the y axis")),
        "°", "17°39′", plane(2) - 90.0, reason, minute);
    rows.at(in_text(Text::tr("Fig. 8b")));
    rows.reproduced(
        joined(Text::tr("plane of the moment of the shaft at −2ω"), Text::tr("from the y axis")),
        "°", "10°53′", 90.0 - plane(3), reason, minute);
}

/// The rotating masses of the paper's crank with bank 2's crankpins shifted by any angle.
inertia_moments::RotatingMasses rotating_with_shift(double shift) {
    Input input = inertia_moments::preset_vw_vr5();
    const double spacing = input.layout->spacing;
    constexpr double in_line_deg[] = {0.0, 216.0, 144.0, 72.0, 288.0};
    input.layout.reset();
    input.shafts.clear();
    input.end_webs.reset();
    for (std::size_t i = 0; i < std::size(in_line_deg); ++i) {
        inertia_moments::Cylinder cylinder;
        cylinder.axial_position = -spacing * static_cast<double>(i);
        cylinder.crankpin_angle = in_line_deg[i] * degree - (i % 2 == 1 ? shift : 0.0);
        input.cylinders.push_back(cylinder);
    }
    return inertia_moments::rotating_masses(inertia_moments::make_engine(input));
}

/// Force and moment as the paper writes them: of P_c and of a P_c; y along crankpin 1.
double force_y(double shift) {
    return rotating_with_shift(shift).force_factor.real();
}
double force_x(double shift) {
    return rotating_with_shift(shift).force_factor.imag();
}
double per_spacing(double moment) {
    return moment / inertia_moments::preset_vw_vr5().layout->spacing;
}
double moment_y(double shift) {
    return per_spacing(rotating_with_shift(shift).moment_factor.real());
}
double moment_x(double shift) {
    return per_spacing(rotating_with_shift(shift).moment_factor.imag());
}

using OfShift = double (*)(double);

double sine_coefficient(OfShift f) {
    return 0.5 * (f(0.5 * pi) - f(-0.5 * pi));
}
/// Of sin²(γ/2), where that and a sine are all there is.
double half_square_coefficient(OfShift f) {
    return f(pi);
}
double cosine_coefficient(OfShift f) {
    return 0.5 * (f(0.0) - f(pi));
}
double constant_part(OfShift f) {
    return 0.5 * (f(0.0) + f(pi));
}

void rotating_masses(const Result& result, PaperRows& rows) {
    const Text reason = Text::tr("Found from the crank with its shift γ_ш varied.");
    rows.at(in_text("ΣP_cy"));
    rows.reproduced(Text::tr("coefficient of sin γ_ш"), "", "0.36327", sine_coefficient(force_y),
                    reason);
    rows.at(in_text("ΣP_cx"));
    rows.reproduced(Text::tr("coefficient of sin²(γ_ш/2)"), "", "-0.72654",
                    half_square_coefficient(force_x), reason);
    rows.at(in_text("ΣM_cy"));
    rows.reproduced(Text::tr("constant part"), "", "1.382", constant_part(moment_y), reason);
    rows.reproduced(Text::tr("coefficient of sin γ_ш"), "", "-1.5388", sine_coefficient(moment_y),
                    reason);
    rows.reproduced(Text::tr("coefficient of cos γ_ш"), "", "-1.118", cosine_coefficient(moment_y),
                    reason);
    rows.at(in_text("ΣM_cx"));
    rows.reproduced(Text::tr("constant part"), "", "1.9021", constant_part(moment_x), reason);
    rows.slip(Text::tr("coefficient of sin γ_ш"), "", "-1.118", sine_coefficient(moment_x),
              -sine_coefficient(moment_x),
              Text::tr("Misprint of the sign: only a plus gives the paper's angle 75°43′."));
    rows.reproduced(Text::tr("coefficient of cos γ_ш"), "", "-1.5388", cosine_coefficient(moment_x),
                    reason);

    const double force_lag = deg(-std::arg(-result.rotating.force_factor));
    const double moment_lag = deg(-std::arg(-result.rotating.moment_factor));
    const Text angle = Text::tr("To 1′: the paper computes with 21°40′.");
    for (const Message& place : {figure(9), in_text(Text::tr("after ΣM_c"))}) {
        rows.at(place);
        rows.reproduced(
            joined(Text::tr("counterweight against the force"), Text::tr("lag behind crankpin 1")),
            "°", "136°50′", force_lag, angle, minute);
        rows.reproduced(
            joined(Text::tr("counterweight against the moment"), Text::tr("lag behind crankpin 1")),
            "°", "75°43′", moment_lag, angle, minute);
    }
    rows.at(in_text(Text::tr("after ΣM_c")));
    rows.reproduced(Text::tr("plane of ΣM_c against crankpin 1"), "°", "-75°43′",
                    deg(std::arg(result.rotating.moment_factor)) - 180.0, angle, minute);
}

}  // namespace

std::vector<ValidationRow> validate_chainov_vallejo_maldonado() {
    const Input input = paper_input();
    const Result result = inertia_moments::solve(input);
    PaperRows rows("inertia-moments");
    sizes(result, input, rows);
    crankpins(result, rows);
    moments(rows);
    shafts(result, rows);
    rotating_masses(result, rows);
    stated(input, rows);
    return rows.take();
}

}  // namespace ravnoves::methods
