#include "widgets/result_table.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QStyledItemDelegate>
#include <QToolTip>
#include <QWhatsThis>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "text/csv_format.h"
#include "text/number_text.h"
#include "text/text_width.h"
#include "text/tip_text.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr int padding = 9;
constexpr int minPadding = 6;    ///< what a cell leaves beside its text
constexpr int minOfWords = 110;  ///< designed pixels
/// Whether two texts have the same signs, but for digits, which are of one width.
bool areAsWide(const QString& one, const QString& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](QChar a, QChar b) { return a == b || (a.isDigit() && b.isDigit()); });
}

QFont smallFont() {
    return Theme::font(Theme::smallSize);
}

int smallHeight() {
    return QFontMetrics(smallFont()).height() - 1;
}

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
            words.last() += QChar::Nbsp + word;
        } else {
            words << word;
        }
        isShort = word.size() < alone;
    }
    return words;
}

}  // namespace

/// Headings of columns that wrap in a narrow column.
class WrappedHeader final : public QHeaderView {
  public:
    explicit WrappedHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
        setSectionsClickable(true);
        setHighlightSections(false);
        setTextElideMode(Qt::ElideNone);
        connect(this, &QHeaderView::sectionResized, this, &WrappedHeader::fitLines);
    }

    /// The width of a heading: of its longest word, or of all words.
    int widthOf(const QString& heading, bool wraps) const {
        int width = 0;
        for (const QString& part : wraps ? wordsOf(heading) : QStringList{heading}) {
            width = std::max(width, fontMetrics().horizontalAdvance(part));
        }
        return width + margins() - minMargins;
    }
    /// Takes the height that the headings need now.
    void fitLines() {
        int height = fontMetrics().height();
        for (int section = 0; section < count(); ++section) {
            const QRect room(0, 0, sectionSize(section) - margins(), QWIDGETSIZE_MAX);
            if (!isSectionHidden(section) && !room.isEmpty()) {
                const QRect text =
                    fontMetrics().boundingRect(room, Qt::TextWordWrap, textOf(section));
                height = std::max(height, text.height());
            }
        }
        if (std::exchange(height_, height) != height) {
            // The table lays itself out again, which no section that is being resized may wait for.
            QMetaObject::invokeMethod(this, &QHeaderView::geometriesChanged, Qt::QueuedConnection);
        }
    }
    QSize sizeHint() const override {
        const QSize oneLine = QHeaderView::sizeHint();
        const int height = fontMetrics().height();
        return {oneLine.width(), oneLine.height() + std::max(height_, height) - height};
    }

  protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int section) const override {
        QHeaderView::initStyleOptionForIndex(option, section);
        option->text = textOf(section);
        option->textAlignment =
            Qt::Alignment::fromInt(option->textAlignment.toInt() | Qt::TextWordWrap);
    }

  private:
    QString textOf(int section) const {
        const QString heading = model()->headerData(section, Qt::Horizontal).toString();
        return wordsOf(heading).join(QLatin1Char(' '));
    }

    int height_ = 0;  ///< of the lines that its place has room for
};

/// Its tip is what its row and its column mean, unless it was given another.
class ResultItem final : public QTableWidgetItem {
  public:
    QVariant data(int role) const override {
        const QVariant own = QTableWidgetItem::data(role);
        return role == Qt::ToolTipRole && own.isNull()
                   ? static_cast<const ResultTable*>(tableWidget())->tipOf(row(), column())
                   : own;
    }
};

