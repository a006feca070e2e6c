#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextOption>
#include <QTextTable>
#include <algorithm>

#include "numerics/units.h"
#include "paper/paper.h"
#include "paper/paper_pictures.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

// In pixels of 1/96 inch, as the drawings are.
constexpr double millimetre = 96.0 / (units::inch.to_si / units::mm);
constexpr double left = 18.0 * millimetre;
constexpr double top = 12.0 * millimetre;

/// The text on a sheet.
struct Room {
    explicit Room(const QSizeF& sheet)  // in mm
        : width((sheet.width() - 14.0) * millimetre - left),
          bottom((sheet.height() - 10.5) * millimetre) {}

    double width;
    double bottom;
};

constexpr QRgb ink = 0xff1a1c20;
constexpr QRgb pale = 0xff5b626c;
constexpr QRgb rule = 0xff8a929e;
constexpr QRgb hairline = 0xffc9ced6;

constexpr double cellPad = 1.0;
const QString style = QStringLiteral(
    "p { margin: 5px 0 0 0; } h1 { font-size: 22px; margin: 0; } "
    "h2 { font-size: 17px; margin: 17px 0 5px 0; } h3 { font-size: 13px; margin: 6px 0 2px 0; } "
    ".kind { font-size: 13px; color: #5b626c; margin-top: 2px; } "
    ".muted { font-size: 11px; color: #5b626c; } "
    ".caption { font-size: 11px; color: #5b626c; margin: 9px 0 2px 0; } "
    ".figure { font-size: 11px; color: #5b626c; margin-top: 8px; text-align: center; } "
    ".good, .warning, .error { margin: 9px 0 3px 12px; } .good { -qt-user-state: 1; } "
    ".warning { -qt-user-state: 2; } .error { -qt-user-state: 3; } "
    ".break { page-break-before: always; margin: 0; font-size: 1px; } "
    "table { border-collapse: collapse; font-size: 11px; } "
    ".small td, .small th { font-size: 9px; } "
    ".wide table { margin-top: 5px; } "
    "th, td { border-bottom: 1px solid #d5d9df; padding: 1px 9px 1px 0; text-align: left; } "
    "th { border-bottom-color: #8a929e; color: #5b626c; font-weight: 400; } "
    "th.group { border-bottom-color: #d5d9df; color: #1a1c20; font-weight: 700; } "
    "th p, td p { margin: 0; } .number { text-align: right; } td.number { white-space: nowrap; }");

/// Of one size, whatever the size of the text on the screen. Without ligatures, so that "fl" in the
/// text of a PDF is found by a search for it.
QFont paperFont(int pixels) {
    QFont font(QStringLiteral("DejaVu Sans Condensed"));
    font.setPixelSize(pixels);
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setStyleStrategy(QFont::PreferNoShaping);
    return font;
}

/// What no page break parts: a line or a figure, a row of a table.
struct Strip {
    double top;
    double bottom;
    bool keepsWithNext = false;
    bool isAfterFirstPage = false;
    bool isBlankLines = false;
    int head = -1;  ///< number of the strip that is repeated above it on a new page
    int tone = -1;  ///< of a bar beside it
    bool isRuled = false;
};

/// A part of the document on a page: from there to here, at y. Blank lines have nothing of it.
struct Piece {
    double y;
    double from;
    double to;
    double blankLines = 0.0;  ///< their height

    double end() const { return y + to - from + blankLines; }
};

using Page = std::vector<Piece>;

class Pages {
  public:
    Pages(const Paper& paper, const Room& room)
        : room_(room), pictures_(paper.drawings, room.width) {
        document_.setDocumentMargin(0.0);
        document_.setUseDesignMetrics(true);
        document_.setDefaultFont(paperFont(12));
        document_.setDefaultStyleSheet(style);
        document_.documentLayout()->registerHandler(QTextFormat::ImageObject, &pictures_);
        document_.setDefaultTextOption(wrapping(QTextOption::WordWrap));
        document_.setHtml(paper.body);
        document_.setTextWidth(room_.width);
        fit();
        for (auto each = document_.rootFrame()->begin(); !each.atEnd(); ++each) {
            if (const auto* table = qobject_cast<const QTextTable*>(each.currentFrame())) {
                addTable(*table);
            } else if (each.currentBlock().isValid()) {
                addBlock(each.currentBlock());
            }
        }
        place();
    }

