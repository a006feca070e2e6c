#include <QBuffer>
#include <QRegularExpression>

#include "pictures/clipped_svg.h"
#include "report/report.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace report;

namespace {

const QString style = QStringLiteral(R"(
body { font: 15px/1.45 "DejaVu Sans", "Segoe UI", Roboto, Helvetica, Arial, sans-serif; color: #1a1c20;
  background: #fff; max-width: 780px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; margin: 0 0 .2em; } .kind { color: #5b626c; margin: 0 0 1.5em; }
h2 { font-size: 1.25em; margin: 1.8em 0 .5em; border-bottom: 1px solid #c9ced6; }
h3 { font-size: 1.05em; margin: 1.4em 0 .4em; }
p { margin: .5em 0; }
p.muted { color: #5b626c; font-size: .9em; }
p.good, p.warning, p.error { padding: .3em .7em; border-left: 4px solid #1f7a3d; background: #f1f8f3; }
p.warning { border-color: #b26a00; background: #fdf6ea; }
p.error { border-color: #b3261e; background: #fdf0ef; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: .6em 0 1.1em; font-size: .92em; width: 100%; }
table.small { font-size: .78em; }
caption { text-align: left; color: #5b626c; padding-bottom: .25em; }
th, td { text-align: left; vertical-align: top; padding: .2em .6em .2em 0; border-bottom: 1px solid #e2e5ea; }
th { border-bottom: 1.5px solid #8a929e; } th.group { padding-top: .7em; border-bottom: 1px solid #c9ced6; }
.number { text-align: right; }
td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
figure { margin: 1em 0; } figcaption { color: #5b626c; font-size: .9em; }
svg { display: block; width: 100%; height: auto; overflow: hidden; }
svg text { font-family: "DejaVu Sans Condensed", "Arial Narrow", Arial, sans-serif; }
footer { margin-top: 2.5em; color: #5b626c; font-size: .85em; }
@media print { body { max-width: none; margin: 0; } tr, figure { break-inside: avoid; } }
)");

/// An SVG that stands within a page: without a head, its names its own.
QString inlineSvg(const Drawing& figure, int number) {
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

struct HtmlWriter {
    QString html;
    int figures = 0;

    void operator()(const Heading& heading) {
        html += QStringLiteral("<h%1>%2</h%1>\n")
                    .arg(heading.level + 1)
                    .arg(heading.text.toHtmlEscaped());
    }
    void operator()(const Paragraph& paragraph) {
        static const QStringList names{QString(), QStringLiteral("muted"), QStringLiteral("good"),
                                       QStringLiteral("warning"), QStringLiteral("error")};
        const QString& name = names[static_cast<int>(paragraph.kind)];
        html += (name.isEmpty() ? QStringLiteral("<p>")
                                : QStringLiteral("<p class=\"%1\">").arg(name)) +
                paragraph.html + QStringLiteral("</p>\n");
    }
    void operator()(const Table& table) {
        html += QStringLiteral("<div class=\"wide\">") + tableAsHtml(table) +
                QStringLiteral("</div>\n");
    }
    void operator()(const Drawing& figure) {
        html += QStringLiteral("<figure>%1").arg(inlineSvg(figure, ++figures));
        if (!figure.caption.isEmpty()) {
            html +=
                QStringLiteral("<figcaption>%1</figcaption>").arg(figure.caption.toHtmlEscaped());
        }
        html += QStringLiteral("</figure>\n");
    }
};

}  // namespace

QString tableAsHtml(const Table& table) {
    QString html = QStringLiteral("<table%1>\n")
                       .arg(table.isSmall ? QStringLiteral(" class=\"small\"") : QString());
    if (!table.caption.isEmpty()) {
        html += QStringLiteral("<caption>%1</caption>\n").arg(table.caption.toHtmlEscaped());
    }
    const auto number = [&](qsizetype column) {
        return table.numbers.value(column) ? QStringLiteral(" class=\"number\"") : QString();
    };
    if (!table.headings.isEmpty()) {
        html += QStringLiteral("<thead><tr>");
        for (qsizetype i = 0; i < table.headings.size(); ++i) {
            html += QStringLiteral("<th scope=\"col\"%1>%2</th>").arg(number(i), table.headings[i]);
        }
        html += QStringLiteral("</tr></thead>\n");
    }
    html += QStringLiteral("<tbody>\n");
    for (const QStringList& row : table.rows) {
        html += QStringLiteral("<tr>");
        if (row.size() == 1 && table.headings.size() > 1) {
            html += QStringLiteral("<th class=\"group\" colspan=\"%1\">%2</th>")
                        .arg(table.headings.size())
                        .arg(row.first());
        } else {
            for (qsizetype i = 0; i < row.size(); ++i) {
                html += QStringLiteral("<td%1>%2</td>").arg(number(i), row[i]);
            }
        }
        html += QStringLiteral("</tr>\n");
    }
    return html + QStringLiteral("</tbody></table>");
}

QByteArray reportAsHtml(const Report& report) {
    HtmlWriter writer;
    for (const Item& item : report.items) {
        std::visit(writer, item);
    }
    const QString title = report.title.toHtmlEscaped();
    return QStringLiteral(
               "<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\"/>\n"
               "<meta name=\"generator\" content=\"%2\"/>\n<title>")
               .arg(report.language, report.program.toHtmlEscaped())
               .toUtf8() +
           title.toUtf8() + QByteArrayLiteral("</title>\n<style>") + style.toUtf8() +
           QByteArrayLiteral("</style>\n</head>\n<body>\n<h1>") + title.toUtf8() +
           QByteArrayLiteral("</h1>\n<p class=\"kind\">") +
           report.subtitle.toHtmlEscaped().toUtf8() + QByteArrayLiteral("</p>\n") +
           writer.html.toUtf8() + QByteArrayLiteral("<footer>") +
           QStringLiteral("%1, %2").arg(report.program, report.date).toHtmlEscaped().toUtf8() +
           QByteArrayLiteral("</footer>\n</body>\n</html>\n");
}

}  // namespace ravnoves
