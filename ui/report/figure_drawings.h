#pragma once

#include <memory>

#include "report/report.h"

class QWidget;

namespace ravnoves {

class PlotView;
class ResultTable;

/// A plot of the page, as high as it is there.
report::Drawing drawingOf(PlotView* plot);
/// A plot that was made for the report, at its size.
report::Drawing drawingOf(std::shared_ptr<PlotView> plot);
/// A picture of the page, at a size of its own.
report::Drawing drawingOf(QWidget* picture, const QSize& size);

/// A table of results, with its differences and ± below the numbers.
report::Table tableOf(const ResultTable& table);

}  // namespace ravnoves