    const std::vector<Page>& pages() const { return pages_; }

    void draw(QPainter& painter, const Piece& piece) const {
        constexpr double lineStep = 6.5 * millimetre;
        constexpr double border = 3.0;  // of a table, which is outside
        const QRectF shown(-border, piece.from, room_.width + 2.0 * border, piece.to - piece.from);
        painter.setPen(QPen(QColor::fromRgb(hairline), 0.6));
        for (double y = lineStep; y < piece.blankLines; y += lineStep) {
            painter.drawLine(QPointF(left, piece.y + y), QPointF(left + room_.width, piece.y + y));
        }
        if (shown.isEmpty()) {  // which would be no clip
            return;
        }
        painter.save();
        painter.translate(left, piece.y - piece.from);
        for (const Strip& strip : strips_) {
            if (strip.top < piece.from || strip.bottom > piece.to) {
                continue;
            }
            if (strip.isRuled) {
                painter.setPen(QPen(QColor::fromRgb(rule), 0.8));
                painter.drawLine(QPointF(0.0, strip.bottom + 3.0),
                                 QPointF(room_.width, strip.bottom + 3.0));
            }
            if (strip.tone > 0) {
                constexpr std::array<QRgb, 3> colours{0xff1f7a3d, 0xffb26a00, 0xffb3261e};
                painter.fillRect(QRectF(0.0, strip.top - 3.0, 3.0, strip.bottom - strip.top + 6.0),
                                 QColor::fromRgb(colours.at(strip.tone - 1)));
            }
        }
        QAbstractTextDocumentLayout::PaintContext context;
        context.palette.setColor(QPalette::Text, QColor::fromRgb(ink));
        context.clip = shown;
        painter.setClipRect(shown);
        document_.documentLayout()->draw(&painter, context);
        painter.restore();
    }

  private:
    static QTextOption wrapping(QTextOption::WrapMode mode) {
        QTextOption option;
        option.setWrapMode(mode);
        return option;
    }

    /// A table whose words have no room beside each other is set smaller; if that is not enough,
    /// words are broken.
    void fit() {
        const auto isWide = [this] { return document_.size().width() > room_.width + 4.0; };
        for (QTextFrame* frame : document_.rootFrame()->childFrames()) {
            const double wide = isWide() ? layout().frameBoundingRect(frame).width() : 0.0;
            if (wide > room_.width + 4.0) {
                QTextCursor cursor(&document_);
                cursor.setPosition(frame->firstPosition());
                const int size = cursor.charFormat().font().pixelSize();
                cursor.setPosition(frame->lastPosition(), QTextCursor::KeepAnchor);
                QTextCharFormat smaller;
                smaller.setProperty(QTextFormat::FontPixelSize,
                                    std::max(6, static_cast<int>(size * room_.width / wide)));
                cursor.mergeCharFormat(smaller);
            }
        }
        if (isWide()) {
            document_.setDefaultTextOption(wrapping(QTextOption::WrapAtWordBoundaryOrAnywhere));
        }
    }

    QAbstractTextDocumentLayout& layout() const { return *document_.documentLayout(); }

