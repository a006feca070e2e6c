#pragma once

#include <QString>
#include <QVector>
#include <utility>

namespace ravnoves {

/// What the results of a table are, with their formulas: the name of a row or the heading of a
/// column, and what it means.
using ResultTips = QVector<std::pair<QString, QString>>;

}  // namespace ravnoves
