#include "balance-shaft/model/torque_table_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
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

/// Why a table is no cycle; empty where it is one.
QString cycleTrouble(const TorqueTable& table) {
    try {
        balance_shaft::check_torque_table(table, "/input/torque");
    } catch (const InputError& error) {
        return errorText(error);
    }
    return {};
}

auto& numberAt(auto& table, const std::pair<int, int>& place) {
    return (place.second == TorqueTableModel::CrankAngle
                ? table.crank_angle_deg
                : table.torque)[static_cast<std::size_t>(place.first)];
}

/// Why a cell can not be what it is beside the others; empty where it can.
QString misplaced(const TorqueTable& table, const std::pair<int, int>& place) {
    const int row = place.first;
    const int column = place.second;
    const auto last = static_cast<int>(table.size()) - 1;
    const bool isEnd = row == 0 || row == last;
    if (column == TorqueTableModel::Torque) {
        return isEnd && table.torque.front() != table.torque.back()
                   ? TorqueTableModel::tr(
                         "the first and the last torque must be equal (same "
                         "instant of the cycle).")
                   : QString();
    }
    const auto angle = [&](int at) { return numberAt(table, std::pair(at, column)); };
    const QString text = formNumber(angle(row), QLocale());
    if ((row > 0 && !(angle(row) > angle(row - 1))) ||
        (row < last && !(angle(row) < angle(row + 1)))) {
        return TorqueTableModel::tr("%1° is out of order: the angles must ascend.").arg(text);
    }
    const auto spans = [&](double cycle) {
        return std::abs(angle(last) - angle(0) - cycle) <= 1e-9 * cycle;
    };
    return isEnd && !spans(turn_deg) && !spans(2.0 * turn_deg)
               ? TorqueTableModel::tr("with %1° the angles do not span 720° (two-stroke: 360°).")
                     .arg(text)
               : QString();
}

}  // namespace

TorqueTableModel::TorqueTableModel(BalanceShaftModel* model, QObject* parent)
    : EditableTable(parent), model_(model) {
    connect(model_, &SceneModel::changed, this, &TorqueTableModel::follow);
    connect(model_, &SceneModel::broughtIn, this, &TorqueTableModel::forgetRejected);
    follow();
}

const TorqueTable& TorqueTableModel::table() const {
    return model_->input().torque.table;
}

SceneModel* TorqueTableModel::scene() const {
    return model_;
}

std::string TorqueTableModel::rowName(int row) const {
    return format_number(numberAt(table(), Place(row, CrankAngle)));
}

int TorqueTableModel::rowOf(const Cell& cell) const {
    const std::vector<double>& angles = table().crank_angle_deg;
    return static_cast<int>(std::lower_bound(angles.begin(), angles.end(), std::stod(cell.first)) -
                            angles.begin());
}

QString TorqueTableModel::held(int row, int column) const {
    return QString::number(numberAt(table(), Place(row, column)), 'g', 17);
}

QString TorqueTableModel::rejectedText(const Cell& cell, const Rejected& rejected) const {
    return tr("Row %1: %2").arg(rowOf(cell) + 1).arg(rejected.why);
}

QString TorqueTableModel::ownText(const Place& place) const {
    constexpr int digits = 15;
    const double number = numberAt(table(), place);
    return place.second == CrankAngle ? formNumber(number, QLocale(), digits)
                                      : shownFigures(number, units::N_m, digits);
}

void TorqueTableModel::put(Texts texts) {
    strokesNote_.clear();
    const TorqueTable own = table();
    const Place ends[] = {{0, Torque}, {rowCount() - 1, Torque}};
    for (const auto& [end, other] : {std::pair(ends[0], ends[1]), std::pair(ends[1], ends[0])}) {
        if (const auto typed = texts.find(end); typed != texts.end()) {
            texts.emplace(other, typed->second);
        }
    }
    for (const Cell& cell : rejectedCells()) {
        texts.emplace(Place(rowOf(cell), cell.second), rejected().at(cell).text);
    }
    Texts rejected;  // why
    TorqueTable all = own;
    for (const auto& [place, text] : texts) {
        if (text == ownText(place)) {
            continue;  // all digits, however the text is read
        }
        const ShownUnit unit = shownUnit(place.second == CrankAngle ? units::degree : units::N_m);
        if (const auto [number, trouble] = readTypedNumber(text, unit.name); number) {
            numberAt(all, place) =
                place.second == CrankAngle ? *number : *number * shownAs(units::N_m);
        } else {
            rejected[place] = trouble.isEmpty() ? notANumberText(text) : trouble;
        }
    }
    TorqueTable taken = all;
    QString trouble = cycleTrouble(all);
    if (!trouble.isEmpty()) {
        for (const auto& [place, text] : texts) {
            if (QString why = misplaced(all, place);
                !why.isEmpty() && numberAt(all, place) != numberAt(own, place)) {
                rejected.emplace(place, std::move(why));
                numberAt(taken, place) = numberAt(own, place);
            }
        }
        trouble = cycleTrouble(taken);
    }
    if (trouble.isEmpty() && !(taken == own)) {
        trouble = take(taken);
    }
    for (const auto& [place, text] : texts) {
        const auto why = rejected.find(place);
        setRejected(place.first, place.second, text,
                    why != rejected.end()    ? why->second
                    : text == ownText(place) ? QString()
                                             : trouble);
    }
    Q_EMIT troubleChanged(EditableTable::trouble());
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Torque));
}