    void addBlock(const QTextBlock& block) {
        const QTextLayout& lines = *block.layout();
        if (block.blockFormat().pageBreakPolicy() != QTextFormat::PageBreak_Auto) {
            isFirstPageFull_ = true;
            isText_ = false;
        }
        const bool isFigure = block.text().contains(QChar::ObjectReplacementCharacter);
        if (block.text().isEmpty()) {
            return;
        }
        if (isFigure && !strips_.empty() && isText_) {
            strips_.back().keepsWithNext = true;
        }
        const QRectF all = layout().blockBoundingRect(block);
        const int level = block.blockFormat().headingLevel();
        const int count = isFigure || block.userState() > 0 ? 1 : lines.lineCount();
        for (int i = 0; i < count; ++i) {
            Strip strip{all.top() + lines.lineAt(i).y(), all.bottom()};
            if (i + 1 < count) {
                strip.bottom = all.top() + lines.lineAt(i + 1).y();
            }
            strip.isRuled = level == 2 && i + 1 == count;
            strip.tone = block.userState();
            strip.isBlankLines = block.begin().fragment().charFormat().toImageFormat().name() ==
                                 QLatin1String("lines");
            strip.keepsWithNext =
                level > 0 || strip.isBlankLines || (i + 1 < count && (i == 0 || i + 2 == count));
            add(strip);
        }
        isText_ = !isFigure;
    }

    void addTable(const QTextTable& table) {
        if (!strips_.empty() && isText_) {
            strips_.back().keepsWithNext = true;
        }
        const QRectF all = layout().frameBoundingRect(const_cast<QTextTable*>(&table));
        const auto topOf = [&](int row) {
            if (row == 0 || row == table.rows()) {
                return row == 0 ? all.top() : all.bottom();
            }
            const QTextBlock first = table.cellAt(row, 0).firstCursorPosition().block();
            return layout().blockBoundingRect(first).top() - 0.5 * cellPad;
        };
        constexpr int few = 12;
        const int heads = table.format().headerRowCount();
        const auto head = static_cast<int>(strips_.size());
        for (int row = 0; row < table.rows(); ++row) {
            Strip strip{topOf(row), topOf(row + 1)};
            // A short table is whole; of a longer one neither the first nor the last row stands
            // alone, and no heading within it.
            const bool isGroup =
                table.columns() > 1 && table.cellAt(row, 0).columnSpan() == table.columns();
            strip.keepsWithNext = row + 1 < table.rows() && (table.rows() <= few || row <= heads ||
                                                             isGroup || row + 2 == table.rows());
            strip.head = row > 0 && heads > 0 ? head : -1;
            add(strip);
        }
        isText_ = false;
    }

    void add(Strip strip) {
        strip.isAfterFirstPage = std::exchange(isFirstPageFull_, false);
        strips_.push_back(strip);
    }

    void place() {
        pages_.emplace_back();
        for (std::size_t i = 0; i < strips_.size(); ++i) {
            const Strip& strip = strips_[i];
            // What hangs together goes on one page where it can.
            std::size_t last = i;
            while (strips_[last].keepsWithNext && last + 1 < strips_.size()) {
                ++last;
            }
            Page* page = &pages_.back();
            const auto overflows = [&](double end) {
                return !page->empty() &&
                       page->back().end() + end - page->back().to > room_.bottom + 0.5;
            };
            const double together = strips_[last].bottom;
            const bool canBeTogether = together - strip.top <= room_.bottom - top;
            if ((strip.isAfterFirstPage && pages_.size() == 1 && !page->empty()) ||
                overflows(strip.bottom) || (canBeTogether && overflows(together))) {
                page = &pages_.emplace_back();
                if (strip.head >= 0) {
                    const Strip& head = strips_[static_cast<std::size_t>(strip.head)];
                    page->push_back({top, head.top, head.bottom});
                    page->push_back({page->back().end(), strip.top, strip.top});
                }
            }
            if (page->empty()) {
                page->push_back({top, strip.top, strip.top});
            }
            page->back().to = strip.bottom;
            if (strip.isBlankLines) {
                std::size_t end = i;
                while (end + 1 < strips_.size() &&
                       !(strips_[end + 1].isAfterFirstPage && pages_.size() == 1)) {
                    ++end;
                }
                const double rest = strips_[end].bottom - strip.bottom;
                const double room = std::max(0.0, room_.bottom - page->back().end() - rest);
                page->push_back({page->back().end(), strip.bottom, strip.bottom, room});
                page->push_back({page->back().end(), strip.bottom, strip.bottom});
            }
        }
    }

