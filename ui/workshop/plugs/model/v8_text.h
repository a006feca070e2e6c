#pragma once

#include <QString>
#include <string>

#include "shop/model/words.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/solver.h"

/// Names and numbers of plugs, in the language of the Words.
namespace ravnoves::v8_text {

inline QString grams(const Words& words, double mass, int decimals = 2) {
    return words.number(mass, units::gram, decimals);
}
inline QString gramMillimetres(const Words& words, double unbalance) {
    return words.number(unbalance, units::gram_mm, 1);
}
/// "M22×1,5": a name, in millimetres always, with the language's decimal sign.
QString thread(const Words& words, const v8_plugs::Thread& thread);
/// An engine's name; a preset's with the language's decimal sign and litre ("4,25 л").
QString engineName(const Words& words, const std::string& name);
inline QString optionName(const Words& words, v8_plugs::OptionId option) {
    return words.text(v8_plugs::option_word(option).label);
}

/// True where the advice is something that works.
inline bool works(const v8_plugs::Result& solution) {
    return solution.advice && (solution.advice->kind == v8_plugs::Advice::Kind::option ||
                               solution.advice->kind == v8_plugs::Advice::Kind::none_needed);
}

}  // namespace ravnoves::v8_text
