#pragma once

#include <QString>
#include <string>

#include "v8-plugs/compensation.h"
#include "v8-plugs/model/words.h"
#include "v8-plugs/plug_geometry.h"
#include "v8-plugs/weigh_in.h"

namespace ravnoves::v8_text {

// Names that core does not need: its own are Words::name() and Words::text() of its fields,
// options, parts and lines.

/// An engine's name; a preset's with the language's decimal sign and litre ("4,25 л").
QString engineName(const Words& words, const std::string& name);
QString optionName(const Words& words, v8_plugs::OptionId option);
QString partName(const Words& words, v8_plugs::Part part);
/// A line with its factor, for narrow tables: "2.445 × big end Δm_be".
QString shortLine(const Words& words, const v8_plugs::BobWeightLine& line);
/// An option in the fewest words, for legends.
QString shortOption(const Words& words, v8_plugs::OptionId option);
QString materialName(const Words& words, v8_plugs::PlugMaterial material);
/// The names of the values that an engine lacks: "Oil in a crankpin m_m, Oil coefficient k_m".
QString missingNames(const Words& words, const v8_plugs::Engine& engine, bool withBobWeight);

}  // namespace ravnoves::v8_text
