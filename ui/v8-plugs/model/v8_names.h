#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "v8-plugs/compensation.h"
#include "v8-plugs/plug_geometry.h"
#include "v8-plugs/weigh_in.h"
#include "v8-plugs/model/words.h"

namespace ravnoves::v8_text {

// Names of values, parts, options and engines in the language of the Words.

/// A unit of a FieldSpec in the language; empty for pure numbers.
QString unitName(const Words& words, std::string_view unit);
/// An engine's name; a preset's with the language's decimal sign and litre ("4,25 л").
QString engineName(const Words& words, const std::string& name);
/// Name of a value of the engine, without its unit: "Crank radius r".
QString fieldName(const Words& words, std::string_view key);
QString optionName(const Words& words, v8_plugs::OptionId option);
QString lineName(const Words& words, v8_plugs::BobWeightLine::Part part);
/// A line with its factor, for narrow tables: "2.445 × big end Δm_be".
QString shortLine(const Words& words, const v8_plugs::BobWeightLine& line);
/// An option in the fewest words, for legends.
QString shortOption(const Words& words, v8_plugs::OptionId option);
QString partName(const Words& words, v8_plugs::Part part);
QString processName(const Words& words, v8_plugs::Process process);
QString crankshaftName(const Words& words, v8_plugs::Crankshaft crankshaft);
QString materialName(const Words& words, v8_plugs::PlugMaterial material);

}  // namespace ravnoves::v8_text
