#include "widgets/wrapped_header.h"

#include <algorithm>
#include <utility>

#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr int minMargins = 6;  ///< pixels beside a heading
int margins() {
    return std::max(minMargins, Theme::withText(minMargins));
}

/// Where a heading may go on: no sign and no unit stands alone.
QStringList wordsOf(const QString& heading) {
    constexpr qsizetype alone = 3;  // letters at least
    QStringList words;
    bool isShort = false;  // the word before
    for (const QString& word : heading.split(QLatin1Char(' '))) {
        if (!words.isEmpty() && (isShort || word.size() < alone)) {
            words.last() += QLatin1Char(' ') + word;
        } else {
            words << word;
        }
        isShort = word.size() < alone;
    }
    return words;
}

}  // namespace

WrappedHeader::WrappedHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
    setSectionsClickable(true);
    setHighlightSections(false);
    setTextElideMode(Qt::ElideNone);  // each line is, by itself
    connect(this, &QHeaderView::sectionResized, this, &WrappedHeader::fitLines);
}

void WrappedHeader::fitLines() {
    int lines = 1;
    for (int section = 0; section < count(); ++section) {
        lines = std::max(lines,
                         isSectionHidden(section) ? 1 : static_cast<int>(linesOf(section).size()));
    }
    if (std::exchange(lines_, lines) != lines) {
        // The table lays itself out again, which no section that is being resized may wait for.
        QMetaObject::invokeMethod(this, &QHeaderView::geometriesChanged, Qt::QueuedConnection);
    }
}

int WrappedHeader::widthOf(const QString& heading, bool wraps) const {
    int width = 0;
    const QStringList parts = wraps ? wordsOf(heading) : QStringList{heading};
    for (const QString& part : parts) {
        width = std::max(width, fontMetrics().horizontalAdvance(part));
    }
    return width + margins() - minMargins;
}

QStringList WrappedHeader::linesOf(int section) const {
    const QString text = model()->headerData(section, Qt::Horizontal).toString();
    const int room = sectionSize(section) - margins();
    const QFontMetrics metrics = fontMetrics();
    if (metrics.horizontalAdvance(text) <= room) {
        return {text};
    }
    QStringList lines;
    for (const QString& word : wordsOf(text)) {
        const QString longer = lines.isEmpty() ? word : lines.constLast() + QLatin1Char(' ') + word;
        if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= room) {
            lines.last() = longer;
        } else {
            lines << word;
        }
    }
    for (QString& line : lines) {
        // Eliding counts parts of a pixel, which widthOf() rounds.
        if (metrics.horizontalAdvance(line) > room) {
            line = metrics.elidedText(line, Qt::ElideRight, room);
        }
    }
    return lines;
}

QSize WrappedHeader::sizeHint() const {
    const QSize oneLine = QHeaderView::sizeHint();
    return {oneLine.width(), oneLine.height() + (lines_ - 1) * fontMetrics().lineSpacing()};
}

void WrappedHeader::initStyleOptionForIndex(QStyleOptionHeader* option, int section) const {
    QHeaderView::initStyleOptionForIndex(option, section);
    option->text = linesOf(section).join(QLatin1Char('\n'));
}

}  // namespace ravnoves
