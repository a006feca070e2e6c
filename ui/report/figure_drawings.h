#pragma once

#include <memory>

#include "paper/paper.h"

class QWidget;

namespace ravnoves {

class PlotView;

/// A plot of the page, as tall as on the page.
paper::Drawing drawingOf(PlotView* plot);
/// A plot that was made for the report, at its size.
paper::Drawing drawingOf(const std::shared_ptr<PlotView>& plot);
/// A picture of the page, in its shape there.
paper::Drawing drawingOf(QWidget* picture);
/// The same of one that fills any shape.
paper::Drawing drawingOf(QWidget* picture, const QSize& size);

}  // namespace ravnoves
