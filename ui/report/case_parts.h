#pragma once

#include <QString>
#include <vector>

#include "case-file/verdict.h"
#include "paper/paper.h"

namespace ravnoves {

class Patience;
class ScenePage;

/// What a page shows on one tab, or beside the tabs.
struct PageGroup {
    QString tab = {};    ///< its name; empty beside them
    QString title = {};  ///< plain
    QString words = {};  ///< HTML, as tables and figures
    QString tables = {};
    QString figures = {};
};

/// The answer for the first page, and all else by tabs.
struct CaseParts {
    PageGroup answer;
    std::vector<PageGroup> groups;
};

/// As what a report shows a line that means this for the answer.
paper::Tone toneOf(Severity severity);

/// The content of a page, part by part, with its pictures. The answer is beside the tabs: its words
/// and tables, and the picture of the mechanism. The page is unchanged: plots and tables are made
/// for the report alone, which keeps the pictures.
/// @param share  of the progress of the whole report
CaseParts caseParts(ScenePage& page, Paper& report, const Patience& patience, double share);

}  // namespace ravnoves
