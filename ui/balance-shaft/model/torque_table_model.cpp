#include "balance-shaft/model/torque_table_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "numerics/constants.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"

namespace ravnoves {

using balance_shaft::TorqueTable;

namespace {

/// A number as the table shows it; editing and copying have all its digits.
QString shortened(const QString& text) {
    constexpr qsizetype longest = 9;
    constexpr int digits = 6;
    const auto value = text.size() > longest ? readFormNumber(text) : std::nullopt;
    return value ? formNumber(*value, QLocale(), digits) : text;
}

/// What the cell's text represents; nothing where it is no number, or may be two.
std::optional<double> readCell(const QString& text) {
    return readWithThousands(text, {}) ? std::nullopt : readFormNumber(text);
}

/// Why it represents nothing.
QString cellTrouble(const QString& text) {
    const QString thousands = thousandsTrouble(text, {});
    return thousands.isEmpty() ? notANumberText(text) : thousands;
}

/// Why a table is no cycle; empty where it is one.
QString cycleTrouble(const TorqueTable& table) {
    try {
        balance_shaft::check_torque_table(table, "/input/torque");
    } catch (const InputError& error) {
        return errorText(error);
    }
    return {};
}

}  // namespace

QString TorqueTableModel::ownText(const Row& row, int column) {
    return column == CrankAngle ? formNumber(row.angle, QLocale(), 15)
                                : shownFigures(row.torque, units::N_m, 15);
}

QString TorqueTableModel::textOf(const Row& row, int column) {
    if (row.typed) {
        const auto& text = column == CrankAngle ? row.typed->angle : row.typed->torque;
        if (text) {
            return *text;
        }
    }
    return ownText(row, column);
}

std::optional<double> TorqueTableModel::angleOf(const Row& row) {
    return row.typed && row.typed->angle ? readCell(*row.typed->angle) : row.angle;
}

std::optional<double> TorqueTableModel::torqueOf(const Row& row) {
    if (!row.typed || !row.typed->torque) {
        return row.torque;
    }
    const auto shown = readCell(*row.typed->torque);
    return shown ? std::optional(*shown * row.typed->unit) : std::nullopt;
}

/// The row's own text represents all digits of its number.
void TorqueTableModel::type(Row& row, int column, const QString& text) {
    if (!row.typed) {
        row.typed = std::make_unique<Typed>();
    }
    auto& cell = column == CrankAngle ? row.typed->angle : row.typed->torque;
    row.typed->unit = shownAs(units::N_m);
    cell = text == ownText(row, column) ? std::nullopt : std::optional(text);
}

void TorqueTableModel::setTable(const TorqueTable& table) {
    if (table == valid_ && !rows_.empty()) {
        return;
    }
    if (table.size() == rows_.size() && !rows_.empty()) {
        follow(table);
    } else {
        showAnew(table);
    }
}

void TorqueTableModel::showAnew(const TorqueTable& table) {
    beginResetModel();
    rows_.clear();
    rows_.reserve(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        rows_.push_back({table.crank_angle_deg[i], table.torque[i]});
    }
    valid_ = table;
    trouble_.clear();
    endResetModel();
    Q_EMIT troubleChanged(trouble_);
}

/// What is rejected stands until the case changes there.
void TorqueTableModel::follow(const TorqueTable& table) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        if (row.typed && row.angle != table.crank_angle_deg[i]) {
            row.typed->angle.reset();
        }
        if (row.typed && row.torque != table.torque[i]) {
            row.typed->torque.reset();
        }
        row.angle = table.crank_angle_deg[i];
        row.torque = table.torque[i];
    }
    valid_ = table;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Torque));
    check();
}

void TorqueTableModel::forgetRefused() {
    if (!trouble_.isEmpty()) {
        showAnew(TorqueTable(valid_));
    }
}

QString TorqueTableModel::refusedText(std::size_t row) const {
    for (const int column : {int(CrankAngle), int(Torque)}) {
        if (!numberOf(rows_[row], column)) {
            return cellTrouble(textOf(rows_[row], column));
        }
    }
    const auto angle = [this](std::size_t i) { return formNumber(shownAngle(i), QLocale()); };
    if (isOutOfOrder(row)) {
        return row == 0 ? tr("%1° is not below the angle of the next row, %2°.")
                              .arg(angle(row), angle(row + 1))
               : row + 1 == rows_.size()
                   ? tr("%1° is not above the angle of the row before, %2°.")
                         .arg(angle(row), angle(row - 1))
                   : tr("%1° is not between the angles of its neighbours, %2° and %3°.")
                         .arg(angle(row), angle(row - 1), angle(row + 1));
    }
    if (isBeyondCycle(row)) {
        return tr("with %1° the angles do not span 720° (two-stroke: 360°).").arg(angle(row));
    }
    if (isOpenEnd(row)) {
        return tr("the first and the last torque must be equal (same instant of the cycle).");
    }
    return {};
}

