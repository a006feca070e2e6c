#include "widgets/result_table.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "text/csv_format.h"
#include "text/text_width.h"
#include "theme/theme.h"
#include "widgets/cell_delegate.h"
#include "widgets/wrapped_header.h"

namespace ravnoves {

namespace {

constexpr int usualPadding = 9;
constexpr int leastPadding = 7;

/// Whether two texts have the same signs, but for digits, which are of one width.
bool areAsWide(const QString& one, const QString& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](QChar a, QChar b) { return a == b || (a.isDigit() && b.isDigit()); });
}

}  // namespace

ResultTable::ResultTable(QWidget* parent)
    : WithWholeRows(parent), header_(new WrappedHeader(this)) {
    static int made = 0;
    number_ = ++made;
    setHorizontalHeader(header_);
    setItemDelegate(new CellDelegate(this));
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
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setFont(Theme::font(Theme::smallSize + 1, true));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // until it is needed
    setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
}

ResultTable::~ResultTable() {
    if (referenceOf_ != nullptr) {
        referenceOf_->setReference(nullptr, {});
    }
    if (reference_ != nullptr) {
        reference_->referenceOf_ = nullptr;
    }
}

int ResultTable::plainRowHeight() {
    return Theme::withText(20);
}

const ResultNumber* ResultTable::numberAt(int row, int column) const {
    const bool isThere = row < rows_.size() && column > 0 && column < rows_[row].size();
    return isThere ? rows_[row][column].number() : nullptr;
}

int ResultTable::headingWidth(int column) const {
    return header_->widthOf(horizontalHeaderItem(column)->text(), wraps_) + padding();
}

int ResultTable::padding() const {
    return wraps_ ? leastPadding : usualPadding;
}

void ResultTable::setColumns(const ResultColumns& columns) {
    headings_ = columns;
    tipsRest_ = false;
    columns_ = static_cast<int>(columns.size());
    setColumnCount(columns_);
    isOver_ = false;
    for (int column = 0; column < columns_; ++column) {
        auto* heading = new QTableWidgetItem(columns[column].heading);
        heading->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                  Qt::AlignVCenter);
        heading->setToolTip(columns[column].tip);
        setHorizontalHeaderItem(column, heading);
    }
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    fitColumns();
}

void ResultTable::setOrHide(const Results& results) {
    setResults(results);
    setVisible(!results.rows.isEmpty());
}

void ResultTable::setResults(const Results& results) {
    if (!results.columns.isEmpty() && results.columns != headings_) {
        setColumns(results.columns);
    }
    setRows(results.rows);
}

namespace {

/// The width of heading and texts of a column, as far as one asks.
int widestText(const QTableWidget& table, int column, int enough) {
    constexpr int padding = 12;
    const QFont& cells = table.font();
    const QHeaderView& header = *table.horizontalHeader();
    const QTableWidgetItem* heading =
        header.isHidden() ? nullptr : table.horizontalHeaderItem(column);
    int width =
        heading == nullptr ? 0 : qRound(textWidth(header.font(), heading->text())) + padding;
    for (int row = 0; row < table.rowCount() && width < enough; ++row) {
        if (const QTableWidgetItem* cell = table.item(row, column)) {
            width = std::max(width, qRound(textWidth(cells, cell->text())) + padding);
        }
    }
    return std::min(width, enough);
}

/// What a column of words insists on.
int leastOfWords(const QTableWidget& table, int column) {
    const int most = Theme::withText(110);
    if (table.isColumnHidden(column)) {
        return 0;
    }
    return std::clamp(widestText(table, column, most), Theme::withText(30), most);
}

}  // namespace

QList<std::pair<int, int>> ResultTable::neededWidths() const {
    QList<std::pair<int, int>> needed;
    for (int column = 1; column < columnCount(); ++column) {
        if (stretched_.contains(column) || isColumnHidden(column)) {
            continue;
        }
        int width = headingWidth(column);
        for (int row = 0; row < rowCount(); ++row) {
            width = std::max(width, widthOf(row, column, place_));
        }
        needed << std::pair(column, width);
    }
    return needed;
}

void ResultTable::wrapHeadings() {
    // At one width they only ever get a second line, so that they rest while a slider moves.
    const int room = viewport()->width();
    const bool isSame = std::exchange(wrapsAt_, room) == room;
    if (isSame && wraps_ && small_ && !header_->isHidden()) {
        return;
    }
    const auto numbers = [this] {
        int wanted = 0;
        for (const auto& [column, width] : neededWidths()) {
            wanted += width;
        }
        return wanted;
    };
    if (!isSame || !wraps_ || header_->isHidden()) {
        const bool was = std::exchange(wraps_, false);
        setSmall(false);
        int wanted = numbers();
        for (const int column : stretched_) {
            if (isColumnHidden(column)) {
                continue;
            }
            wanted +=
                column == 0 ? widestText(*this, column, room / 2) : leastOfWords(*this, column);
        }
        wraps_ = wanted > room && !header_->isHidden();
        fitted_ = fitted_ && wraps_ == was;
    }
    if (wraps_) {
        int wanted = numbers();
        for (const int column : stretched_) {
            if (isColumnHidden(column)) {
                continue;
            }
            const int words = column == 0 ? widestText(*this, column, room / 2) : 0;
            wanted += std::max(leastOfWords(*this, column), words);
        }
        setSmall(wanted > room);
    }
}

