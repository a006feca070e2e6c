#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QVector>
#include <functional>
#include <vector>

#include "text/result_row.h"

class QPageSize;
class QPagedPaintDevice;

namespace ravnoves {

/// What a report and a job card consist of. Texts are HTML fragments (escaped, with <sub>, <sup>,
/// <b>, <br/> at most), but for those that are called plain.
namespace paper {

enum class Tone { Text, Muted, Good, Warning, Error };

struct Table {
    QString caption = {};       ///< plain; may be empty
    QStringList headings = {};  ///< none: the table has no head
    /// Cells from left to right. A row of one cell in a table of several columns is a heading
    /// within it.
    QVector<QStringList> rows = {};
    QVector<bool> numbers = {};  ///< columns whose cells are at the right
    bool isSmall = false;
    QVector<int> widths = {};  ///< of the columns of a table as wide as the page, percent
};

struct Drawing {
    QString caption;                      ///< plain; may be empty where the figure says it
    QString description;                  ///< plain, for who cannot see it
    QSize size;                           ///< pixels of 1/96 inch
    std::function<void(QPainter&)> draw;  ///< into (0, 0) … size
};

/// @param text  plain
QString heading(const QString& text, int level = 1);
QString paragraph(const QString& html, Tone tone = Tone::Text);
/// Nothing of a table without rows.
QString table(const Table& table);
/// With the ± of its numbers, a star at the best.
Table tableOf(const Results& results);
/// What comes after it is not on the first page.
extern const QString endOfFirstPage;
/// Lines to write on, as many as the page has room for beside what follows.
extern const QString blankLines;

}  // namespace paper

/// A report or a job card: its HTML, with pictures by their number.
struct Paper {
    QString title;     ///< plain, of the file, and above all pages but the first
    QString foot;      ///< plain, below each page: whose it is
    QString pageOf;    ///< "Page %1 of %2"
    QString language;  ///< code
    QString body;      ///< HTML
    std::vector<paper::Drawing> drawings = {};
    bool isWrittenOn = false;  ///< its first page is a form, which must be whole

    /// Keeps the drawing; @return the HTML of its place, within a line
    QString picture(const paper::Drawing& drawing);
    /// The same as a paragraph with the caption.
    QString figure(const paper::Drawing& drawing);
    /// @param text  plain
    void say(const QString& text, paper::Tone tone = paper::Tone::Text) {
        body += paper::paragraph(text.toHtmlEscaped(), tone);
    }
};

inline constexpr QSizeF a4(210.0, 297.0);  ///< mm

/// Paints the pages. Text is text, pictures are vectors.
/// @param page   the whole sheet in the painter's units
/// @param next   begins another page at the same place, or returns false
/// @param sheet  its size, mm
void paintPaper(const Paper& paper, QPainter& painter, const QRectF& page,
                const std::function<bool()>& next, const QSizeF& sheet = a4);
/// Paints the pages in full size: on Letter laid out for it, otherwise for A4, or as large as the
/// device's paper allows.
/// @return false where the device cannot be painted on
bool printPaper(const Paper& paper, QPagedPaintDevice& device);
/// Upright, without margins of the device's own.
void setPaper(QPagedPaintDevice& device, const QPageSize& size);
QByteArray paperAsPdf(const Paper& paper, const QPageSize& size);
/// One file without references to other files.
QByteArray paperAsHtml(const Paper& paper);

}  // namespace ravnoves