QString TorqueTableModel::refusedTexts() const {
    SaidTroubles troubles;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QString why = refusedText(i);
        if (!why.isEmpty()) {
            troubles.add(tr("Row %1: %2").arg(i + 1).arg(why));
        }
    }
    return troubles.text(tr("Further rows with errors: %1"));
}

std::optional<double> TorqueTableModel::numberOf(const Row& row, int column) {
    return column == CrankAngle ? angleOf(row) : torqueOf(row);
}

TorqueTable TorqueTableModel::tableOf(Cells which) const {
    TorqueTable table;
    table.crank_angle_deg.reserve(rows_.size());
    table.torque.reserve(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        const bool isOwnAngle = which == Cells::taken && (isOutOfOrder(i) || isBeyondCycle(i));
        const bool isOwnTorque = which == Cells::taken && isOpenEnd(i);
        table.crank_angle_deg.push_back(isOwnAngle ? row.angle : shownAngle(i));
        table.torque.push_back(isOwnTorque ? row.torque : torqueOf(row).value_or(row.torque));
    }
    return table;
}

void TorqueTableModel::check() {
    TorqueTable table = tableOf(Cells::typed);
    QString trouble = refusedTexts();
    QString why = cycleTrouble(table);
    if (!why.isEmpty()) {
        table = tableOf(Cells::taken);
        const QString still = cycleTrouble(table);
        if (!still.isEmpty() || trouble.isEmpty()) {
            trouble += (trouble.isEmpty() ? QString() : QStringLiteral("\n")) + why;
        }
        why = still;
    }
    if (trouble != trouble_) {
        trouble_ = trouble;
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Torque), {TroubleRole});
        Q_EMIT troubleChanged(trouble_);
    }
    if (why.isEmpty() && !(table == valid_)) {
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            rows_[i].angle = table.crank_angle_deg[i];
            rows_[i].torque = table.torque[i];
        }
        valid_ = std::move(table);
        Q_EMIT tableEdited();
    }
}

bool TorqueTableModel::isPending(std::size_t row, int column) const {
    if (!rows_[row].typed) {
        return false;  // as most are of a long table
    }
    const auto number = numberOf(rows_[row], column);
    return number && *number != (column == CrankAngle ? rows_[row].angle : rows_[row].torque);
}

double TorqueTableModel::shownAngle(std::size_t row) const {
    return angleOf(rows_[row]).value_or(rows_[row].angle);
}

bool TorqueTableModel::isOutOfOrder(std::size_t row) const {
    if (!isPending(row, CrankAngle)) {
        return false;  // the case's own grow
    }
    const double angle = shownAngle(row);
    return (row > 0 && !(angle > shownAngle(row - 1))) ||
           (row + 1 < rows_.size() && !(angle < shownAngle(row + 1)));
}

bool TorqueTableModel::isBeyondCycle(std::size_t row) const {
    if ((row != 0 && row + 1 != rows_.size()) || !isPending(row, CrankAngle)) {
        return false;
    }
    const double span = shownAngle(rows_.size() - 1) - shownAngle(0);
    const auto is = [&](double cycle) { return std::abs(span - cycle) <= 1e-9 * cycle; };
    return !is(2.0 * turn_deg) && !is(turn_deg);
}

bool TorqueTableModel::isOpenEnd(std::size_t row) const {
    if (row != 0 && row + 1 != rows_.size()) {
        return false;
    }
    const auto first = torqueOf(rows_.front());
    const auto last = torqueOf(rows_.back());
    return first && last && *first != *last &&
           (isPending(0, Torque) || isPending(rows_.size() - 1, Torque));
}

bool TorqueTableModel::isRefused(int row, int column) const {
    if (trouble_.isEmpty()) {
        return false;
    }
    const auto place = static_cast<std::size_t>(row);
    return !numberOf(rows_[place], column) ||
           (column == Torque ? isOpenEnd(place) : isOutOfOrder(place) || isBeyondCycle(place));
}

SceneModel* TorqueTableModel::scene() const {
    return model_;
}

void TorqueTableModel::putInto(balance_shaft::Input& input, const TorqueTable& table) {
    input.torque.kind = balance_shaft::TorqueSource::Kind::table;
    input.torque.csv.clear();
    input.torque.table = table;
    input.strokes = input.strokes_of_torque();
}

void TorqueTableModel::insertRowBelow(int row) {
    if (rows_.empty()) {
        return;
    }
    const int at = std::clamp(row + 1, 1, static_cast<int>(rows_.size()) - 1);
    // Half way between its neighbours, so that the table stays a cycle and means the same.
    const Row& above = rows_[static_cast<std::size_t>(at) - 1];
    const Row& below = rows_[static_cast<std::size_t>(at)];
    Row fresh{0.5 * (above.angle + below.angle), 0.5 * (above.torque + below.torque)};
    beginInsertRows({}, at, at);
    rows_.insert(rows_.begin() + at, std::move(fresh));
    endInsertRows();
    check();
}