void ResultTable::setSmall(bool isSmall) {
    if (std::exchange(small_, isSmall) == isSmall) {
        return;
    }
    const int size = isSmall ? Theme::smallSize : Theme::baseSize - 1;
    setFont(Theme::font(size));
    header_->setFont(Theme::font(size, true));
    fitted_ = false;
}

ResultTable::Layout ResultTable::laidOut() const {
    Layout layout{viewport()->size(),
                  maximumViewportSize(),
                  verticalHeader()->length(),
                  horizontalHeader()->hiddenSectionCount(),
                  header_->isHidden(),
                  wraps_,
                  small_,
                  isOver_,
                  {}};
    for (int column = 0; column < columnCount(); ++column) {
        layout.widths << columnWidth(column);
    }
    return layout;
}

void ResultTable::fitColumns() {
    const Layout before = laidOut();
    wrapHeadings();
    const QList<std::pair<int, int>> needed = neededWidths();
    int sum = 0;
    for (const int column : stretched_) {
        sum += isOver_ ? leastOfWords(*this, column) : 0;
    }
    for (const auto& [column, width] : needed) {
        sum += width;
    }
    // Columns only ever grow, so that they rest while a slider moves; but for a value that was too
    // large once, as a slip of the keys makes it, they do not scroll for ever.
    const bool grows = fitted_ && !(isOver_ && sum <= viewport()->width());
    for (const auto& [column, least] : needed) {
        const int width = std::max(least, grows ? columnWidth(column) : 0);
        if (width != columnWidth(column)) {
            setColumnWidth(column, width);
        }
    }
    fitted_ = true;
    fitStretched();
    header_->fitLines();
    const Layout now = laidOut();
    rests_ = now == before ? std::optional(now) : std::nullopt;
}

void ResultTable::stretchColumn(int column) {
    stretched_ << column;
    horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
}

void ResultTable::fitStretched() {
    int wanted = 0;
    QList<int> least;
    for (int column = 0; column < columnCount(); ++column) {
        if (!stretched_.contains(column)) {
            wanted += columnWidth(column);
            continue;
        }
        least << leastOfWords(*this, column);
        wanted += least.last();
    }
    // The viewport has still the room that the bars of before leave it.
    const QSize whole = maximumViewportSize();
    const bool isTall = verticalHeader()->length() > whole.height();
    const int room = whole.width() - (isTall ? verticalScrollBar()->sizeHint().width() : 0);
    const bool over = wanted > room;
    if (over != isOver_) {
        isOver_ = over;
        for (const int column : stretched_) {
            horizontalHeader()->setSectionResizeMode(
                column, over ? QHeaderView::Fixed : QHeaderView::Stretch);
        }
        updateGeometry();
        setHorizontalScrollBarPolicy(over ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
        if (isOver_ != over) {
            return;  // the bar's room was taken or given, and there the answer was another
        }
    }
    if (over && !least.isEmpty()) {
        // What scrolls anyway has room for names that begin alike. They take what is left beside
        // the columns that are seen whole.
        least.first() = std::max(least.first(), widestText(*this, 0, 2 * viewport()->width() / 5));
        int left = viewport()->width() - least.first();
        for (int column = 1; column < columnCount(); ++column) {
            const qsizetype at = stretched_.indexOf(column);
            const int width = at >= 0 ? least[at] : columnWidth(column);
            if (width > left) {
                break;
            }
            left -= width;
        }
        least.first() += std::max(0, left);
    }
    for (int i = 0; over && i < stretched_.size(); ++i) {
        if (columnWidth(stretched_[i]) != least[i]) {
            setColumnWidth(stretched_[i], least[i]);
        }
    }
}

void ResultTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    if (reference_ != nullptr || !spreads_.empty()) {
        placeBeside();
    } else {
        fitColumns();
    }
}

bool ResultTable::hasRoomForWords() const {
    const int half = viewport()->width() / 2;
    return std::all_of(stretched_.begin(), stretched_.end(), [&](int column) {
        return isColumnHidden(column) ||
               columnWidth(column) >=
                   (column == 0 ? widestText(*this, column, half) : leastOfWords(*this, column));
    });
}

