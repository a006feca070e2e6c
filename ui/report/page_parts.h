#pragma once

#include <QList>
#include <QString>
#include <vector>

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
    QStringList empty;  ///< titles of plots in which there is nothing to see

    bool isEmpty() const { return words.empty() && tables.empty() && figures.empty(); }
};

/// Brings every tab of a page to the front, waits for what it computes, and collects what answers:
/// labels whose text can be selected, result tables, plots, and pictures (isFigure). What stands
/// beside the tabs comes first. The figures draw the page's own widgets: they live as long as it.
std::vector<PageGroup> pageParts(ScenePage& page, const Patience& patience);

}  // namespace ravnoves