    Room room_;
    PaperPictures pictures_;
    QTextDocument document_;
    std::vector<Strip> strips_;
    std::vector<Page> pages_;
    bool isFirstPageFull_ = false;
    bool isText_ = false;  ///< the last strip
};

void drawFrame(QPainter& painter, const Paper& paper, const Room& room, std::size_t page,
               std::size_t pages) {
    const QFont font = paperFont(9);
    painter.setFont(font);
    painter.setPen(QColor::fromRgb(pale));
    const QRectF foot(left, room.bottom + 3.0 * millimetre, room.width, 14.0);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, paper.foot);
    painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter,
                     paper.pageOf.arg(page + 1).arg(pages));
    if (page > 0) {
        const QRectF head(left, 6.0 * millimetre, room.width, 14.0);
        painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetricsF(font).elidedText(paper.title, Qt::ElideRight, room.width));
        painter.setPen(QPen(QColor::fromRgb(rule), 0.6));
        painter.drawLine(head.bottomLeft() + QPointF(0, 3), head.bottomRight() + QPointF(0, 3));
    }
}

}  // namespace

void paintPaper(const Paper& paper, QPainter& painter, const QRectF& page,
                const std::function<bool()>& next, const QSizeF& sheet) {
    const double scale = page.width() / (sheet.width() * millimetre);
    const Room room(sheet);
    const Pages pages(paper, room);
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::LosslessImageRendering);  // no JPEG
    painter.translate(page.topLeft());
    painter.scale(scale, scale);
    for (std::size_t i = 0; i < pages.pages().size() && (i == 0 || next()); ++i) {
        drawFrame(painter, paper, room, i, pages.pages().size());
        for (const Piece& piece : pages.pages()[i]) {
            pages.draw(painter, piece);
        }
    }
    painter.restore();
}

bool printPaper(const Paper& paper, QPagedPaintDevice& device) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    // The paper in device pixels. A printer that keeps margins of its own and was not set to the
    // full page begins inside it.
    const double perMillimetre = device.logicalDpiX() / (units::inch.to_si / units::mm);
    const QPageLayout layout = device.pageLayout();
    const QRectF sheet = layout.fullRect(QPageLayout::Millimeter);
    const QMarginsF margins = layout.mode() == QPageLayout::FullPageMode
                                  ? QMarginsF()
                                  : layout.margins(QPageLayout::Millimeter);
    // Letter has pages of its own, but for a sheet to write on, which must be whole. It is shorter
    // than A4, one on its side much more: the page shrinks to it, in the middle.
    const bool isLetter = layout.pageSize().id() == QPageSize::Letter &&
                          layout.orientation() == QPageLayout::Portrait && !paper.isWrittenOn;
    const QSizeF laid = isLetter ? sheet.size() : a4;
    const double scale =
        std::min({1.0, sheet.width() / laid.width(), sheet.height() / laid.height()});
    const QRectF page((sheet.width() - scale * laid.width()) / 2.0 - margins.left(), -margins.top(),
                      scale * laid.width(), scale * laid.height());
    bool isWhole = true;
    paintPaper(
        paper, painter, {page.topLeft() * perMillimetre, page.size() * perMillimetre},
        [&] { return isWhole = isWhole && device.newPage(); }, laid);
    return painter.end() && isWhole;
}

void setPaper(QPagedPaintDevice& device, const QPageSize& size) {
    QPageLayout layout(size, QPageLayout::Portrait, QMarginsF());
    layout.setMode(QPageLayout::FullPageMode);
    device.setPageLayout(layout);
}

QByteArray paperAsPdf(const Paper& paper, const QPageSize& size) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(96);  // recorded pictures are scaled by it, their text too
    writer.setTitle(paper.title);
    writer.setCreator(QStringLiteral("Ravnoves " RAVNOVES_VERSION));
    setPaper(writer, size);
    printPaper(paper, writer);
    return buffer.data();
}

}  // namespace ravnoves
