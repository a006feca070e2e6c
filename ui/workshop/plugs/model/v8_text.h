#pragma once

#include <QString>
#include <string>

#include "shop/model/words.h"
#include "v8-plugs/solver.h"

/// Names and numbers of plugs, in the language of the Words.
namespace ravnoves::v8_text {

QString grams(const Words& words, double mass, int decimals = 2);
QString gramMillimetres(const Words& words, double unbalance, int decimals = 1);
/// "M22×1,5": a name, in millimetres always, with the language's decimal sign.
QString thread(const Words& words, const v8_plugs::Thread& thread);
/// An engine's name; a preset's with the language's decimal sign and litre ("4,25 л").
QString engineName(const Words& words, const std::string& name);
QString optionName(const Words& words, v8_plugs::OptionId option);

/// True where the advice is something that works.
bool works(const v8_plugs::Result& solution);

}  // namespace ravnoves::v8_text