/// A cell over the small lines of its difference and its ±. Its tip begins with its whole text
/// where that has too little room.
class ResultDelegate final : public QStyledItemDelegate {
  public:
    explicit ResultDelegate(ResultTable* table) : QStyledItemDelegate(table), table_(table) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        if (table_->wordWrap()) {
            QStyledItemDelegate::paint(painter, option, index);
            return;
        }
        QStyleOptionViewItem cell = option;
        initStyleOption(&cell, index);
        QString text = std::exchange(cell.text, QString());
        const bool isSelected = (cell.state & QStyle::State_Selected) != 0;
        if (isSelected || (cell.state & QStyle::State_HasFocus) != 0) {
            cell.widget->style()->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
        }
        const QColor ink =
            cell.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
        const int side =
            static_cast<int>((cell.displayAlignment & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter);
        const QStringList below = table_->below(index.row(), index.column());
        const int height = ResultTable::plainRowHeight();
        QRect line = cell.rect.adjusted(3, 0, -3, 0);
        if (line.height() >= height + smallHeight()) {
            line.setHeight(height);
        }
        painter->save();
        painter->setFont(cell.font);
        painter->setPen(ink);
        if (textWidth(cell.font, text) > line.width()) {
            text = QFontMetrics(cell.font).elidedText(text, Qt::ElideRight, line.width());
        }
        painter->drawText(line, side, text);
        painter->setFont(smallFont());
        painter->setPen(isSelected ? ink : Theme::instance().mutedText());
        line.moveTop(line.top() + height - 3);
        line.setHeight(smallHeight());
        for (const QString& each : below) {
            painter->drawText(line, side, each);
            line.translate(0, smallHeight());
        }
        painter->restore();
    }

    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
        QStringList lines{index.data(Qt::ToolTipRole).toString()};
        if (const QString text = index.data().toString();
            textWidth(view->font(), text) > option.rect.width() - 6) {
            lines.prepend(text);
        }
        lines.removeAll(QString());
        const QString text = tipText(lines.join(QLatin1Char('\n')));
        if (event->type() == QEvent::ToolTip && !text.isEmpty()) {
            QToolTip::showText(event->globalPos(), text, view);
        } else if (event->type() == QEvent::WhatsThis && !text.isEmpty()) {
            QWhatsThis::showText(event->globalPos(), text, view);
        }
        return !text.isEmpty();
    }

  private:
    ResultTable* table_;
};

ResultTable::ResultTable(QWidget* parent) : QTableWidget(parent), header_(new WrappedHeader(this)) {
    setHorizontalHeader(header_);
    setItemDelegate(new ResultDelegate(this));
    connect(header_, &QHeaderView::geometriesChanged, this, &QWidget::updateGeometry);
    setToolTip(
        tr("Ctrl+C copies the selected cells, or the whole table if no more than one is "
           "selected."));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);  // rows are one line high: what is too long ends in it, not at a word
    setFrameShape(QFrame::NoFrame);
    setFont(Theme::font(Theme::baseSize - 1));
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(plainRowHeight());
    verticalHeader()->setMinimumSectionSize(Theme::withText(18));
    header_->setSectionResizeMode(QHeaderView::Stretch);
    header_->setFont(Theme::font(Theme::smallSize + 1, true));
}

int ResultTable::plainRowHeight() {
    return Theme::withText(20);
}

void ResultTable::setColumns(const ResultColumns& columns) {
    headings_ = columns;
    setColumnCount(static_cast<int>(columns.size()));
    for (int column = 0; column < columnCount(); ++column) {
        auto* heading = new QTableWidgetItem(columns[column].heading);
        heading->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                  Qt::AlignVCenter);
        heading->setToolTip(tipText(columns[column].tip));
        setHorizontalHeaderItem(column, heading);
    }
    header_->setSectionResizeMode(QHeaderView::Fixed);
    fittedTo_ = -1;
    fitColumns();
}

void ResultTable::setResults(const Results& results) {
    if (!results.columns.isEmpty() && results.columns != headings_) {
        setColumns(results.columns);
    }
    setRows(results.rows);
}

void ResultTable::setRows(const ResultRows& rows) {
    given_ = rows;
    showRows();
}

