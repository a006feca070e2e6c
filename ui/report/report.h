#pragma once

#include <QCoreApplication>
#include <QPageSize>
#include <QPainter>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QVector>
#include <functional>
#include <variant>
#include <vector>

namespace ravnoves {

/// A report as its writers see it: a title and what follows, in order. Texts are HTML fragments
/// (escaped, with <sub>, <sup>, <b>, <br/> at most), but for those that are called plain.
namespace report {

struct Heading {
    QString text;  ///< plain
    int level = 1;
};

struct Paragraph {
    enum class Kind { Text, Muted, Good, Warning, Error };
    QString html;
    Kind kind = Kind::Text;
};

struct Table {
    QString caption;       ///< plain; may be empty
    QStringList headings;  ///< none: the table has no head
    /// Cells from left to right. A row of one cell in a table of several columns is a heading
    /// within it.
    QVector<QStringList> rows;
    QVector<bool> numbers;  ///< columns whose cells are at the right
    bool isSmall = false;
};

struct Drawing {
    QString caption;                      ///< plain; may be empty where the figure says it
    QString description;                  ///< plain, for who cannot see it
    QSize size;                           ///< pixels of 1/96 inch
    std::function<void(QPainter&)> draw;  ///< into (0, 0) … size
};

using Item = std::variant<Heading, Paragraph, Table, Drawing>;

}  // namespace report

struct Report {
    QString title;     ///< plain, of the case
    QString subtitle;  ///< plain: what kind of report this is
    QString program;   ///< plain: name and version
    QString date;      ///< plain
    QString language;  ///< code
    QPageSize::PageSizeId paper = QPageSize::A4;
    std::vector<report::Item> items;

    /// @param title  plain
    void head(const QString& title, int level = 1) {
        items.push_back(report::Heading{title, level});
    }
    /// @param text  plain
    void say(const QString& text, report::Paragraph::Kind kind = report::Paragraph::Kind::Text) {
        items.push_back(report::Paragraph{text.toHtmlEscaped(), kind});
    }
};

/// Words of reports.
struct ReportWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ReportWords)
};

QString tableAsHtml(const report::Table& table);
/// Pages of the report's paper; text is text, figures are vectors.
QByteArray reportAsPdf(const Report& report);
/// One file without references to other files.
QByteArray reportAsHtml(const Report& report);

}  // namespace ravnoves
