#pragma once

#include <vector>

#include "model/part.h"
#include "plot/model/figure.h"
#include "text/result_row.h"

namespace ravnoves {

class StudyModel;
class SweepModel;
struct StudyAnswer;

/// A result over the input that is swept, of a model that has a sweep; below it, where those are
/// not all, the share of feasible samples.
std::vector<Figure> sweepFigures(const StudyModel& study, const SweepModel& model);
/// The finding of a sweep, or the reason for a missing one, in a sentence.
QString sweepWords(const StudyModel& study, const SweepModel& model);
/// How the samples of a result are distributed about its limits. Null: an empty chart.
Figure histogramFigure(const StudyModel& study, const StudyAnswer* value);
/// The answers of the watched results; without any, the columns alone.
Results foundResults(const StudyModel& study);
/// The share of each input in a result's variance, the largest at the top: a bar alone, and its
/// paler end with its interactions. Null: the columns alone.
Results tornado(const StudyModel& study, const StudyAnswer* value);
/// Of the answers: how many samples were solved and are feasible, and why others were rejected; few
/// feasible ones are a warning, and what the study says of its answers is one.
Notes notesOf(const StudyModel& study);

}  // namespace ravnoves
