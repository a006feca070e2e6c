#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPageLayout>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextOption>
#include <QTextTable>
#include <algorithm>
#include <cmath>
#include <memory>

#include "numerics/units.h"
#include "report/report.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace report;

namespace {

// In pixels of 1/96 inch, as the figures are; as wide as A4 leaves, which Letter does too.
constexpr double perMillimetre = 96.0 / (units::inch.to_si / units::mm);
constexpr double pageWidth = 210.0 * perMillimetre;
constexpr double left = 20.0 * perMillimetre;
constexpr double top = 22.0 * perMillimetre;
constexpr double width = pageWidth - left - 15.0 * perMillimetre;
constexpr double cellPad = 2.0;

constexpr QRgb ink = 0xff1a1c20;
constexpr QRgb pale = 0xff5b626c;
constexpr QRgb hairline = 0xffd5d9df;
constexpr QRgb rule = 0xff8a929e;

const QString tableStyle = QStringLiteral(
    "table { border-collapse: collapse; } "
    "th, td { border-bottom: 1px solid #d5d9df; padding: 2px 9px 2px 0; text-align: left; } "
    "th { border-bottom-color: #8a929e; } th.group { border-bottom-color: #d5d9df; } "
    ".number { text-align: right; } td.number { white-space: nowrap; }");

/// Of one size, whatever the size of the text on the screen.
QFont paperFont(int pixels, bool bold = false) {
    QFont font = Theme::font(pixels, bold);
    font.setPixelSize(pixels);
    return font;
}

/// Text as wide as the page at most, of any length.
class RichText {
  public:
    /// @param widest  a table whose words have no room beside each other is shrunk; of a wider one
    ///                and of other text words are broken
    RichText(const QString& html, int pixels, bool bold = false, QRgb colour = ink,
             Qt::Alignment alignment = Qt::AlignLeft, double room = width, double widest = 0.0)
        : document_(std::make_shared<QTextDocument>()), colour_(colour) {
        document_->setDocumentMargin(0.0);
        document_->setUseDesignMetrics(true);
        document_->setDefaultFont(paperFont(pixels, bold));
        document_->setDefaultStyleSheet(tableStyle);
        document_->setHtml(html);
        QTextOption option(alignment);
        for (const auto mode : {QTextOption::WordWrap, QTextOption::WrapAtWordBoundaryOrAnywhere}) {
            option.setWrapMode(mode);
            document_->setDefaultTextOption(option);
            document_->setTextWidth(room);
            if (document_->size().width() <= std::max(room, widest)) {
                break;
            }
        }
    }
    double height() const { return std::ceil(document_->size().height()); }
    void draw(QPainter& painter, const QPointF& at) const { draw(painter, at, {0.0, height()}); }
    /// A part of it, from top to bottom.
    void draw(QPainter& painter, const QPointF& at, const std::pair<double, double>& part) const {
        const QRectF shown(0.0, part.first, document_->size().width(), part.second - part.first);
        painter.save();
        painter.translate(at);
        painter.scale(scale(), scale());
        painter.translate(-shown.topLeft());
        QAbstractTextDocumentLayout::PaintContext context;
        context.palette.setColor(QPalette::Text, QColor::fromRgb(colour_));
        context.clip = shown;
        painter.setClipRect(shown);
        document_->documentLayout()->draw(&painter, context);
        painter.restore();
    }
    /// Of a table whose longest words have no room beside each other.
    double scale() const { return std::min(1.0, width / document_->size().width()); }
    /// Of a table: the ends of its rows.
    std::vector<double> rowEnds() const {
        std::vector<double> ends;
        for (QTextFrame* frame : document_->rootFrame()->childFrames()) {
            const auto* table = qobject_cast<const QTextTable*>(frame);
            for (int row = 1; table != nullptr && row < table->rows(); ++row) {
                const QTextBlock first = table->cellAt(row, 0).firstCursorPosition().block();
                ends.push_back(document_->documentLayout()->blockBoundingRect(first).top() -
                               0.5 * cellPad);
            }
        }
        ends.push_back(height());
        return ends;
    }

  private:
    std::shared_ptr<QTextDocument> document_;
    QRgb colour_;
};

using Draw = std::function<void(QPainter&, const QPointF&)>;

/// What no page break parts.
struct Strip {
    double height = 0.0;
    double before = 0.0;  ///< room above it, but at the top of a page
    bool keepsWithNext = false;
    int table = -1;  ///< number of the table whose head is repeated above it on a new page
    Draw draw;
};

/// The report as strips from top to bottom.
class Strips {
  public:
    std::vector<Strip> strips;
    std::vector<Strip> heads;  ///< of tables

