#pragma once

#include <memory>

#include "paper/paper.h"

class QWidget;

namespace ravnoves {

/// A plot of the page, as tall as on the page, or a picture in its shape there.
paper::Drawing drawingOf(QWidget* figure);
/// A figure that was made for the report, at its size.
paper::Drawing drawingOf(const std::shared_ptr<QWidget>& figure);

}  // namespace ravnoves
