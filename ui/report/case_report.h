#pragma once

#include <QString>

#include "report/patience.h"

namespace ravnoves {

class CaseDocument;
class ScenePage;

/// True for a name that a report can be written to: .pdf, .html or .htm.
bool isReportName(const QString& path);
/// Writes the case of a page, which is shown, as a report with what the user chose last: PDF or
/// HTML by the suffix. It waits for the page's background work; tabs, size and theme are as before
/// then. A failure leaves no file. Never overwrites an open case, or a file that one reads.
/// @return an empty string, or the fault
QString writeReport(ScenePage& page, CaseDocument& document, const QString& path,
                    const Patience& patience = Patience());

}  // namespace ravnoves
