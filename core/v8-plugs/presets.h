#pragma once

#include <span>
#include <string_view>

#include "v8-plugs/engine.h"
#include "v8-plugs/input.h"

namespace ravnoves::v8_plugs {

/// The engines of the paper. Only what the paper prints is filled in; m_j, m_R and the oil
/// are empty everywhere. m_p of the 4.25 l engine is lost in the print: 2.79 g follows from
/// Δm_yra and from Δm_yhr alike (Tables 2 and 3).
std::span<const Engine> engine_presets();

/// The preset of that name ("4.25 l", or short "4.25"); null without one.
const Engine* find_preset(std::string_view name);

/// Thread and height of the present plug as Table 1 prints them for the preset; empty for the
/// engines of which it prints none. The bore stays empty: the table's letters are on a drawing that
/// the print does not show well enough to tell which of them is the bore.
PlugSheet printed_plug(std::string_view preset);
/// True where both the mass and the plug's sizes are those that the paper prints: they do not fit
/// each other (see plug_doubt()), and neither was typed or weighed.
bool is_printed(const Input& input, std::optional<double> Engine::*plug_mass);

}  // namespace ravnoves::v8_plugs