void ResultTable::setRows(const ResultRows& rows) {
    // At each step of a slider: tips are put together only where they are others.
    tipsRest_ = tipsRest_ &&
                std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                           [](const ResultRow& a, const ResultRow& b) { return a.tip == b.tip; });
    rows_ = rows;
    bool isSameShape = rowCount() == rows.size();
    // Columns at rest keep their widths while what is new in them fits, and the words beside them.
    const bool rests = rests_ && !isOver_ && rests_ == laidOut() && hasRoomForWords();
    const auto fits = [&](int row, int column) {
        return rests && !stretched_.contains(column) &&
               widthOf(row, column, place_) <= columnWidth(column);
    };
    if (!isSameShape) {
        setRowCount(static_cast<int>(rows.size()));
        updateGeometry();
    }
    for (int row = 0; row < rows.size(); ++row) {
        for (int column = 0; column < columns_; ++column) {
            const QString text = rows[row].value(column).text;
            QTableWidgetItem* cell = item(row, column);
            if (cell == nullptr) {
                cell = new QTableWidgetItem(text);
                cell->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                       Qt::AlignVCenter);
                setItem(row, column, cell);
                isSameShape = false;
                tipsRest_ = false;
            } else if (const QString was = cell->text(); was != text) {
                cell->setText(text);
                isSameShape = isSameShape && (areAsWide(was, text) || fits(row, column));
            }
        }
    }
    if (!std::exchange(tipsRest_, true)) {
        showTips();
    }
    if (!spreads_.empty()) {
        showSpreads();
    }
    if (reference_ != nullptr || !spreads_.empty()) {
        showDifferences();
    } else if (!isSameShape || rests_ != laidOut()) {
        fitColumns();
    }
    if (referenceOf_ != nullptr) {
        referenceOf_->showDifferences();
    }
}

void ResultTable::showTips() {
    for (int row = 0; row < rows_.size(); ++row) {
        const QString& ofRow = rows_[row].tip;
        for (int column = 0; column < columns_; ++column) {
            QStringList lines{ofRow};
            if (column > 0 || ofRow.isEmpty()) {
                lines << headings_[column].tip;
            }
            lines.removeAll(QString());
            item(row, column)->setToolTip(lines.join(QLatin1Char('\n')));
        }
    }
}

void ResultTable::setCellToolTip(int row, int column, const QString& text) {
    if (QTableWidgetItem* cell = item(row, column)) {
        cell->setToolTip(text);
        tipsRest_ = false;
    }
}

QString ResultTable::joined(QChar separator, bool selectionOnly) const {
    const CsvFormat csv;
    const auto written = [&](const QString& text) {
        return separator == QLatin1Char('\t') ? csv.plainMinus(text) : csv.field(text);
    };
    // In the whole table, what stands below its numbers gets columns behind them.
    const auto isBelow = [&](const QList<int>& columns, int column) {
        return !selectionOnly && place_ != Place::Columns && columns.contains(column);
    };
    QString text;
    QStringList line;
    for (int column = 0; column < columnCount() && !selectionOnly; ++column) {
        const QString heading = horizontalHeaderItem(column)->text();
        line << written(heading);
        if (isBelow(compared_, column)) {
            const QString delta = QStringLiteral("Δ ") + heading;
            line << written(delta) << written(delta + QStringLiteral(", %"));
        }
        if (isBelow(spread_, column)) {
            line << written(QStringLiteral("± ") + heading);
        }
    }
    if (!line.isEmpty()) {
        text += line.join(separator) + QLatin1Char('\n');
    }
    for (int row = 0; row < rowCount(); ++row) {
        line.clear();
        for (int column = 0; column < columnCount(); ++column) {
            const QTableWidgetItem* cell = item(row, column);
            if (cell != nullptr && (!selectionOnly || cell->isSelected())) {
                line << written(cell->text());
                if (isBelow(compared_, column)) {
                    const QStringList parts = differenceAt(row, column);
                    line << written(parts.value(0)) << written(parts.value(1));
                }
                if (isBelow(spread_, column)) {
                    line << written(spreadAt(row, column));
                }
            }
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

bool ResultTable::hasSelection() const {
    return selectedItems().size() > 1;  // one is the cell that the last click or arrow went to
}

void ResultTable::copySelection() {
    QApplication::clipboard()->setText(joined(QLatin1Char('\t'), hasSelection()));
}

void ResultTable::paintEvent(QPaintEvent* event) {
    WithWholeRows::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(viewport());
        painter.setPen(Theme::instance().accent());
        painter.drawRect(viewport()->rect().adjusted(0, 0, -1, -1));
    }
}

void ResultTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
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
    menu.addAction(tr("Copy selection"), this, &ResultTable::copySelection)
        ->setEnabled(hasSelection());
    menu.addAction(tr("Copy table as text"), this,
                   [this] { QApplication::clipboard()->setText(asText()); });
    menu.addAction(tr("Copy table as CSV"), this,
                   [this] { QApplication::clipboard()->setText(asCsv()); });
    menu.exec(event->globalPos());
}

void ResultTable::setShownRows(int rows) {
    shownRows_ = rows;
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    updateGeometry();
}

int ResultTable::heightOf(int rowHeight) const {
    const int heading =
        horizontalHeader()->isHidden() ? 0 : horizontalHeader()->sizeHint().height();
    const int bar = isOver_ ? horizontalScrollBar()->sizeHint().height() : 0;
    return heading + (shownRows_ > 0 ? shownRows_ : rowCount()) * rowHeight + bar + 2;
}

QSize ResultTable::sizeHint() const {
    return {240, heightOf(verticalHeader()->defaultSectionSize())};
}

QSize ResultTable::minimumSizeHint() const {
    return {120, heightOf(plainRowHeight())};  // with differences below its numbers it scrolls
}

}  // namespace ravnoves