void ResultTable::showRows() {
    rows_ = given_;
    if (reference_) {
        compareRows(rows_, *reference_);
    }
    addSpreads(rows_, spreads_, areSpreadsAwaited_);
    bool isSameShape = rowCount() == rows_.size();
    if (!isSameShape) {
        setRowCount(static_cast<int>(rows_.size()));
        updateGeometry();
    }
    const bool hadDifferences = std::exchange(hasDifferences_, false);
    for (int row = 0; row < rowCount(); ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            const ResultCell shown = rows_[row].value(column);
            const QString text = shown.marked();
            hasDifferences_ = hasDifferences_ || shown.fromOther;
            QTableWidgetItem* cell = item(row, column);
            if (cell == nullptr) {
                cell = new ResultItem;
                cell->setText(text);
                cell->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                       Qt::AlignVCenter);
                setItem(row, column, cell);
                isSameShape = false;
            } else if (const QString was = cell->text(); was != text) {
                cell->setText(text);
                isSameShape = isSameShape && areAsWide(was, text);
            }
            cell->setData(Qt::ToolTipRole, QVariant());
        }
    }
    if (!isSameShape || hasDifferences_ || hadDifferences) {
        fitColumns();
    }
    if (hasDifferences_ || !spreads_.empty()) {
        viewport()->update();
    }
}

QString ResultTable::tipOf(int row, int column) const {
    const ResultCell cell = rows_[row].value(column);
    const bool isName = column == 0 && !rows_[row].tip.isEmpty();
    QStringList lines{rows_[row].tip, isName ? QString() : headings_[column].tip};
    if (cell.fromOther) {
        lines << (reference_ ? tr("Present value minus reference %1").arg(referenceName_)
                             : tr("Below the value: difference from the reference."));
    }
    if (!cell.spread.isEmpty()) {
        lines << spreadTip_;
    }
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

void ResultTable::setSpreads(std::vector<CellSpread> spreads, const QString& how) {
    if (spreads.empty() && spreads_.empty()) {
        return;
    }
    spreads_ = std::move(spreads);
    spreadTip_ = how;
    areSpreadsAwaited_ = false;
    fittedTo_ = -1;
    showRows();
    fitColumns();
}

void ResultTable::awaitSpreads() {
    if (!spreads_.empty() && !std::exchange(areSpreadsAwaited_, true)) {
        showRows();
    }
}

QString ResultTable::spreadAt(int row, int column) const {
    return rows_.value(row).value(column).spread;
}

QStringList ResultTable::differenceAt(int row, int column) const {
    const auto found = rows_.value(row).value(column).fromOther;
    return found ? QStringList{found->absolute, found->percent} : QStringList();
}

QStringList ResultTable::below(int row, int column) const {
    QStringList lines = differenceAt(row, column);
    lines.removeAll(QString());
    if (room_ != Room::Little && lines.size() > 1) {
        lines = {lines.join(QStringLiteral("  "))};
    }
    if (const QString spread = spreadAt(row, column); !spread.isEmpty()) {
        // Sides that are wider than a column's share are below one another.
        const int share = viewport()->width() / columnCount();
        const bool isWide = textWidth(smallFont(), spread) > share;
        lines << (isWide && spread.startsWith(QLatin1Char('+')) ? spread.split(QLatin1Char(' '))
                                                                : QStringList{spread});
    }
    return lines;
}

void ResultTable::showReference(const Results* results, const QString& name) {
    if (results == nullptr && !reference_) {
        return;
    }
    reference_ = results != nullptr ? std::optional(results->rows) : std::nullopt;
    referenceName_ = name;
    fittedTo_ = -1;
    showRows();
    fitColumns();
}

int ResultTable::wantedWidth(int column) const {
    const bool isName = stretched_.contains(column);
    int width = header_->isHidden()
                    ? 0
                    : header_->widthOf(headings_[column].heading, room_ != Room::Plenty || isName);
    for (int row = 0; row < rowCount(); ++row) {
        const QTableWidgetItem* cell = item(row, column);
        if (cell == nullptr) {
            continue;
        }
        width = std::max(width, qCeil(textWidth(font(), cell->text())));
        for (const QString& line : below(row, column)) {
            width = std::max(width, qCeil(textWidth(smallFont(), line)));
        }
    }
    // A header makes no column narrower.
    return std::max(width + padding, header_->minimumSectionSize());
}

void ResultTable::fitColumns() {
    const int room = viewport()->width();
    // At one width columns only ever grow, so that they rest while a slider moves; but for a value
    // that was too large once, as a slip of the keys makes it, they do not scroll for ever.
    const bool isSameWidth = std::exchange(fittedTo_, room) == room;
    const bool grows = isSameWidth && header_->length() <= room;
    room_ = isSameWidth ? room_ : Room::Plenty;
    const int minimum = Theme::withText(minOfWords);
    QList<int> widths(columnCount());
    int sum = 0;
    while (true) {
        sum = 0;
        int cut = 0;  // what the words lack
        for (int column = 0; column < columnCount(); ++column) {
            int& width = widths[column];
            width = isColumnHidden(column) ? 0 : wantedWidth(column);
            if (stretched_.contains(column)) {
                // Words that are long end in dots rather than take the numbers' room.
                const int whole = width;
                width = std::min(width, std::max(minimum, 2 * room / 5));
                cut += whole - width;
            } else if (grows) {
                width = std::max(width, columnWidth(column));
            }
            sum += width;
        }
        // Differences are below each other before they shorten the words.
        if (sum + (reference_ ? cut : 0) <= room || room_ == Room::Little) {
            break;
        }
        room_ = static_cast<Room>(static_cast<int>(room_) + 1);
    }
    // Takes what is over, where that is enough: of each its share, rounded up.
    const auto narrow = [&](const auto& spareOf) {
        const int over = sum - room;
        int spare = 0;
        for (int column = 0; column < columnCount(); ++column) {
            spare += spareOf(column);
        }
        for (int column = 0; column < columnCount() && sum > room && over <= spare; ++column) {
            const int given = std::min(sum - room, (over * spareOf(column) + spare - 1) / spare);
            widths[column] -= given;
            sum -= given;
        }
    };
    // Before the numbers scroll, words end in dots sooner; nor do they where closer they have room.
    narrow([&](int column) {
        return stretched_.contains(column) ? std::max(0, widths[column] - minimum) : 0;
    });
    narrow([&](int column) { return isColumnHidden(column) ? 0 : padding - minPadding; });
    const auto scrolls = [this] { return header_->length() > viewport()->width(); };
    const bool scrolled = scrolls();
    // The words share what is left.
    const int left = std::max(0, room - sum);
    const auto shares =
        static_cast<int>(std::count_if(stretched_.begin(), stretched_.end(),
                                       [this](int column) { return !isColumnHidden(column); }));
    for (int column = 0; column < columnCount(); ++column) {
        int width = widths[column];
        if (stretched_.contains(column)) {
            width += left / std::max(1, shares) +
                     (column == stretched_.front() ? left % std::max(1, shares) : 0);
        }
        if (!isColumnHidden(column) && width != columnWidth(column)) {
            setColumnWidth(column, width);
        }
    }
    header_->fitLines();
    fitRows();
    if (!isSameWidth || scrolls() != scrolled) {
        updateGeometry();  // the height of its bar
    }
}

void ResultTable::fitRows() {
    qsizetype lines = 0;
    for (int row = 0; row < rowCount(); ++row) {
        for (int column = 1; column < columnCount(); ++column) {
            lines = std::max(lines, below(row, column).size());
        }
    }
    const int height = plainRowHeight() + static_cast<int>(lines) * smallHeight();
    if (verticalHeader()->defaultSectionSize() != height) {
        verticalHeader()->setDefaultSectionSize(height);
        updateGeometry();
    }
}

void ResultTable::stretchColumn(int column) {
    stretched_ << column;
}

void ResultTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitColumns();
}

