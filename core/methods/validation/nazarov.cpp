/// The numbers of [nazarov].

#include <optional>
#include <string>
#include <utility>

#include "case-file/decimal.h"
#include "methods/validation/rows.h"
#include "numerics/constants.h"
#include "numerics/units.h"
#include "v8-plugs/compensation.h"
#include "v8-plugs/engine.h"
#include "v8-plugs/plug_geometry.h"
#include "v8-plugs/presets.h"

namespace ravnoves::methods {

namespace {

using v8_plugs::Coefficients;
using v8_plugs::Engine;
using v8_plugs::OptionId;

constexpr int decimals = 3;  // of the paper's tables

/// What the paper prints of one engine's plugs, column by column.
struct Column {
    const char* preset;  ///< name of the engine in the program
    double litres;       ///< of the column's title
    double also;         ///< litres of a second engine in it; 0 without
    const char *k_p, *k_p_new, *k_y, *k_y_new;
    const char *aluminium, *new_steel, *new_aluminium;                          ///< (12)–(14)
    const char *aluminium_max, *new_steel_max, *new_aluminium_max, *steel_max;  ///< (19)–(22)
    const char* slope;                                                          ///< (24)
    const char *steel_reduction, *equivalent_reduction;                         ///< of the text
    const char *new_aluminium_mass, *aluminium_reduction;                       ///< m_aн, Δm_am
    const char *l_2, *r, *r_p, *k_rod, *m_a, *m_new, *r_new;  ///< that Table 2 states
};

constexpr Column columns[] = {
    {"4.25 l", 4.25,    0.0,     "1.180", "1.233", "2.360", "2.465", "4.333", "1.920",
     "6.253",  "5.947", "6.524", "7.867", "4.604", "2.360", "1.951", "2.520", "1.179",
     "0.684",  "123",   "40",    "47.2",  "0.445", "0.954", "3.45",  "49.3"},
    {"6 l",    6.0,     7.0,      "1.295",  "1.331", "2.589", "2.661", "6.869", "3.537",
     "10.405", "9.492", "10.646", "13.028", "7.109", "2.589", "2.746", "3.666", "1.794",
     "1.013",  "136",   "47.5",   "61.5",   "0.414", "1.377", "5.25",  "63.2"},
};

/// The plugs with the coefficients rounded as Table 2 prints them: the paper computes on with
/// those.
Engine with_printed_coefficients(const Engine& engine) {
    Engine plugs = engine;
    const Coefficients k = coefficients(engine);
    plugs.plug_radius = rounded_to_decimals(k.k_y, decimals) / 2.0;
    plugs.new_plug_radius = rounded_to_decimals(*k.k_y_new, decimals) / 2.0;
    plugs.crank_radius = 1.0;
    return plugs;
}

v8_plugs::Option option_of(const Engine& plugs, OptionId id, double excess = 0.0) {
    return v8_plugs::evaluate_option(id, plugs, excess, 0.0).value();
}

Message litres(double engine) {
    return {Text::tr("%1 l"), engine};
}

Message litres(double engine, double other) {
    return {Text::tr("%1 and %2 l"), engine, other};
}

Message of(Message quantity, const Column& column) {
    return joined(std::move(quantity),
                  column.also > 0.0 ? litres(column.litres, column.also) : litres(column.litres));
}

void table_2(const Column& c, const Engine& engine, PaperRows& rows) {
    const Coefficients k = coefficients(engine);
    const Text one = Text::tr("r_p / r.");
    const Text both = Text::tr("2 r_p / r, eq. (11).");
    rows.at(table(2));
    rows.given(of("l₂", c), "mm", c.l_2, std::nullopt,
               Text::tr("Stated by the paper; not part of any of its equations."));
    rows.given(of("r", c), "mm", c.r, *engine.crank_radius / units::mm);
    rows.given(of("r_p", c), "mm", c.r_p, *engine.plug_radius / units::mm);
    rows.given(of("r_pн", c), "mm", c.r_new, *engine.new_plug_radius / units::mm);
    rows.given(
        of("k_ш", c), "", c.k_rod, *engine.rod_coefficient,
        Text::tr(
            "Stated by the paper, defined in another paper. Our value is the program's input."));
    rows.given(of("m_a", c), "g", c.m_a, *engine.aluminium_plug_mass / units::gram);
    rows.given(of("m_pн", c), "g", c.m_new, *engine.new_steel_plug_mass / units::gram);
    rows.reproduced(of("k_p", c), "", c.k_p, k.k_p, one);
    rows.reproduced(of("k_pн", c), "", c.k_p_new, *k.k_y_new / 2.0, one);
    rows.reproduced(of("k_y", c), "", c.k_y, k.k_y, both);
    rows.reproduced(of("k_yн", c), "", c.k_y_new, *k.k_y_new, both);
    // Aluminium in the place of steel: one ratio of densities for all plugs.
    const Engine& other = *v8_plugs::find_preset("6 l");
    const double ratio = *other.aluminium_plug_mass / *other.steel_plug_mass;
    rows.reproduced(of("m_aн", c), "g", c.new_aluminium_mass,
                    ratio * *engine.new_steel_plug_mass / units::gram,
                    Text::tr("m_pн with the ratio of aluminium to steel of the present plugs of "
                             "the 6 and 7 l engines."));
}

void table_3(const Column& c, const Engine& engine, PaperRows& rows) {
    const Engine plugs = with_printed_coefficients(engine);
    const auto constant = [&](OptionId id) { return option_of(plugs, id).constant / units::gram; };
    // The maxima are sums of what the same table prints.
    const auto maximum = [&](OptionId id) {
        const v8_plugs::Option option = option_of(plugs, id);
        return rounded_to_decimals(option.constant / units::gram, decimals) +
               (option.maximum - option.constant) / units::gram;
    };
    const Text from_printed = Text::tr(
        "From k_y and k_yн as printed in Table 2; unrounded values change it by up to 0.003 g.");
    const Text from_rounded = Text::tr(
        "From k_y and the constant part as printed; unrounded values change it by up to 0.003 g.");
    rows.at(table(3));
    if (c.also > 0.0) {
        rows.reproduced(of("Δm_yra (12)", c), "g", c.aluminium,
                        constant(OptionId::steel_to_aluminium), from_printed);
    } else {
        rows.given(
            of("Δm_yra (12)", c), "g", c.aluminium, constant(OptionId::steel_to_aluminium),
            Text::tr("The paper prints no m_p of this engine: it follows from this number."));
    }
    rows.reproduced(of("Δm_yhr (13)", c), "g", c.new_steel, constant(OptionId::new_steel_to_steel),
                    from_printed);
    rows.reproduced(of("Δm_yna (14)", c), "g", c.new_aluminium,
                    constant(OptionId::new_steel_to_aluminium), from_printed);
    rows.reproduced(of("Δm_yk1m (19)", c), "g", c.aluminium_max,
                    maximum(OptionId::steel_to_aluminium), from_rounded);
    rows.reproduced(of("Δm_yk2m (20)", c), "g", c.new_steel_max,
                    maximum(OptionId::new_steel_to_steel), from_rounded);
    rows.reproduced(of("Δm_yk3m (21)", c), "g", c.new_aluminium_max,
                    maximum(OptionId::new_steel_to_aluminium), from_rounded);
    rows.reproduced(of("Δm_ykm (22)", c), "g", c.steel_max, maximum(OptionId::steel_machined),
                    from_printed);
    rows.reproduced(of(Text::tr("slope d(Δm_yk)/d(Δm) (24)"), c), "", c.slope,
                    coefficients(engine).k_y, Text::tr("k_y."));
    rows.given(of("Δm_pm", c), "g", c.steel_reduction, *engine.max_steel_reduction / units::gram);
    rows.given(of("Δm_am", c), "g", c.aluminium_reduction,
               *engine.max_aluminium_reduction / units::gram);
}

void text(const Column& c, const Engine& engine, PaperRows& rows) {
    const Engine plugs = with_printed_coefficients(engine);
    const auto reduction = [&](const char* excess) {
        return option_of(plugs, OptionId::steel_machined, read_printed(excess).value * units::gram)
                   .required_reduction /
               units::gram;
    };
    const Text inverse = Text::tr("Equation (18) solved for Δm.");
    rows.at(in_text(after_equation(24)));
    rows.reproduced(of(Text::tr("excess compensated by the present steel plugs"), c), "g",
                    c.steel_max, option_of(plugs, OptionId::steel_machined).maximum / units::gram,
                    Text::tr("Equation (22)."));
    rows.given(of(Text::tr("corresponding lightening of a steel plug"), c), "g", c.steel_reduction,
               reduction(c.steel_max),
               Text::tr("Equation (22) inverted: it was computed from this value."));
    rows.reproduced(
        of(Text::tr("excess that aluminium plugs compensate"), c), "g", c.aluminium_max,
        rounded_to_decimals(option_of(plugs, OptionId::steel_to_aluminium).constant / units::gram,
                            decimals) +
            *plugs.max_aluminium_reduction / units::gram *
                option_of(plugs, OptionId::steel_to_aluminium).slope,
        Text::tr("Equation (19) from the printed constant part."));
    rows.reproduced(of(Text::tr("equivalent lightening of a steel plug"), c), "g",
                    c.equivalent_reduction, reduction(c.aluminium_max), inverse);
}

void shifts(PaperRows& rows) {
    const double largest = v8_plugs::largest_shift;
    const auto coefficient = [&](const char* engine) {
        return v8_plugs::shift_coefficient(largest, *v8_plugs::find_preset(engine)->crank_radius);
    };
    rows.at(in_text(figure(2)));
    rows.reproduced(joined(Text::tr("maximum Δk"), litres(14.86)), "", "0.017",
                    coefficient("14.86 l"), Text::tr("Δr / r, eq. (1)."));
    rows.reproduced(joined(Text::tr("maximum Δk"), litres(4.25)), "", "0.030",
                    coefficient("4.25 l"), Text::tr("Δr / r, eq. (1)."));
    rows.given(upper_end(Text::tr("maximum shift Δr")), "mm", "1.2", largest / units::mm,
               Text::tr("The maximum Δk were computed from this value."));
    rows.not_derivable(lower_end(Text::tr("maximum shift Δr")), "mm", "0.8",
                       Text::tr("The machined shapes are not printed."));
}

void plug_masses(PaperRows& rows) {
    // Thread, heights h and h_k and diameter d_b of Table 1: a cup with a flat bottom.
    v8_plugs::PlugGeometry plug{v8_plugs::parse_thread("M30x1.5", ""),
                                read_printed("11.0").value * units::mm};
    plug.bore_diameter = read_printed("25.0").value * units::mm;
    plug.bore_depth = read_printed("8.0").value * units::mm;
    rows.at(table(1));
    rows.not_derivable(joined(Text::tr("mass m_p of the plug"), litres(6, 7)), "g", "4.03",
                       Text::tr("The drawing lacks dimensions; our value is a steel cup of the "
                                "printed thread and height with a bore of 25 × 8 mm."),
                       plug.volume() * steel_density / units::gram);
    rows.at(in_text(after_equation(24)));
    rows.not_derivable(
        joined(Text::tr("excess that an M27×1.5 aluminium plug compensates"), litres(4.25)), "g",
        "9.685", Text::tr("Mass and radius of such a plug are not printed."));
    rows.at(in_text(Text::tr("experiments")));
    const Text limit = Text::tr("A chosen limit, not computed.");
    rows.given(Text::tr("residual unbalance of the parts"), "g·mm", "5", std::nullopt, limit);
    rows.given(Text::tr("residual unbalance in each correction plane"), "g·mm", "5", std::nullopt,
               limit);
}

/// What Table 1 and the text state of shapes and of the other engines.
void stated(PaperRows& rows) {
    const Text drawing = Text::tr("Stated by the paper, with a drawing that lacks dimensions.");
    struct Size {
        const char *name, *small,
            *large;  // of the 4.25 l engine, of the 6 and 7 l ones; null: none
    };
    constexpr Size sizes[] = {
        {"d_p", "22", "30"},      {"d_p, ×", "1.5", "1.5"}, {"d_b", nullptr, "25.0"},
        {"d_r", "23.5", nullptr}, {"h", "14.0", "11.0"},    {"h_u", "10.0", nullptr},
        {"h_k", "11.0", "8.0"},   {"h_r", "2.0", nullptr},  {"R", "4.0", nullptr},
        {"r₀", "1", "1.6"},       {"r₁", nullptr, "0.6"},   {"r₂", nullptr, "2.0"},
        {"r₃", nullptr, "2.0"},   {"b_i", nullptr, "17.0"}, {"c_i", nullptr, "19.6"},
    };
    rows.at(table(1));
    for (const Size& size : sizes) {
        if (size.small != nullptr) {
            rows.given(joined(size.name, litres(4.25)), "mm", size.small, std::nullopt, drawing);
        }
        if (size.large != nullptr) {
            rows.given(joined(size.name, litres(6, 7)), "mm", size.large, std::nullopt, drawing);
        }
    }
    rows.at(in_text(figure(2)));
    constexpr std::pair<double, const char*> radii[] = {
        {8.32, "60"}, {8.74, "57.5"}, {10.85, "60"}, {14.86, "70"}};
    for (const auto& [engine, printed] : radii) {
        const std::string name = litres(engine).english();
        rows.given(joined("r", litres(engine)), "mm", printed,
                   *v8_plugs::find_preset(name)->crank_radius / units::mm);
    }
    rows.at(in_text(after_equation(24)));
    const Text example = Text::tr("The paper chooses it as an example.");
    rows.given(Text::tr("diameter of a larger thread"), "mm", "27", std::nullopt, example);
    rows.given(Text::tr("pitch of a larger thread"), "mm", "1.5", std::nullopt, example);
}

}  // namespace

std::vector<ValidationRow> validate_nazarov() {
    PaperRows rows("v8-plugs");
    shifts(rows);
    for (const Column& column : columns) {
        const Engine& engine = *v8_plugs::find_preset(column.preset);
        table_2(column, engine, rows);
        table_3(column, engine, rows);
        text(column, engine, rows);
    }
    plug_masses(rows);
    stated(rows);
    return rows.take();
}

}  // namespace ravnoves::methods
