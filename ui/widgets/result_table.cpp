#include "widgets/result_table.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "text/csv_format.h"
#include "text/number_text.h"
#include "text/text_width.h"
#include "theme/theme.h"
#include "widgets/wrapped_header.h"

namespace ravnoves {

namespace {

/// Of a cell: its difference, absolute and percent.
constexpr int differenceRole = Qt::UserRole + 1;
/// Of a cell: its ±.
constexpr int spreadRole = Qt::UserRole + 2;
/// Of a cell: why its ± fails, as its tip ends.
constexpr int failsRole = Qt::UserRole + 3;
constexpr int usualPadding = 9;
constexpr int leastPadding = 7;

int plainRowHeight() {
    return Theme::withText(20);
}

QFont differenceFont() {
    return Theme::font(Theme::smallSize);
}

int differenceHeight() {
    return QFontMetrics(differenceFont()).height() - 1;
}

QStringList inOneLine(QStringList parts) {
    parts.removeAll(QString());
    return {parts.join(QStringLiteral("  "))};
}

QStringList besideOf(const QVariant& difference, const QVariant& spread) {
    QStringList parts = difference.toStringList();
    if (!spread.isNull()) {
        parts << spread.toString();
    }
    return parts;
}

/// So many digits that two of the larger side say something, beside this number.
QString spreadText(const ResultTable::Spread& spread, const ResultNumber& number) {
    const double most = std::max(spread.below, spread.above);
    const double least = std::min(spread.below, spread.above);
    const int wanted = std::clamp(1 - static_cast<int>(std::floor(std::log10(most))), 0, 9);
    const int decimals = std::min(wanted, number.decimals.value_or(9) + 1);
    if (most < 0.5 * std::pow(10.0, -decimals)) {
        // Far less than the number's last digit.
        return QStringLiteral("± 0") + (spread.fails.isEmpty() ? QString() : QStringLiteral("⚠"));
    }
    const auto shown = [&](double size) {
        return most < 1e-9 || most >= 1e9 ? formNumber(size, QLocale(), 2)
                                          : fixedDecimals(size, decimals, QLocale());
    };
    constexpr double alike = 0.1;
    QString text = least < 0.0 || most - least < alike * most
                       ? QStringLiteral("± ") + shown(0.5 * (spread.below + spread.above))
                       : QStringLiteral("+%1 −%2").arg(shown(spread.above), shown(spread.below));
    return spread.fails.isEmpty() ? text : text + QStringLiteral("⚠");
}

/// The tip of a cell says what its ± is, behind what it says anyway.
void sayFails(QTableWidgetItem& cell, const QString& fails) {
    const QString said = cell.data(failsRole).toString();
    QString tip = cell.toolTip();
    if (!said.isEmpty() && tip.endsWith(said)) {
        tip.chop(said.size());
        tip = tip.trimmed();
    }
    if (!fails.isEmpty()) {
        tip += (tip.isEmpty() ? QString() : QStringLiteral("\n")) + fails;
    }
    if (tip != cell.toolTip()) {
        cell.setToolTip(tip);
    }
    if (said != fails) {
        cell.setData(failsRole, fails.isEmpty() ? QVariant() : QVariant(fails));
    }
}

/// A cell over the small lines of its difference.
class DifferenceDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    bool below = false;    ///< differences stand below the numbers
    bool inLine = false;   ///< both parts in one line
    bool isAmber = false;  ///< what is small

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        if (!below) {
            QStyledItemDelegate::paint(painter, option, index);
            return;
        }
        QStyleOptionViewItem cell = option;
        initStyleOption(&cell, index);
        const QString text = std::exchange(cell.text, QString());
        cell.widget->style()->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
        const bool isSelected = (cell.state & QStyle::State_Selected) != 0;
        const QColor colour =
            cell.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
        const int side =
            static_cast<int>((cell.displayAlignment & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter);
        QRect line = cell.rect.adjusted(3, 0, -3, 0);
        line.setHeight(plainRowHeight());
        painter->save();
        painter->setFont(cell.font);
        painter->setPen(colour);
        painter->drawText(line, side,
                          QFontMetrics(cell.font).elidedText(text, Qt::ElideRight, line.width()));
        painter->setFont(differenceFont());
        const Theme& theme = Theme::instance();
        painter->setPen(isSelected ? colour : isAmber ? theme.warning() : theme.mutedText());
        const QStringList parts = besideOf(index.data(differenceRole), index.data(spreadRole));
        line.moveTop(line.top() + plainRowHeight() - 3);
        line.setHeight(differenceHeight());
        for (const QString& part : inLine ? inOneLine(parts) : parts) {
            painter->drawText(line, side, part);
            line.translate(0, differenceHeight());
        }
        painter->restore();
    }
};

}  // namespace

