#pragma once

#include <QString>
#include <vector>

#include "case-file/verdict.h"
#include "report/report.h"

namespace ravnoves {

class Patience;
class ScenePage;

/// What a page shows on one tab, or beside the tabs.
struct PageGroup {
    QString tab = {};    ///< its name; empty beside them
    QString title = {};  ///< plain
    std::vector<report::Item> words = {};
    std::vector<report::Item> tables = {};
    std::vector<report::Item> figures = {};

    bool isEmpty() const { return words.empty() && tables.empty() && figures.empty(); }
};

/// The answer for the first page, and all else by tabs.
struct CaseParts {
    PageGroup answer;
    std::vector<PageGroup> groups;
};

/// As what a report shows a line that means this for the answer.
report::Paragraph::Kind kindOf(Severity severity);

/// The content of a page, part by part, with its pictures. The answer is beside the tabs: its words
/// and tables, and the picture of the mechanism. The page is unchanged: plots and tables are made
/// for the report alone.
CaseParts caseParts(ScenePage& page, const Patience& patience);

}  // namespace ravnoves
