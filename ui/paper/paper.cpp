#include "paper/paper.h"

#include <QBuffer>
#include <QRegularExpression>
#include <algorithm>

#include "pictures/clipped_svg.h"
#include "theme/theme.h"

namespace ravnoves {

namespace paper {

const QString endOfFirstPage = QStringLiteral("<p class=\"break\"></p>");
const QString blankLines = QStringLiteral("<p class=\"lines\"><img src=\"lines\"/></p>");

QString heading(const QString& text, int level) {
    return QStringLiteral("<h%1>%2</h%1>\n").arg(level + 1).arg(text.toHtmlEscaped());
}

QString paragraph(const QString& html, Tone tone) {
    static const QStringList names{QStringLiteral("text"), QStringLiteral("muted"),
                                   QStringLiteral("good"), QStringLiteral("warning"),
                                   QStringLiteral("error")};
    return html.isEmpty() ? QString()
                          : QStringLiteral("<p class=\"%1\">").arg(names[static_cast<int>(tone)]) +
                                html + QStringLiteral("</p>\n");
}

QString table(const Table& table) {
    if (table.rows.isEmpty()) {
        return {};
    }
    QString html;
    if (!table.caption.isEmpty()) {
        html = QStringLiteral("<p class=\"caption\">%1</p>\n").arg(table.caption.toHtmlEscaped());
    }
    html += table.widths.isEmpty()
                ? QStringLiteral("<div class=\"wide\"><table width=\"100%\"%1>\n")
                      .arg(table.isSmall ? QStringLiteral(" class=\"small\"") : QString())
                : QStringLiteral("<div><table width=\"100%\">\n");
    const auto cells = [&](const QString& begin, const QString& end, const QStringList& texts) {
        html += QStringLiteral("<tr>");
        for (qsizetype i = 0; i < texts.size(); ++i) {
            html += begin;
            if (table.numbers.value(i)) {
                html += QStringLiteral(" class=\"number\"");
            }
            if (i < table.widths.size()) {
                html += QStringLiteral(" width=\"%1%\"").arg(table.widths[i]);
            }
            html += u'>' + texts[i] + end;
        }
        html += QStringLiteral("</tr>\n");
    };
    if (!table.headings.isEmpty()) {
        html += QStringLiteral("<thead>");
        cells(QStringLiteral("<th scope=\"col\""), QStringLiteral("</th>"), table.headings);
        html += QStringLiteral("</thead>\n");
    }
    html += QStringLiteral("<tbody>\n");
    for (const QStringList& row : table.rows) {
        if (row.size() == 1 && table.headings.size() > 1) {
            html += QStringLiteral("<tr><th class=\"group\" colspan=\"%1\">%2</th></tr>\n")
                        .arg(table.headings.size())
                        .arg(row.first());
        } else {
            cells(QStringLiteral("<td"), QStringLiteral("</td>"), row);
        }
    }
    return html + QStringLiteral("</tbody></table></div>\n");
}

Table tableOf(const Results& results) {
    Table table;
    for (const ResultColumn& column : results.columns) {
        const qsizetype place = table.headings.size();
        // What has no digits begins beside the column before it: a unit beside its number.
        table.numbers << (place > 0 && std::ranges::any_of(results.rows, [&](const ResultRow& row) {
                              return std::ranges::any_of(row.value(place).text,
                                                         [](QChar sign) { return sign.isDigit(); });
                          }));
        table.headings << column.heading.toHtmlEscaped();
    }
    for (const ResultRow& row : results.rows) {
        QStringList cells;
        for (const ResultCell& cell : row) {
            cells << cell.marked().toHtmlEscaped().replace(u'\n', QLatin1String("<br/>"));
            if (!cell.spread.isEmpty()) {
                cells.last() += QStringLiteral("\u00A0<small>%1</small>")
                                    .arg(QString(cell.spread).replace(u' ', QChar::Nbsp));
            }
        }
        table.rows << cells;
    }
    return table;
}

}  // namespace paper

namespace {

const QString webStyle = QStringLiteral(R"(
body { font: 15px/1.45 "DejaVu Sans", "Segoe UI", Roboto, Helvetica, Arial, sans-serif; color: #1a1c20;
  background: #fff; max-width: 780px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin: 0 0 .2em; } .kind { color: #5b626c; margin: 0 0 1.5em; }
h2 { font-size: 1.25em; margin: 1.8em 0 .5em; border-bottom: 1px solid #c9ced6; }
h3 { font-size: 1.05em; margin: 1.4em 0 .4em; }
p { margin: .5em 0; }
p.muted, p.caption { color: #5b626c; font-size: .9em; } p.caption { margin: .6em 0 .25em; }
p.good, p.warning, p.error { padding: .3em .7em; border-left: 4px solid #1f7a3d; background: #f1f8f3; }
p.warning { border-color: #b26a00; background: #fdf6ea; }
p.error { border-color: #b3261e; background: #fdf0ef; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 0 0 1.1em; font-size: .92em; width: 100%; }
table.small { font-size: .78em; }
th, td { text-align: left; vertical-align: top; padding: .2em .6em .2em 0; border-bottom: 1px solid #e2e5ea; }
th { border-bottom: 1.5px solid #8a929e; } th.group { padding-top: .7em; border-bottom: 1px solid #c9ced6; }
.number { text-align: right; }
td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
p.figure { margin: 1em 0; color: #5b626c; font-size: .9em; } p.figure br { display: none; }
svg { display: block; width: 100%; height: auto; overflow: hidden; }
svg text { font-family: "DejaVu Sans Condensed", "Arial Narrow", Arial, sans-serif; }
footer { margin-top: 2.5em; color: #5b626c; font-size: .85em; }
@media print { body { max-width: none; margin: 0; } tr, p.figure { break-inside: avoid; } }
)");

/// An SVG that stands within a page: without a head, its names its own.
QString inlineSvg(const paper::Drawing& figure, qsizetype number) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    ClippedSvg device(buffer, figure.size);
    QPainter painter(&device);
    painter.setFont(Theme::font());
    figure.draw(painter);
    painter.end();
    QString svg = QString::fromUtf8(buffer.data());
    svg.remove(0, std::max<qsizetype>(svg.indexOf(QLatin1String("<svg")), 0));
    static const QRegularExpression head(QStringLiteral("^<svg [^>]*>"));
    svg.replace(head, QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                     "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                                     "viewBox=\"0 0 %1 %2\" style=\"max-width:%1px\" role=\"img\" "
                                     "aria-label=\"%3\">")
                          .arg(figure.size.width())
                          .arg(figure.size.height())
                          .arg((figure.description.isEmpty() ? figure.caption : figure.description)
                                   .toHtmlEscaped()));
    svg.remove(QLatin1String("<title></title>"));
    static const QRegularExpression id(QStringLiteral("id=\"([^\"]+)\""));
    svg.replace(id, QStringLiteral("id=\"f%1-\\1\"").arg(number));
    return svg.replace(QLatin1String("url(#"), QStringLiteral("url(#f%1-").arg(number)).trimmed();
}

QString placeOf(qsizetype number) {
    return QStringLiteral("<img src=\"%1\"/>").arg(number);
}

}  // namespace

QString Paper::picture(const paper::Drawing& drawing) {
    drawings.push_back(drawing);
    return placeOf(std::ssize(drawings) - 1);
}

QString Paper::figure(const paper::Drawing& drawing) {
    const QString caption = drawing.caption.isEmpty()
                                ? QString()
                                : QStringLiteral("<br/>") + drawing.caption.toHtmlEscaped();
    return QStringLiteral("<p class=\"figure\">%1</p>\n").arg(picture(drawing) + caption);
}

QByteArray paperAsHtml(const Paper& paper) {
    QString body = paper.body;
    for (qsizetype i = 0; i < std::ssize(paper.drawings); ++i) {
        body.replace(placeOf(i), inlineSvg(paper.drawings[static_cast<std::size_t>(i)], i));
    }
    return QStringLiteral(
               "<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\"/>\n"
               "<meta name=\"generator\" content=\"Ravnoves " RAVNOVES_VERSION
               "\"/>\n<title>%2</title>\n<style>%3</style>\n</head>\n<body>\n%4"
               "<footer>%5</footer>\n</body>\n</html>\n")
        .arg(paper.language, paper.title.toHtmlEscaped(), webStyle, body,
             paper.foot.toHtmlEscaped())
        .toUtf8();
}

}  // namespace ravnoves
