#pragma once

#include <QStringList>
#include <QVector>

#include "bob-weights/solver.h"
#include "case-file/input_error.h"
#include "shop/model/matching_text.h"
#include "shop/model/words.h"
#include "workshop/input.h"

/// What page and job card say of a bob weight and of the correction.
namespace ravnoves::bob_text {

/// "V-8, 90°", "4 in line", "Boxer, 6".
QString engineName(const Words& words, const bob_weights::Engine& engine);
/// The same of the English name by which the journal knows it.
QString engineName(const Words& words, const QString& english);
/// Why engine and factor give no answer; empty where they do, or where something is missing.
QString contradiction(const Words& words, const bob_weights::Input& input);
/// The rule that the input breaks first, with its place on the form; empty where it breaks none, or
/// where there is no bob weight, which is said by itself.
QString brokenRule(const Words& words, const workshop::Input& input,
                   const bob_weights::Result& result);
/// "Factor 50 % + 2 % overbalance, by theory 50 %. …"
QString factor(const Words& words, const bob_weights::Input& input,
               const bob_weights::Result& result);
/// What may remain, and where that comes from.
QString limits(const Words& words, const bob_weights::Input& input,
               const bob_weights::Result& result);
/// The angles that a correction still needs, each with its place; nothing where none is begun, or
/// the readings pass as they are.
QStringList missingAngles(const Words& words, const workshop::Input& input,
                          const bob_weights::Result& result);
/// As the machine is set up to call it.
QString planeName(const Words& words, const workshop::Machine& machine, std::size_t plane);
/// Place of the first run that was read: 1 where holes were there before it, else 0.
std::size_t firstRun(const workshop::Input& input);
std::size_t firstRun(const bob_weights::Result& result);
/// What the machine read, where that was not in the planes; empty where it was.
QString asReadNote(const Words& words, const bob_weights::Input& input,
                   const bob_weights::Result& result);
/// What is wrong with the newest run that does not hold, with its name where it is an earlier one;
/// empty where all do.
QString otherRun(const Words& words, const bob_weights::Result& result);
/// What counts as 0 because it was not given; empty where everything was.
QString notGiven(const Words& words, const bob_weights::Result& result);
/// Runs whose holes were planned before their readings were put right.
QStringList correctedRuns(const Words& words, const workshop::Input& input,
                          const bob_weights::Result& result);
/// What the depths are measured to; empty without holes.
QString holeNote(const Words& words, const bob_weights::Result& result);
/// What the holes are planned for: the drill's point, the metal of crankshaft and slugs; empty
/// without holes.
QString metals(const Words& words, const bob_weights::Input& input,
               const bob_weights::Result& result);
/// What falls short, plane by plane.
QStringList shortfalls(const Words& words, const workshop::Machine& machine,
                       const bob_weights::Result& result);
/// Which cylinders each crankpin carries, "1+5"; empty where they do not share out.
QStringList cylindersOfCrankpins(const bob_weights::Input& input);
/// Whether the crankpins differ, so that the bob weight is no more than their mean.
bool isMean(const Words& words, const bob_weights::Result& result);
/// Bob weight of each crankpin's own parts.
QString weighIn(const Words& words, const bob_weights::Input& input,
                const bob_weights::Result& result);
/// Which parts to weigh again before any is moved; empty where the weights are believed.
QString weighAgain(const Words& words, const bob_weights::Input& input);
/// The bob weights after the sets are moved; empty where none is to be.
QString placedWeighIn(const Words& words, const bob_weights::Input& input,
                      const bob_weights::Result& result);
/// Which sets to move; nothing where no column is weighed whole, or weights are doubted.
std::optional<matching_text::Shown> matchingShown(const bob_weights::Input& input,
                                                  const bob_weights::Result& result);
QString balance(const Words& words, bob_weights::Balance balance);

QStringList lineHead(const Words& words);
ResultRows lines(const Words& words, const bob_weights::Result& result);
/// "Before", "Run 1".
QString runName(const Words& words, std::size_t run);
QStringList runHead(const Words& words, const workshop::Machine& machine);
/// The runs of the machine, their readings taken to the planes.
ResultRows runs(const Words& words, const bob_weights::Result& result);
QStringList planeHead(const Words& words);
ResultRows planes(const Words& words, const workshop::Machine& machine,
                  const bob_weights::Result& result);
QStringList holeHead(const Words& words);
ResultRows holes(const Words& words, const workshop::Input& input,
                 const bob_weights::Result& result);
/// Those of one plane.
ResultRows holes(const Words& words, const workshop::Input& input,
                 const bob_weights::Result& result, std::size_t plane);
QStringList drilledHead(const Words& words);
/// What was drilled and pressed in after earlier runs, run by run.
/// @param plane  that one alone; empty: both
ResultRows drilled(const Words& words, const workshop::Machine& machine,
                   const bob_weights::Result& result,
                   std::optional<std::size_t> plane = std::nullopt);
/// A hole or slug of the record after a run: "Run 1, rear plane: ⌀ 10 mm".
QString drilledName(const Words& words, const workshop::Input& input, std::size_t run,
                    const bob_weights::DrilledHole& hole);
/// How the machine is set up, as the card says it.
QString machineText(const Words& words, const workshop::Machine& machine);

}  // namespace ravnoves::bob_text
