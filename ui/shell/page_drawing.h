#pragma once

class QPainter;
class QWidget;

namespace ravnoves {

/// Draws a page with lines and text, for SVG and PDF: QWidget::render() mixes up the clipping of
/// nested widgets there. Plots are drawn as their own files are.
void drawPage(QPainter& painter, QWidget* page);

}  // namespace ravnoves