QString ResultTable::joined(QChar separator, bool selectionOnly) const {
    const CsvFormat csv;
    // In the whole table, what is below its numbers gets columns behind them.
    QSet<int> compared;
    QSet<int> spread;
    for (const ResultRow& row : selectionOnly ? ResultRows() : rows_) {
        for (int column = 0; column < row.size(); ++column) {
            if (row[column].fromOther) {
                compared << column;
            }
            if (!row[column].spread.isEmpty()) {
                spread << column;
            }
        }
    }
    QString text;
    for (int row = selectionOnly ? 0 : -1; row < rowCount(); ++row) {  // the headings first
        QStringList line;
        for (int column = 0; column < columnCount(); ++column) {
            if (isColumnHidden(column) || (selectionOnly && !item(row, column)->isSelected())) {
                continue;
            }
            const QString& heading = headings_[column].heading;
            line << (row < 0 ? heading : rows_[row].value(column).text);
            if (compared.contains(column)) {
                const QString delta = QStringLiteral("Δ ") + heading;
                const QStringList parts = row < 0
                                              ? QStringList{delta, delta + QStringLiteral(", %")}
                                              : differenceAt(row, column);
                line << parts.value(0) << parts.value(1);
            }
            if (spread.contains(column)) {
                line << (row < 0 ? QStringLiteral("± ") + heading : spreadAt(row, column));
            }
        }
        for (QString& each : line) {
            each = separator == QLatin1Char('\t') ? csv.plainNumber(each) : csv.field(each);
        }
        if (!line.isEmpty()) {
            text += line.join(separator) + QLatin1Char('\n');
        }
    }
    return text;
}