ResultTable::ResultTable(QWidget* parent)
    : WithWholeRows(parent), header_(new WrappedHeader(this)) {
    static int made = 0;
    number_ = ++made;
    setHorizontalHeader(header_);
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

// ---------------------------------------------------------------------------------- differences

void ResultTable::setReference(ResultTable* table, const QString& name) {
    if (reference_ == table && referenceName_ == name) {
        return;
    }
    if (reference_ != nullptr) {
        reference_->referenceOf_ = nullptr;
    }
    reference_ = table;
    referenceName_ = name;
    placedAt_ = -1;
    if (table != nullptr) {
        table->referenceOf_ = this;
    }
    showDifferences();
}

void ResultTable::setSpreads(std::vector<Spread> spreads, const QString& how) {
    if (spreads.empty() && spreads_.empty()) {
        return;
    }
    spreads_ = std::move(spreads);
    spreadTip_ = how;
    areSpreadsStopped_ = false;
    placedAt_ = -1;
    showSpreads();
    placeBeside();
}

void ResultTable::stopSpreads(const QString& why) {
    if (!spreads_.empty() && !areSpreadsStopped_) {
        areSpreadsStopped_ = true;
        spreadTip_ += QLatin1Char('\n') + why;
        placeBeside();
        viewport()->update();
    }
}

QString ResultTable::spreadAt(int row, int column) const {
    const QTableWidgetItem* cell = item(row, column);
    return cell != nullptr ? cell->data(spreadRole).toString() : QString();
}

QStringList ResultTable::besideAt(int row, int column) const {
    const QTableWidgetItem* cell = item(row, column);
    return cell != nullptr ? besideOf(cell->data(differenceRole), cell->data(spreadRole))
                           : QStringList();
}

void ResultTable::showSpreads() {
    spread_.clear();
    std::vector<std::vector<const Spread*>> shown(static_cast<std::size_t>(rowCount()));
    for (const Spread& each : spreads_) {
        if (numberAt(each.row, each.column) == nullptr ||
            rows_[each.row].front().text != each.name ||
            !(std::max(each.below, each.above) > 0.0)) {
            continue;
        }
        auto& row = shown[static_cast<std::size_t>(each.row)];
        row.resize(static_cast<std::size_t>(columns_));
        row[static_cast<std::size_t>(each.column)] = &each;
        if (!spread_.contains(each.column)) {
            spread_ << each.column;
        }
    }
    for (int row = 0; row < rowCount(); ++row) {
        const auto& spreads = shown[static_cast<std::size_t>(row)];
        for (int column = 0; column < columns_; ++column) {
            const Spread* spread =
                spreads.empty() ? nullptr : spreads[static_cast<std::size_t>(column)];
            const QString text =
                spread != nullptr ? spreadText(*spread, *numberAt(row, column)) : QString();
            QTableWidgetItem* cell = item(row, column);
            if (cell == nullptr) {
                continue;
            }
            if (cell->data(spreadRole).toString() != text) {
                cell->setData(spreadRole, text.isEmpty() ? QVariant() : QVariant(text));
            }
            sayFails(*cell, spread != nullptr ? spread->fails : QString());
        }
    }
}

QStringList ResultTable::differenceAt(int row, int column) const {
    const QTableWidgetItem* cell = item(row, column);
    return cell != nullptr ? cell->data(differenceRole).toStringList() : QStringList();
}

int ResultTable::rowInReference(int row) const {
    const auto name = [](const ResultTable& table, int at) {
        const ResultRow row = table.rows_.value(at);
        return row.name.isEmpty() ? row.value(0).text : row.name;
    };
    const QString wanted = name(*this, row);
    if (row < reference_->rowCount() && name(*reference_, row) == wanted) {
        return row;
    }
    // Of rows with one name the first is the first there.
    int before = 0;
    for (int i = 0; i < row; ++i) {
        before += name(*this, i) == wanted ? 1 : 0;
    }
    for (int i = 0; i < reference_->rowCount(); ++i) {
        if (name(*reference_, i) == wanted && before-- == 0) {
            return i;
        }
    }
    return -1;
}

const ResultNumber* ResultTable::numberAt(int row, int column) const {
    const bool isThere = row < rows_.size() && column > 0 && column < rows_[row].size();
    return isThere ? rows_[row][column].number() : nullptr;
}

void ResultTable::showDifferences() {
    compared_.clear();
    for (int row = 0; row < rows_.size(); ++row) {
        const int other = reference_ != nullptr ? rowInReference(row) : -1;
        const ResultRow was = other >= 0 ? reference_->rows_[other] : ResultRow();
        for (int column = 1; column < columns_; ++column) {
            const auto found = rows_[row].value(column).from(was.value(column));
            const QStringList parts =
                found ? QStringList{found->absolute, found->percent} : QStringList();
            if (differenceAt(row, column) != parts) {
                item(row, column)->setData(differenceRole, found ? QVariant(parts) : QVariant());
            }
            if (found && !compared_.contains(column)) {
                compared_ << column;
            }
        }
    }
    placeBeside();
}

int ResultTable::widthOf(int row, int column, Place place) const {
    const QTableWidgetItem* cell = item(row, column);
    if (cell == nullptr) {
        return 0;
    }
    int width = qCeil(textWidth(font(), cell->text()));
    if (place != Place::Columns) {
        const QStringList parts = besideAt(row, column);
        const QFontMetrics small(differenceFont());
        for (const QString& part : place == Place::Line ? inOneLine(parts) : parts) {
            width = std::max(width, small.horizontalAdvance(part));
        }
    }
    return width + padding();
}

int ResultTable::headingWidth(int column) const {
    return header_->widthOf(horizontalHeaderItem(column)->text(), wraps_) + padding();
}

int ResultTable::padding() const {
    return wraps_ ? leastPadding : usualPadding;
}

int ResultTable::roomFor(Place place) const {
    int sum = 0;
    if (place == Place::Columns) {
        sum = Theme::withText(compared_.isEmpty() ? 0 : 120);
        int spread = spread_.isEmpty() ? 0 : Theme::withText(40);
        for (int row = 0; row < rowCount() && !spread_.isEmpty(); ++row) {
            const QString text = spreadAt(row, spread_.front());
            spread = std::max(spread, qCeil(textWidth(font(), text)) + padding());
        }
        sum += spread;
    }
    for (int column = 0; column < columns_; ++column) {
        int width = column > 0 ? headingWidth(column) : 0;
        for (int row = 0; row < rowCount(); ++row) {
            width = std::max(width, widthOf(row, column, place));
        }
        sum += width;
    }
    return sum;
}

void ResultTable::placeBeside() {
    QList<int> beside = compared_;
    for (const int column : spread_) {
        if (!beside.contains(column)) {
            beside << column;
        }
    }
    if (beside.isEmpty() && columnCount() == columns_ && place_ == Place::Columns) {
        fitColumns();
        return;
    }
    if (dynamic_cast<DifferenceDelegate*>(itemDelegate()) == nullptr) {
        setItemDelegate(new DifferenceDelegate(this));
    }
    Place place = Place::Columns;
    if (!beside.isEmpty()) {
        // At one width they only ever fall back: rows that grow bring a scroll bar, which takes of
        // the room, and values that change under a slider would lay the table out to and fro.
        if (std::exchange(placedAt_, width()) != width()) {
            leastPlace_ = Place::Columns;
        }
        const int room = viewport()->width();
        if (beside.size() > 1 || roomFor(Place::Columns) > room) {
            leastPlace_ =
                std::max(leastPlace_, roomFor(Place::Line) <= room ? Place::Line : Place::Lines);
        }
        place = leastPlace_;
    }
    const bool inColumns = place == Place::Columns;
    const QStringList headings =
        QStringList(inColumns && !compared_.isEmpty()
                        ? QStringList{QStringLiteral("Δ"), QStringLiteral("Δ, %")}
                        : QStringList()) +
        QStringList(inColumns && !spread_.isEmpty() ? QStringList{QStringLiteral("±")}
                                                    : QStringList());
    const int wanted = columns_ + static_cast<int>(headings.size());
    const int lines = (compared_.isEmpty() ? 0 : 2) + (spread_.isEmpty() ? 0 : 1);
    const int height = plainRowHeight() +
                       (inColumns ? 0 : (place == Place::Line ? 1 : lines) * differenceHeight());
    if (columnCount() != wanted || place != place_) {
        fitted_ = false;
        place_ = place;
        setColumnCount(wanted);
    }
    if (auto* delegate = dynamic_cast<DifferenceDelegate*>(itemDelegate())) {
        delegate->below = !inColumns;
        delegate->inLine = place == Place::Line;
        delegate->isAmber = areSpreadsStopped_;
    }
    if (verticalHeader()->defaultSectionSize() != height) {
        verticalHeader()->setDefaultSectionSize(height);
        updateGeometry();
    }
    for (int column = columns_; column < wanted; ++column) {
        const int part = column - columns_;
        const bool isSpread = headings[part] == QStringLiteral("±");
        if (horizontalHeaderItem(column) == nullptr) {
            auto* heading = new QTableWidgetItem;
            heading->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            setHorizontalHeaderItem(column, heading);
        }
        horizontalHeaderItem(column)->setText(headings[part]);
        const QString tip =
            isSpread ? spreadTip_
                     : tr("Present value less that of the reference %1").arg(referenceName_);
        horizontalHeaderItem(column)->setToolTip(tip);
        for (int row = 0; row < rowCount(); ++row) {
            QTableWidgetItem* cell = item(row, column);
            if (cell == nullptr) {
                cell = new QTableWidgetItem;
                cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
                setItem(row, column, cell);
            }
            const QString text = isSpread ? spreadAt(row, spread_.front())
                                          : differenceAt(row, compared_.front()).value(part);
            if (cell->text() != text) {
                cell->setText(text);
            }
            const QTableWidgetItem* of = isSpread ? item(row, spread_.front()) : nullptr;
            const QString fails = of != nullptr ? of->data(failsRole).toString() : QString();
            cell->setToolTip(fails.isEmpty() ? tip : fails);
            cell->setForeground(isSpread && areSpreadsStopped_ ? QBrush(Theme::instance().warning())
                                                               : QBrush());
        }
    }
    fitColumns();
}

// ----------------------------------------------------------------------------------------- table

void ResultTable::setColumns(const ResultColumns& columns) {
    headings_ = columns;
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
    const QFontMetrics cells(table.font());
    const QHeaderView& header = *table.horizontalHeader();
    const QTableWidgetItem* heading =
        header.isHidden() ? nullptr : table.horizontalHeaderItem(column);
    int width = heading == nullptr
                    ? 0
                    : QFontMetrics(header.font()).horizontalAdvance(heading->text()) + padding;
    for (int row = 0; row < table.rowCount() && width < enough; ++row) {
        if (const QTableWidgetItem* cell = table.item(row, column)) {
            width = std::max(width, cells.horizontalAdvance(cell->text()) + padding);
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

void ResultTable::fitColumns() {
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
        setHorizontalScrollBarPolicy(over ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
        for (const int column : stretched_) {
            horizontalHeader()->setSectionResizeMode(
                column, over ? QHeaderView::Fixed : QHeaderView::Stretch);
        }
        updateGeometry();
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

void ResultTable::setRows(const ResultRows& rows) {
    rows_ = rows;
    if (rowCount() != rows.size()) {
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
            } else if (cell->text() != text) {
                cell->setText(text);
            }
        }
    }
    showTips();
    if (!spreads_.empty()) {
        showSpreads();
    }
    if (reference_ != nullptr || !spreads_.empty()) {
        showDifferences();
    } else {
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
