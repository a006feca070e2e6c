#pragma once

#include <QCoreApplication>
#include <vector>

#include "case-file/verdict.h"
#include "paper/paper.h"

namespace ravnoves {

class Patience;
class SceneModel;
class ScenePage;

/// Words of reports.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ReportWords)
};

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
CaseParts caseParts(ScenePage& page, Paper& report, const Patience& patience);

/// What the case gives, as its file has it: the numbers of each object in one table with their
/// units, each list of objects in one of its own.
std::vector<paper::Table> inputTables(const SceneModel& model);
/// What the case leaves out and what represents it, each with the name that the form has for it;
/// without rows where it leaves out nothing.
paper::Table leftOut(const SceneModel& model);

/// The tolerances of a case and their effect on the watched results; nothing where it has none. The
/// study is computed now, within a minute.
void addTolerances(Paper& report, SceneModel& model, const Patience& patience);

}  // namespace ravnoves
