#pragma once

#include "shop/card_page.h"
#include "shop/job_header.h"
#include "shop/model/words.h"

namespace ravnoves {

// Blocks that the card of every scene has. Places are in mm; what returns a number returns where
// the block ends.

/// Whose job it is.
struct CardHead {
    QString title;
    QString engine;  ///< beside the title
    const shop::JobHeader& job;
    QString lastCaption;  ///< of the place that is the scene's own
    QString last;
};

double cardHead(CardPage& page, const Words& words, const CardHead& head, double y);

/// What is left to be written by hand.
inline const QString byHand = QStringLiteral("…………………");

/// What the technician typed, all of it; on the first sheet lines to write on fill its room.
double cardNotes(CardPage& page, const Words& words, const QString& notes, double y);
/// What they need at least, mm.
double cardNotesHeight(const CardPage& page, const QString& notes);

/// Lines to sign on, and the method in small print.
void cardSignatures(CardPage& page, const Words& words, const QString& method, double y);

}  // namespace ravnoves
