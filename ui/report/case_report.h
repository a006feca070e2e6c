#pragma once

#include <QString>

#include "report/patience.h"
#include "report/report_choice.h"

namespace ravnoves {

class CaseDocument;
class ScenePage;

/// True for a name that a report can be written to: .pdf, .html or .htm.
bool isReportName(const QString& path);
/// Writes the case of a page, which is shown, as a report: PDF or HTML by the suffix. What the
/// page computes in the background is waited for; its tabs, size and theme are as before then.
/// Where it fails, nothing is left behind.
/// Never writes over an open case, or over a file that one reads.
/// @return an empty string, or what is wrong
QString writeReport(ScenePage& page, CaseDocument& document, const QString& path,
                    const ReportChoice& choice, const Patience& patience = Patience());

}  // namespace ravnoves
