// What stands beside the numbers of a table: differences to a reference, and ±.

#include <QHeaderView>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "text/number_text.h"
#include "text/text_width.h"
#include "theme/theme.h"
#include "widgets/cell_delegate.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

/// Of a cell: its difference, absolute and percent.
constexpr int differenceRole = Qt::UserRole + 1;
/// Of a cell: its ±.
constexpr int spreadRole = Qt::UserRole + 2;

QFont differenceFont() {
    return Theme::font(Theme::smallSize);
}

int differenceHeight() {
    return QFontMetrics(differenceFont()).height() - 1;
}

/// The first so many parts stand in one line.
QStringList linesOf(const QStringList& parts, int joined) {
    QStringList first = parts.mid(0, joined);
    first.removeAll(QString());
    return QStringList(first.join(QStringLiteral("  "))) + parts.mid(joined);
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
        return QStringLiteral("± 0");
    }
    const auto shown = [&](double size) {
        return most < 1e-9 || most >= 1e9 ? formNumber(size, QLocale(), 2)
                                          : fixedDecimals(size, decimals, QLocale());
    };
    constexpr double alike = 0.1;
    return least < 0.0 || most - least < alike * most
               ? QStringLiteral("± ") + shown(0.5 * (spread.below + spread.above))
               : QStringLiteral("+%1 −%2").arg(shown(spread.above), shown(spread.below));
}

/// A cell over the small lines of its difference.
class DifferenceDelegate final : public CellDelegate {
  public:
    using CellDelegate::CellDelegate;

    bool below = false;  ///< differences stand below the numbers
    int joined = 1;      ///< parts in the first line

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        if (!below) {
            CellDelegate::paint(painter, option, index);
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
        line.setHeight(ResultTable::plainRowHeight());
        painter->save();
        painter->setFont(cell.font);
        painter->setPen(colour);
        const QStringList parts = besideOf(index.data(differenceRole), index.data(spreadRole));
        // Words have the room that differences take of the other cells.
        const QRect room = line.adjusted(0, 1, 0, cell.rect.height() - line.height());
        const int wrapped = (side & Qt::AlignHorizontal_Mask) | Qt::TextWordWrap;
        if (parts.isEmpty() && textWidth(cell.font, text) > line.width() &&
            room.contains(cell.fontMetrics.boundingRect(room, wrapped, text))) {
            painter->drawText(room, wrapped, text);
            painter->restore();
            return;
        }
        painter->drawText(line, side,
                          QFontMetrics(cell.font).elidedText(text, Qt::ElideRight, line.width()));
        painter->setFont(differenceFont());
        painter->setPen(isSelected ? colour : Theme::instance().mutedText());
        line.moveTop(line.top() + ResultTable::plainRowHeight() - 3);
        line.setHeight(differenceHeight());
        for (const QString& part : linesOf(parts, joined)) {
            painter->drawText(line, side, part);
            line.translate(0, differenceHeight());
        }
        painter->restore();
    }
};

}  // namespace

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
    areSpreadsAwaited_ = false;
    placedAt_ = -1;
    showSpreads();
    placeBeside();
}

void ResultTable::awaitSpreads() {
    if (!spreads_.empty() && !std::exchange(areSpreadsAwaited_, true)) {
        showSpreads();
        placeBeside();
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
            const QString text = spread == nullptr    ? QString()
                                 : areSpreadsAwaited_ ? QStringLiteral("± …")
                                                      : spreadText(*spread, *numberAt(row, column));
            QTableWidgetItem* cell = item(row, column);
            if (cell == nullptr) {
                continue;
            }
            if (cell->data(spreadRole).toString() != text) {
                cell->setData(spreadRole, text.isEmpty() ? QVariant() : QVariant(text));
            }
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

int ResultTable::joinedIn(Place place) {
    constexpr int difference = 2;
    return place == Place::Line ? difference + 1 : place == Place::Pair ? difference : 1;
}

int ResultTable::widthOf(int row, int column, Place place) const {
    const QTableWidgetItem* cell = item(row, column);
    if (cell == nullptr) {
        return 0;
    }
    int width = 0;
    const bool wraps = place == Place::Words && column > 0 && besideAt(row, column).isEmpty();
    for (const QString& part :
         wraps ? cell->text().split(QLatin1Char(' ')) : QStringList(cell->text())) {
        width = std::max(width, qCeil(textWidth(font(), part)));
    }
    if (place != Place::Columns) {
        const QFontMetrics small(differenceFont());
        for (const QString& part : linesOf(besideAt(row, column), joinedIn(place))) {
            width = std::max(width, small.horizontalAdvance(part));
        }
    }
    return width + padding();
}

int ResultTable::roomFor(Place place) const {
    int sum = 0;
    if (place == Place::Columns) {
        const auto add = [&](int least, const auto& textAt) {
            int width = Theme::withText(least);
            for (int row = 0; row < rowCount(); ++row) {
                width = std::max(width, qCeil(textWidth(font(), textAt(row))) + padding());
            }
            sum += width;
        };
        for (int part = 0; part < 2 && !compared_.isEmpty(); ++part) {
            add(60, [&](int row) { return differenceAt(row, compared_.front()).value(part); });
        }
        if (!spread_.isEmpty()) {
            add(40, [&](int row) { return spreadAt(row, spread_.front()); });
        }
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
            const bool hasPairs = !compared_.isEmpty() && !spread_.isEmpty();
            Place needed = Place::Line;
            while (needed != Place::Words &&
                   ((needed == Place::Pair && !hasPairs) || roomFor(needed) > room)) {
                needed = static_cast<Place>(static_cast<int>(needed) + 1);
            }
            leastPlace_ = std::max(leastPlace_, needed);
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
    const int parts = (compared_.isEmpty() ? 0 : 2) + (spread_.isEmpty() ? 0 : 1);
    const int lines = std::max(1, parts - joinedIn(place) + 1);
    const int height = plainRowHeight() + (inColumns ? 0 : lines * differenceHeight());
    if (columnCount() != wanted || place != place_) {
        fitted_ = false;
        place_ = place;
        setColumnCount(wanted);
    }
    if (auto* delegate = dynamic_cast<DifferenceDelegate*>(itemDelegate())) {
        delegate->below = !inColumns;
        delegate->joined = joinedIn(place);
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
            cell->setToolTip(tip);
        }
    }
    fitColumns();
}

}  // namespace ravnoves
