#pragma once

#include "shop/model/journal.h"
#include "shop/model/words.h"

namespace ravnoves {

/// What lists of the journal's jobs say of one.
struct ListedJob {
    QString engine;
    QString result;
};
ListedJob listedJob(const Words& words, const JournalJob& job);

}  // namespace ravnoves
