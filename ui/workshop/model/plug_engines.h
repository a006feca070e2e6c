#pragma once

#include "shop/model/journal.h"
#include "v8-plugs/input.h"
#include "v8-plugs/result.h"

/// What belongs to the plugs of an engine.
namespace ravnoves::plug_engines {

/// The limit that new jobs begin with, kg·m.
double shopsTolerance();
void keepTolerance(double tolerance);

/// Whether it is still the engine that was named; what the preset does not know may be filled in.
bool isSame(const v8_plugs::Input& input, const v8_plugs::Input& named);
/// What the next job of the same engine begins with.
v8_plugs::Input nextOf(const v8_plugs::Input& before);
/// What the journal keeps of the plugs.
void noteInJournal(JournalJob& job, const v8_plugs::Input& input, const v8_plugs::Result& solution);

}  // namespace ravnoves::plug_engines