QString ResultTable::asText() const {
    return joined(QLatin1Char('\t'), false);
}
QString ResultTable::asCsv() const {
    return joined(CsvFormat().separator, false);
}

QString ResultTable::lineAbove(const QString& text, bool asCsv) {
    return text.isEmpty() ? text : (asCsv ? CsvFormat().field(text) : text) + QLatin1Char('\n');
}

void ResultTable::copy(bool selectionOnly) const {
    QApplication::clipboard()->setText(lineAbove(warning(), false) +
                                       joined(QLatin1Char('\t'), selectionOnly));
}

void ResultTable::paintEvent(QPaintEvent* event) {
    QTableWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(viewport());
        painter.setPen(Theme::instance().accent());
        painter.drawRect(viewport()->rect().adjusted(0, 0, -1, -1));
    }
}

void ResultTable::scrollContentsBy(int across, int down) {
    QTableWidget::scrollContentsBy(across, down);
    viewport()->update();
}

void ResultTable::scrollTo(const QModelIndex& index, ScrollHint hint) {
    QTableWidget::scrollTo(index, hint);
    const QRect cell = visualRect(index);
    for (QWidget* around = parentWidget(); hasFocus() && around != nullptr;
         around = around->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(around)) {
            const QPoint at = viewport()->mapTo(area->widget(), cell.center());
            area->ensureVisible(at.x(), at.y(), 0, cell.height());
        }
    }
}

void ResultTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        copy(selectedItems().size() > 1);  // one is where the last click or arrow went
        return;
    }
    QTableWidget::keyPressEvent(event);
}

void ResultTable::addCopyButtons(QDialogButtonBox* buttons) const {
    const auto add = [&](const QString& text, QString (ResultTable::*what)() const) {
        QPushButton* button = buttons->addButton(text, QDialogButtonBox::ActionRole);
        connect(button, &QPushButton::clicked, this,
                [this, what] { QApplication::clipboard()->setText((this->*what)()); });
    };
    add(tr("Copy as &text"), &ResultTable::asText);
    add(tr("Copy as &CSV"), &ResultTable::asCsv);
}

void ResultTable::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Copy selection"), this, [this] { copy(true); })
        ->setEnabled(!selectedItems().isEmpty());
    menu.addAction(tr("Copy table as text"), this, [this] { copy(false); });
    menu.addAction(tr("Copy table as CSV"), this, [this] {
        QApplication::clipboard()->setText(lineAbove(warning(), true) + asCsv());
    });
    menu.exec(event->globalPos());
}

void ResultTable::setShownRows(int rows) {
    shownRows_ = rows;
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    updateGeometry();
}

QSize ResultTable::sizeHint() const {
    const int heading = header_->isHidden() ? 0 : header_->sizeHint().height();
    const int bar =
        header_->length() > viewport()->width() ? horizontalScrollBar()->sizeHint().height() : 0;
    const int rows = shownRows_ > 0 ? shownRows_ : rowCount();
    return {240, heading + rows * verticalHeader()->defaultSectionSize() + bar + 2};
}

QSize ResultTable::minimumSizeHint() const {
    // With differences below its numbers it scrolls.
    const int rows = shownRows_ > 0 ? shownRows_ : rowCount();
    return {120, sizeHint().height() -
                     rows * (verticalHeader()->defaultSectionSize() - plainRowHeight())};
}

}  // namespace ravnoves
