#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "shop/model/words.h"
#include "v8-plugs/input.h"

namespace ravnoves::v8_names {

// Names that core does not need: its own are Words::name() and Words::text() of its fields,
// options, parts and lines.

/// An engine's name; a preset's with the language's decimal sign and litre ("4,25 л").
QString engineName(const Words& words, const std::string& name);
QString optionName(const Words& words, v8_plugs::OptionId option);
/// An option in the fewest words, for legends.
QString shortOption(const Words& words, v8_plugs::OptionId option);
/// The names of the values that the answer lacks: "oil in a crankpin mₘ", "oil coefficient kₘ".
QStringList missing(const Words& words, const v8_plugs::Input& input, bool withBobWeight);

}  // namespace ravnoves::v8_names
