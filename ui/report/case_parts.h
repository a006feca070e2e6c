#pragma once

#include <QString>
#include <vector>

#include "case-file/verdict.h"
#include "report/report.h"

namespace ravnoves {

class Patience;
class ScenePage;

/// What stands on one tab of a page, or beside the tabs.
struct PageGroup {
    QString title;  ///< plain; of the tab, empty beside them
    std::vector<report::Item> words;
    std::vector<report::Item> tables;
    std::vector<report::Item> figures;

    bool isEmpty() const { return words.empty() && tables.empty() && figures.empty(); }
};

/// As what a report shows a line that means this for the answer.
report::Paragraph::Kind kindOf(Severity severity);

/// What a page shows, part by part, with its pictures: those beside the tabs first, then tab by
/// tab. Nothing of the page moves for it: plots and tables are made for the report alone.
std::vector<PageGroup> caseParts(ScenePage& page, const Patience& patience);

}  // namespace ravnoves