void TorqueTableModel::removeRowRange(int first, int count) {
    // The first and the last row are the ends of the cycle and stay.
    const int last = std::min(first + count, static_cast<int>(rows_.size()) - 1);
    first = std::max(first, 1);
    if (last <= first) {
        return;
    }
    beginRemoveRows({}, first, last - 1);
    rows_.erase(rows_.begin() + first, rows_.begin() + last);
    endRemoveRows();
    check();
}

QString TorqueTableModel::replaceByText(const std::string& text) {
    balance_shaft::ParsedTorqueTable read = balance_shaft::parse_torque_table(text);
    if (!read.unit_named) {
        read.unit = shownAs(units::N_m);
        for (double& torque : read.table.torque) {
            torque = torque * read.unit;
        }
    }
    replaceBy(read.table);
    return messageText(read.describe());
}

void TorqueTableModel::replaceBy(const TorqueTable& table) {
    // Read again from a file that has changed, it becomes the case's own.
    const bool differs =
        !(table == valid_) || (model_ != nullptr && model_->input().torque.has_changed());
    setTable(table);
    if (differs) {
        Q_EMIT tableEdited();
    }
}

/// Whether the first cells of a block are angles of this cycle that grow.
bool TorqueTableModel::beginsWithAngles(const std::vector<QStringList>& cells) const {
    double before = -std::numeric_limits<double>::infinity();
    for (const QStringList& line : cells) {
        const auto angle = line.isEmpty() ? std::nullopt : readCell(line.front());
        if (!angle || !(*angle > before) || *angle < rows_.front().angle ||
            *angle > rows_.back().angle) {
            return false;
        }
        before = *angle;
    }
    return true;
}

QString TorqueTableModel::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    if (rows_.empty()) {
        return {};
    }
    constexpr int columns = 2;
    const int wide = widthOf(cells);
    if (wide == columns && beginsWithAngles(cells)) {
        column = CrankAngle;  // whichever of the row's cells was chosen
    }
    if (QString why = noRoomText(cells, rowCount() - row, columns - column); !why.isEmpty()) {
        return why;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t at = static_cast<std::size_t>(row) + i;
        for (int j = 0; j < cells[i].size() && column + j < columns; ++j) {
            type(rows_[at], column + j, cells[i][j]);
        }
    }
    // The ends are one instant; a block with both has its own.
    const bool hasTorque = column + wide > Torque;
    const bool hasFirst = hasTorque && row == 0;
    const bool hasLast = hasTorque && static_cast<std::size_t>(row) + cells.size() >= rows_.size();
    if (hasFirst != hasLast) {
        const Row& from = hasFirst ? rows_.front() : rows_.back();
        type(hasFirst ? rows_.back() : rows_.front(), Torque, textOf(from, Torque));
    }
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 1));
    check();  // says itself what is wrong
    return {};
}

int TorqueTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int TorqueTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 2;
}

QVariant TorqueTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return shortened(textOf(row, index.column()));
        case Qt::EditRole:
            return textOf(row, index.column());
        case Qt::TextAlignmentRole:
            return int(Qt::AlignRight | Qt::AlignVCenter);
        case TroubleRole:
            return isRefused(index.row(), index.column());
        default:
            return {};
    }
}

bool TorqueTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid()) {
        return false;
    }
    const QString text = value.toString().trimmed();
    if (textOf(rows_[static_cast<std::size_t>(index.row())], index.column()) != text) {
        put(index, text);
    }
    return true;
}

void TorqueTableModel::takeBackRefused(const QModelIndex& at) {
    put(at, ownText(rows_[static_cast<std::size_t>(at.row())], at.column()));
}

void TorqueTableModel::put(const QModelIndex& index, const QString& text) {
    type(rows_[static_cast<std::size_t>(index.row())], index.column(), text);
    const int last = rowCount() - 1;
    if (index.column() == Torque && (index.row() == 0 || index.row() == last)) {
        type(rows_.front(), Torque, text);
        type(rows_.back(), Torque, text);
        Q_EMIT dataChanged(this->index(0, Torque), this->index(0, Torque));
        Q_EMIT dataChanged(this->index(last, Torque), this->index(last, Torque));
    }
    Q_EMIT dataChanged(index, index);
    check();
}

QVariant TorqueTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    if (orientation == Qt::Vertical) {
        return section + 1;
    }
    return section == CrankAngle ? tr("φ, °") : shownTitle(tr("torque, N·m")).text;
}

}  // namespace ravnoves
