#pragma once

#include <QString>
#include <QStringList>

#include "shop/model/matching_text.h"
#include "shop/model/words.h"
#include "v8-plugs/solver.h"

namespace ravnoves::v8_text {

// What the page and the job card say about a solution, in the language of the Words. Masses in g,
// unbalance in g·mm, lengths in mm.

QString grams(const Words& words, double mass, int decimals = 2);
QString gramMillimetres(const Words& words, double unbalance, int decimals = 1);

/// "M22×1,5": a name, in millimetres always, with the language's decimal sign.
QString thread(const Words& words, const v8_plugs::Thread& thread);
/// The angle of an option's line in the diagram, in degrees.
QString slopeAngle(const Words& words, double slope);
/// What to do, as one or two sentences; empty while it is not known. Where the method
/// neglects what matters, it is what can be done.
QString advice(const Words& words, const v8_plugs::Input& input, const v8_plugs::Result& solution);
/// How to bore for an option, or why it cannot be bored; empty where nothing is known of the plug,
/// nothing is to be cut or no depth is right.
QString boring(const Words& words, const v8_plugs::Input& input, const v8_plugs::Result& solution,
               v8_plugs::OptionId option);
/// Rules broken by engine and plug.
QStringList troubles(const Words& words, const v8_plugs::Input& input);
/// True where an option works only as long as the shift is neglected.
bool methodAlone(const v8_plugs::Result& solution, v8_plugs::OptionId option);
/// What the shift of the plug's centre of mass is worth for an option, beside the tolerance: the
/// paper's range, and the bore's own where one is planned.
QString shiftText(const Words& words, const v8_plugs::Input& input,
                  const v8_plugs::Result& solution, const v8_plugs::Option& option);
/// The same of the option that the answer is about, else of boring today's plugs; empty while no
/// option is known.
QString shiftText(const Words& words, const v8_plugs::Input& input,
                  const v8_plugs::Result& solution);
/// The option that the answer is about: the recommended one, else the one that leaves least;
/// nothing where nothing is needed or known.
std::optional<v8_plugs::Option> chosenOption(const v8_plugs::Result& solution);
/// The bob weight with it; null where it is not known.
const v8_plugs::BobWeight* bobWeightAfter(const v8_plugs::Result& solution);
/// True where the advice is something that works.
bool works(const v8_plugs::Result& solution);
/// "The bob weight after is that of the nominal engine" or by how much it is not; where the shift
/// matters, that only the method says so.
QString bobWeightCheck(const Words& words, const v8_plugs::Input& input,
                       const v8_plugs::Result& solution);
/// Whether the plugs are in the shaft while it hangs there, and what to hang in the other case.
QString plugsWhileHung(const Words& words, const v8_plugs::Result& solution);
/// Why a big end counts more than twice.
QString rodFactor(const Words& words, const v8_plugs::Input& input,
                  const v8_plugs::Result& solution);
/// Which sets to move; nothing where there is no weigh-in sheet.
std::optional<matching_text::Shown> matchingShown(const v8_plugs::Input& input,
                                                  const v8_plugs::Result& solution);

}  // namespace ravnoves::v8_text