    void text(const QString& html, int pixels, bool bold, QRgb colour, double before,
              bool keepsWithNext) {
        const RichText words(html, pixels, bold, colour);
        strips.push_back(
            {words.height(), before, keepsWithNext, -1,
             [words](QPainter& painter, const QPointF& at) { words.draw(painter, at); }});
    }

    void operator()(const Heading& heading) {
        const bool first = heading.level == 1;
        text(heading.text.toHtmlEscaped(), first ? 17 : 14, true, ink, first ? 22.0 : 14.0, true);
        if (first) {
            const Draw words = strips.back().draw;
            const double height = strips.back().height + 3.0;
            strips.back().height = height + 3.0;
            strips.back().draw = [words, height](QPainter& painter, const QPointF& at) {
                words(painter, at);
                painter.setPen(QPen(QColor::fromRgb(rule), 0.8));
                painter.drawLine(at + QPointF(0, height), at + QPointF(width, height));
            };
        }
    }

    void operator()(const Paragraph& paragraph) {
        using Kind = Paragraph::Kind;
        if (paragraph.kind == Kind::Text || paragraph.kind == Kind::Muted) {
            const bool muted = paragraph.kind == Kind::Muted;
            text(paragraph.html, muted ? 11 : 12, false, muted ? pale : ink, 5.0, false);
            return;
        }
        // A bar at the left says of what kind it is, also without colours by its sign.
        const QRgb colour = paragraph.kind == Kind::Good      ? 0xff1f7a3d
                            : paragraph.kind == Kind::Warning ? 0xffb26a00
                                                              : 0xffb3261e;
        const RichText words(paragraph.html, 12, false, ink, Qt::AlignLeft, width - 14.0);
        const double height = words.height() + 6.0;
        strips.push_back({height, 6.0, false, -1, [=](QPainter& painter, const QPointF& at) {
                              painter.fillRect(QRectF(at, QSizeF(3.0, height)),
                                               QColor::fromRgb(colour));
                              words.draw(painter, at + QPointF(12.0, 3.0));
                          }});
    }

    void operator()(const Drawing& figure) {
        const double scale = std::min(1.0, width / figure.size.width());
        const QSizeF size = QSizeF(figure.size) * scale;
        strips.push_back({size.height(), 8.0, !figure.caption.isEmpty(), -1,
                          [figure, scale, size](QPainter& painter, const QPointF& at) {
                              painter.save();
                              painter.translate(at + QPointF((width - size.width()) / 2.0, 0.0));
                              painter.scale(scale, scale);
                              painter.setClipRect(QRectF(QPointF(), QSizeF(figure.size)));
                              painter.setFont(Theme::font());
                              figure.draw(painter);
                              painter.restore();
                          }});
        if (!figure.caption.isEmpty()) {
            const RichText words(figure.caption.toHtmlEscaped(), 11, false, pale, Qt::AlignHCenter);
            strips.push_back(
                {words.height(), 2.0, false, -1,
                 [words](QPainter& painter, const QPointF& at) { words.draw(painter, at); }});
        }
    }

