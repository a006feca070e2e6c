#pragma once

#include <QList>
#include <QObject>
#include <QRectF>
#include <QSize>
#include <QString>
#include <functional>
#include <utility>

#include "pictures/file_dialogs.h"

class QPainter;
class QWidget;

namespace ravnoves {

struct CsvFormat;

/// What one takes along from a figure, as its context menu (right click, Menu key, Shift+F10): its
/// picture as a file or on the clipboard, and the numbers that it shows, where there are any;
/// before them the figure's own actions. On the screen a figure with the focus has a frame.
class FigureMenu : public QObject {
    Q_OBJECT

  public:
    using Draw = std::function<void(QPainter& painter, const QRectF& target)>;
    /// The numbers as a table; an empty text where there are none.
    using Data = std::function<QString(const CsvFormat& format)>;

    /// It belongs to the figure.
    /// @param file  name of a picture that is suggested, without its ending
    FigureMenu(QWidget* figure, QString file, Draw draw);

    void setData(Data data) { data_ = std::move(data); }

    /// True where it has numbers to show, but now none.
    bool isEmpty() const;

    /// Writes a PNG, SVG or PDF, or the data as CSV for spreadsheets, by the file's ending.
    /// @return an empty string, or what went wrong
    QString write(const QString& path, const QString& title) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void open(const QPoint& at);
    void copyPicture() const;

    QWidget* figure_;
    QString file_;
    Draw draw_;
    Data data_;
};

/// Declares a widget a picture of the result: a report draws it, as plots, and it has their menu.
/// It accepts Tab, so that the menu is reached without a mouse.
/// @param data  its numbers
void makeFigure(QWidget* widget, FigureMenu::Data data = {});
bool isFigure(const QWidget* widget);
/// True for a figure that says no more than how to fill it.
bool isEmptyFigure(const QWidget* widget);

/// Draws a widget that paints itself, without those in it.
void drawFigure(QWidget* figure, QPainter& painter, const QRectF& target);

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

/// True where a widget that paints itself is not on the screen but in a drawing, which takes lines
/// and text rather than pixels, or in a picture that is larger than it.
bool drawsForFile(const QPainter& painter, const QWidget& widget);

}  // namespace ravnoves
