#pragma once

#include <QList>
#include <QSize>
#include <QString>
#include <functional>

#include "pictures/file_dialogs.h"

class QPainter;
class QWidget;

namespace ravnoves {

/// Draws a picture; `scale` is its pixels per unit of size.
using DrawPicture = std::function<void(QPainter& painter, double scale)>;

/// Writes what `draw` draws as PNG, SVG or PDF, by the file's ending; another one is rejected. A
/// PNG prints, with 300 dots to the inch, as large as a screen with 96 shows it.
/// @return an empty string, or what went wrong
QString writePicture(const QString& path, const QSize& size, const QString& title,
                     const DrawPicture& draw);

/// Prompts for a place to save; `write` writes there.
/// @param others  formats beside the pictures'
void savePictureWithDialog(QWidget* parent, const QString& title, const QString& name,
                           const QList<FileFormat>& others,
                           const std::function<QString(const QString& path)>& write);

/// True on a device that takes lines and text rather than pixels.
bool takesLines(const QPainter& painter);
/// True where a widget that paints itself is not on the screen but in a drawing, which takes lines
/// and text rather than pixels, or in a picture that is larger than it.
bool drawsForFile(const QPainter& painter, const QWidget& widget);

}  // namespace ravnoves