    void operator()(const Table& table);
};

void Strips::operator()(const Table& table) {
    if (table.rows.isEmpty()) {
        return;
    }
    Table rows = table;
    if (!table.caption.isEmpty()) {
        text(table.caption.toHtmlEscaped(), 11, false, pale, 9.0, true);
        rows.caption.clear();
    }
    const RichText words(tableAsHtml(rows), table.isSmall ? 9 : 11, false, ink, Qt::AlignLeft,
                         width, 1.6 * width);
    const std::vector<double> ends = words.rowEnds();
    const qsizetype headings = table.headings.isEmpty() ? 0 : 1;
    const double before = table.caption.isEmpty() ? 8.0 : 2.0;
    for (qsizetype row = 0; row < std::ssize(ends); ++row) {
        const std::pair part(row > 0 ? ends[row - 1] : 0.0, ends[row]);
        // Neither the first nor the last row stands alone, and no heading within the table.
        const QStringList cells = table.rows.value(row - headings);
        const bool isGroup = cells.size() == 1 && table.headings.size() > 1;
        const bool keeps = row <= headings || isGroup || row + 2 == std::ssize(ends);
        strips.push_back({words.scale() * (part.second - part.first), row > 0 ? 0.0 : before,
                          keeps && row + 1 < std::ssize(ends),
                          headings > 0 && row > 0 ? static_cast<int>(std::ssize(heads)) : -1,
                          [words, part](QPainter& painter, const QPointF& at) {
                              words.draw(painter, at, part);
                          }});
    }
    heads.push_back(strips.end()[-std::ssize(ends)]);
}

/// A strip at its place.
struct Placed {
    int page;
    double y;
    const Strip* strip;
};

/// Where the text of a page ends.
double bottomOf(const Report& report) {
    return (QPageSize::size(report.paper, QPageSize::Millimeter).height() - 20.0) * perMillimetre;
}

std::vector<Placed> placed(const Strips& all, double bottom) {
    std::vector<Placed> result;
    int page = 0;
    double y = top;
    bool atTop = true;
    const std::vector<Strip>& strips = all.strips;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        const Strip& strip = strips[i];
        // What hangs together goes on one page where it can.
        double together = 0.0;
        for (std::size_t j = i; j < strips.size(); ++j) {
            together += strips[j].height + (j == i ? 0.0 : strips[j].before);
            if (!strips[j].keepsWithNext) {
                break;
            }
        }
        const double before = atTop ? 0.0 : strip.before;
        const bool chainFits = y + before + together <= bottom;
        const bool stripFits = y + before + strip.height <= bottom;
        if (!atTop && (!stripFits || (!chainFits && together <= bottom - top))) {
            ++page;
            y = top;
            atTop = true;
            if (strip.table >= 0) {
                const Strip& head = all.heads[static_cast<std::size_t>(strip.table)];
                result.push_back({page, y, &head});
                y += head.height;
                atTop = false;
            }
        }
        y += atTop ? 0.0 : strip.before;
        result.push_back({page, y, &strip});
        y += strip.height;
        atTop = false;
    }
    return result;
}

/// Words that are far longer than a line cost time that grows with their square.
QString frameTitle(const Report& report) {
    return report.title.left(500);
}

void drawFrame(QPainter& painter, const Report& report, int page, int pages) {
    const QFont font = paperFont(9);
    painter.setFont(font);
    painter.setPen(QColor::fromRgb(pale));
    const QRectF foot(left, bottomOf(report) + 6.0 * perMillimetre, width, 14.0);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter,
                     QStringLiteral("%1 · %2").arg(report.program, report.date));
    painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter,
                     ReportWords::tr("Page %1 of %2").arg(page + 1).arg(pages));
    if (page > 0) {
        const QRectF head(left, 12.0 * perMillimetre, width, 14.0);
        painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetricsF(font).elidedText(frameTitle(report), Qt::ElideRight, width));
        painter.setPen(QPen(QColor::fromRgb(hairline), 0.6));
        painter.drawLine(head.bottomLeft() + QPointF(0, 3), head.bottomRight() + QPointF(0, 3));
    }
}

}  // namespace

QByteArray reportAsPdf(const Report& report) {
    Strips strips;
    strips.text(frameTitle(report).toHtmlEscaped(), 22, true, ink, 0.0, true);
    strips.text(report.subtitle.toHtmlEscaped(), 13, false, pale, 2.0, true);
    for (std::size_t i = 0; i < report.items.size(); ++i) {
        std::visit(strips, report.items[i]);
        // What is said before a figure stays with it, and so does the heading over that.
        if (i + 1 < report.items.size() && std::holds_alternative<Paragraph>(report.items[i]) &&
            std::holds_alternative<Drawing>(report.items[i + 1])) {
            strips.strips.back().keepsWithNext = true;
        }
    }
    const std::vector<Placed> places = placed(strips, bottomOf(report));
    const int pages = places.empty() ? 1 : places.back().page + 1;

    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(96);  // recorded pictures are scaled by it, their text too
    writer.setTitle(frameTitle(report));
    writer.setCreator(report.program);
    QPageLayout layout(QPageSize(report.paper), QPageLayout::Portrait, QMarginsF());
    layout.setMode(QPageLayout::FullPageMode);
    writer.setPageLayout(layout);
    QPainter painter(&writer);
    painter.setRenderHint(QPainter::LosslessImageRendering);  // no JPEG
    const double scale = writer.logicalDpiX() / 96.0;
    int page = -1;
    for (const Placed& each : places) {
        while (page < each.page) {
            if (page >= 0) {
                writer.newPage();
            }
            ++page;
            painter.resetTransform();
            painter.scale(scale, scale);
            drawFrame(painter, report, page, pages);
        }
        painter.save();
        each.strip->draw(painter, QPointF(left, each.y));
        painter.restore();
    }
    painter.end();
    return buffer.data();
}

}  // namespace ravnoves
