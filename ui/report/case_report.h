#pragma once

#include <QString>

namespace ravnoves {

class ScenePage;

/// True for a name that a report can be written to: .pdf, .html or .htm.
bool isReportName(const QString& path);
/// Writes the case of a page, which is shown, as a report: PDF or HTML by the suffix. What the
/// page computes in the background is waited for; its tabs, size and theme are as before then.
/// Where it fails, nothing is left behind.
/// @param caseFile  its path; empty where it has none
/// @return an empty string, or what is wrong
QString writeReport(ScenePage& page, const QString& caseFile, const QString& path);

}  // namespace ravnoves