QString TorqueTableModel::take(const TorqueTable& table) {
    const int before = model_->input().strokes;
    const QString why = model_->edit(tr("Edit torque table"), [&](balance_shaft::Input& input) {
        input.torque.kind = balance_shaft::TorqueSource::Kind::table;
        input.torque.csv.name.clear();
        input.torque.table = table;
        input.strokes = input.strokes_of_torque();
    });
    const int now = model_->input().strokes;
    strokesNote_ = now == before ? QString()
                   : now == 2    ? tr("The table covers 360°: the four-stroke engine is now a "
                                         "two-stroke. Undo restores it.")
                                 : tr("The table covers 720°: the two-stroke engine is now a "
                                         "four-stroke. Undo restores it.");
    return why;
}

int TorqueTableModel::insertRowBelow(int row) {
    TorqueTable longer = table();
    const bool begins = longer.size() == 0;
    if (begins) {
        longer = {{0.0, model_->input().cycle_deg()}, {0.0, 0.0}};
    }
    // Half way between its neighbours, so that the table stays a cycle and means the same.
    const auto at = std::clamp<std::ptrdiff_t>(row + 1, 1, std::ssize(longer.torque) - 1);
    for (std::vector<double>* column : {&longer.crank_angle_deg, &longer.torque}) {
        const auto below = column->begin() + at;
        column->insert(below, 0.5 * (*(below - 1) + *below));
    }
    return !take(longer).isEmpty() ? -1 : begins ? 0 : static_cast<int>(at);
}

void TorqueTableModel::removeRowRange(int first, int count) {
    // The first and the last row are the ends of the cycle and stay.
    TorqueTable shorter = table();
    const int last = std::min(first + count, rowCount() - 1);
    first = std::max(first, 1);
    if (first < last) {
        for (std::vector<double>* column : {&shorter.crank_angle_deg, &shorter.torque}) {
            column->erase(column->begin() + first, column->begin() + last);
        }
        take(shorter);
    }
}

QString TorqueTableModel::replaceByText(const std::string& text) {
    balance_shaft::ParsedCycle read =
        balance_shaft::parse_cycle(balance_shaft::Measured::torque, text);
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
    strokesNote_.clear();
    // Read again from a file that has changed, it becomes the case's own.
    if (!(table == this->table()) || model_->input().torque.has_changed()) {
        take(table);
    }
    forgetRejected();
}

QString TorqueTableModel::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    if (rowCount() == 0) {
        return {};
    }
    constexpr int columns = 2;
    if (QString why = noRoomText(cells, rowCount() - row, columns - column); !why.isEmpty()) {
        return why;
    }
    Texts texts;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (int j = 0; j < cells[i].size() && column + j < columns; ++j) {
            texts[{row + static_cast<int>(i), column + j}] = cells[i][j];
        }
    }
    put(std::move(texts));  // says itself what is wrong
    return {};
}

int TorqueTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(table().size());
}

int TorqueTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 2;
}

QVariant TorqueTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    if (const QVariant kept = rejectedData(index, role); kept.isValid()) {
        return kept;
    }
    switch (role) {
        case Qt::DisplayRole:
            return trueMinus(shortened(ownText({index.row(), index.column()})));
        case Qt::EditRole:
            return ownText({index.row(), index.column()});
        case Qt::TextAlignmentRole:
            return int(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

bool TorqueTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid()) {
        return false;
    }
    const QString text = value.toString().trimmed();
    if (index.data(Qt::EditRole).toString() != text) {
        put({{{index.row(), index.column()}, text}});
    }
    return true;
}

QVariant TorqueTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation == Qt::Vertical) {
        return EditableTable::headerData(section, orientation, role);
    }
    return section == CrankAngle ? tr("φ, °") : shownTitle(tr("torque, N·m")).text;
}

}  // namespace ravnoves
