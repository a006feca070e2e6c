#pragma once

#include <QCoreApplication>

namespace ravnoves {

/// Words of reports.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ReportWords)
};

}  // namespace ravnoves
