// Names of values, parts, options and engines in the language of the Words.

#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/model/v8_names.h"

namespace ravnoves::v8_text {

using namespace v8_plugs;

QString unitName(const Words& words, std::string_view unit) {
    if (unit == "g") {
        return words.translate("V8", "g", "unit");
    }
    if (unit == "mm") {
        return words.translate("V8", "mm", "unit");
    }
    if (unit == "g·mm") {
        return words.translate("V8", "g·mm", "unit");
    }
    if (unit == "kg") {
        return words.translate("V8", "kg", "unit");
    }
    if (unit == "kg/m³") {
        return words.translate("V8", "kg/m³", "unit");
    }
    if (unit == "mm/s") {
        return words.translate("V8", "mm/s", "unit");
    }
    if (unit == "min⁻¹") {
        return words.translate("V8", "min⁻¹", "unit");
    }
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString engineName(const Words& words, const std::string& name) {
    QString text = QString::fromStdString(name);
    if (find_preset(name) == nullptr || !text.endsWith(QLatin1String(" l"))) {
        return text;
    }
    return words.plain(text.chopped(2).toDouble(), 2) + QChar(0x00A0) +
           words.translate("V8", "l", "litre");
}

QString fieldName(const Words& words, std::string_view key) {
    if (key == "crank_radius_mm") {
        return words.translate("V8", "Crank radius r");
    }
    if (key == "plug_radius_mm") {
        return words.translate("V8", "Plug radius r_p");
    }
    if (key == "new_plug_radius_mm") {
        return words.translate("V8", "New plug radius r_pn");
    }
    if (key == "steel_plug_mass_g") {
        return words.translate("V8", "Steel plug m_p");
    }
    if (key == "aluminium_plug_mass_g") {
        return words.translate("V8", "Aluminium plug m_a");
    }
    if (key == "new_steel_plug_mass_g") {
        return words.translate("V8", "New steel plug m_pn");
    }
    if (key == "new_aluminium_plug_mass_g") {
        return words.translate("V8", "New aluminium plug m_an");
    }
    if (key == "max_steel_reduction_g") {
        return words.translate("V8", "Most off steel plug Δm_pm");
    }
    if (key == "max_aluminium_reduction_g") {
        return words.translate("V8", "Most off aluminium plug Δm_am");
    }
    if (key == "rod_coefficient") {
        return words.translate("V8", "Rod coefficient k_r");
    }
    if (key == "oil_mass_g") {
        return words.translate("V8", "Oil in a crankpin m_m");
    }
    if (key == "oil_coefficient") {
        return words.translate("V8", "Oil coefficient k_m");
    }
    if (key == "reciprocating_mass_g") {
        return words.translate("V8", "Reciprocating mass m_j");
    }
    if (key == "rotating_mass_g") {
        return words.translate("V8", "Rotating mass m_R");
    }
    if (key == "piston") {
        return words.translate("V8", "Improved piston Δm_pi");
    }
    if (key == "rod_big_end") {
        return words.translate("V8", "Rod big end Δm_be");
    }
    if (key == "repair_piston_and_rings") {
        return words.translate("V8", "Repair piston and rings Δm_rp");
    }
    if (key == "repair_bearing") {
        return words.translate("V8", "Repair shells Δm_sh");
    }
    if (key == "tolerance_g_mm") {
        return words.translate("V8", "Residual unbalance allowed");
    }
    return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

QString optionName(const Words& words, OptionId option) {
    switch (option) {
        case OptionId::steel_machined:
            return words.translate("V8", "Machine today's steel plugs");
        case OptionId::steel_to_aluminium:
            return words.translate("V8", "Aluminium plugs");
        case OptionId::new_steel_to_steel:
            return words.translate("V8", "New crankshaft, today's steel plugs");
        case OptionId::new_steel_to_aluminium:
            return words.translate("V8", "New crankshaft, aluminium plugs");
    }
    return {};
}

QString lineName(const Words& words, BobWeightLine::Part part) {
    switch (part) {
        case BobWeightLine::Part::reciprocating:
            return words.translate("V8", "Reciprocating mass m_j");
        case BobWeightLine::Part::piston:
            return words.translate("V8", "Improved piston Δm_pi");
        case BobWeightLine::Part::repair_piston_and_rings:
            return words.translate("V8", "Repair piston and rings Δm_rp");
        case BobWeightLine::Part::rotating:
            return words.translate("V8", "Rotating mass m_R");
        case BobWeightLine::Part::plugs:
            return words.translate("V8", "Plug");
        case BobWeightLine::Part::rod_big_end:
            return words.translate("V8", "Rod big end Δm_be");
        case BobWeightLine::Part::repair_bearing:
            return words.translate("V8", "Repair shells Δm_sh");
        case BobWeightLine::Part::oil:
            return words.translate("V8", "Oil m_m");
    }
    return {};
}

QString shortLine(const Words& words, const BobWeightLine& line) {
    QString name;
    switch (line.part) {
        case BobWeightLine::Part::reciprocating:
            name = words.translate("V8", "reciprocating m_j");
            break;
        case BobWeightLine::Part::piston:
            name = words.translate("V8", "piston Δm_pi");
            break;
        case BobWeightLine::Part::repair_piston_and_rings:
            name = words.translate("V8", "rep. piston Δm_rp");
            break;
        case BobWeightLine::Part::rotating:
            name = words.translate("V8", "rotating m_R");
            break;
        case BobWeightLine::Part::plugs:
            name = words.translate("V8", "plug");
            break;
        case BobWeightLine::Part::rod_big_end:
            name = words.translate("V8", "big end Δm_be");
            break;
        case BobWeightLine::Part::repair_bearing:
            name = words.translate("V8", "rep. shells Δm_sh");
            break;
        case BobWeightLine::Part::oil:
            name = words.translate("V8", "oil m_m");
            break;
    }
    return words.plain(line.factor, 3) + QStringLiteral(" × ") + name;
}

QString shortOption(const Words& words, OptionId option) {
    switch (option) {
        case OptionId::steel_machined:
            return words.translate("V8", "steel");
        case OptionId::steel_to_aluminium:
            return words.translate("V8", "aluminium");
        case OptionId::new_steel_to_steel:
            return words.translate("V8", "new shaft, steel");
        case OptionId::new_steel_to_aluminium:
            return words.translate("V8", "new shaft, aluminium");
    }
    return {};
}

QString partName(const Words& words, Part part) {
    switch (part) {
        case Part::piston:
            return words.translate("V8", "Piston");
        case Part::pin:
            return words.translate("V8", "Pin");
        case Part::rings:
            return words.translate("V8", "Rings");
        case Part::rod_big_end:
            return words.translate("V8", "Rod, big end");
        case Part::rod_small_end:
            return words.translate("V8", "Rod, small end");
        case Part::shells:
            return words.translate("V8", "Shells");
    }
    return {};
}

QString processName(const Words& words, Process process) {
    return process == Process::manufacture ? words.translate("V8", "Manufacture")
                                           : words.translate("V8", "Repair");
}

QString crankshaftName(const Words& words, Crankshaft crankshaft) {
    return crankshaft == Crankshaft::standard
               ? words.translate("V8", "Standard")
               : words.translate("V8", "Made for plugs of the new design");
}

QString materialName(const Words& words, PlugMaterial material) {
    return material == PlugMaterial::steel ? words.translate("V8", "Steel")
                                           : words.translate("V8", "Aluminium");
}

}  // namespace ravnoves::v8_text
