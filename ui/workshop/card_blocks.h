#pragma once

#include "workshop/card_page.h"
#include "workshop/job_header.h"
#include "workshop/model/words.h"

namespace ravnoves {

// Blocks that the card of every scene has. Places are in mm; what returns a number returns where
// the block ends.

/// Whose job it is.
struct CardHead {
    QString title;
    QString engine;  ///< beside the title
    const workshop::JobHeader& job;
    QString lastCaption;  ///< of the place that is the scene's own
    QString last;
};

double cardHead(CardPage& page, const Words& words, const CardHead& head, double y);

/// A box around what to do: a fact above, what follows from it below, a warning last.
struct CardAnswer {
    QString fact;
    QString action;
    QString more;
    QString warning;  ///< makes the box amber
};
double cardAnswer(CardPage& page, const CardAnswer& answer, double y);

/// What is left to be written by hand.
inline const QString byHand = QStringLiteral("…………………");

/// What the technician typed, and lines to write on down to `end`; nothing where there is no room.
void cardNotes(CardPage& page, const Words& words, const QString& notes, double y, double end);
/// What notes() needs at least, mm.
double cardNotesHeight(const CardPage& page, const QString& notes);

/// Lines to sign on, and the method in small print.
void cardSignatures(CardPage& page, const Words& words, const QString& method, double y);

}  // namespace ravnoves
