#include "balance-shaft/model/torque_table_model.h"

#include <QLocale>
#include <utility>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/run_beside.h"
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

/// What the cell's text stands for; nothing where it is no number, or may be two.
std::optional<double> readCell(const QString& text) {
    return readWithThousands(text, {}) ? std::nullopt : readFormNumber(text);
}

/// Why it stands for nothing.
QString cellTrouble(const QString& text) {
    const auto thousands = readWithThousands(text, {});
    return thousands ? eitherNumberText(text, *thousands, readFormNumber(text).value_or(0.0))
                     : notANumberText(text);
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

/// The row's own text stands for all digits of its number.
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
    if (!trouble_.isEmpty() && table.size() == rows_.size()) {
        follow(table);
        return;
    }
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

/// What is refused stands until the case changes there.
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
        const TorqueTable table = std::exchange(valid_, {});
        rows_.clear();
        setTable(table);
    }
}

QString TorqueTableModel::refusedTexts() const {
    constexpr int mostSaid = 3;
    QStringList troubles;
    int more = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool isAngle = !angleOf(rows_[i]);
        if (!isAngle && torqueOf(rows_[i])) {
            continue;
        }
        if (troubles.size() < mostSaid) {
            troubles << tr("Row %1: %2")
                            .arg(i + 1)
                            .arg(cellTrouble(textOf(rows_[i], isAngle ? CrankAngle : Torque)));
        } else {
            ++more;
        }
    }
    if (more > 0) {
        troubles << tr("Rows that are wrong besides: %1").arg(more);
    }
    return troubles.join(QLatin1Char('\n'));
}

TorqueTable TorqueTableModel::tableOf(Angles which) const {
    TorqueTable table;
    table.crank_angle_deg.reserve(rows_.size());
    table.torque.reserve(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        const bool isOwn = which == Angles::own || (which == Angles::growing && isOutOfOrder(i));
        table.crank_angle_deg.push_back(isOwn ? row.angle : angleOf(row).value_or(row.angle));
        table.torque.push_back(torqueOf(row).value_or(row.torque));
    }
    return table;
}

void TorqueTableModel::check() {
    QString trouble = refusedTexts();
    TorqueTable table = tableOf(Angles::typed);
    QString why = cycleTrouble(table);
    if (!why.isEmpty()) {
        trouble += (trouble.isEmpty() ? QString() : QStringLiteral("\n")) + why;
    }
    for (const Angles which : {Angles::growing, Angles::own}) {
        if (!why.isEmpty()) {
            table = tableOf(which);
            why = cycleTrouble(table);
        }
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

bool TorqueTableModel::isOutOfOrder(std::size_t row) const {
    const auto angle = angleOf(rows_[row]);
    if (!angle || *angle == rows_[row].angle) {
        return false;  // the case's own grow
    }
    const auto at = [this](std::size_t i) { return angleOf(rows_[i]).value_or(rows_[i].angle); };
    return (row > 0 && !(*angle > at(row - 1))) ||
           (row + 1 < rows_.size() && !(*angle < at(row + 1)));
}

bool TorqueTableModel::isRefused(int row, int column) const {
    if (trouble_.isEmpty()) {
        return false;
    }
    const auto place = static_cast<std::size_t>(row);
    return column == Torque ? !torqueOf(rows_[place])
                            : !angleOf(rows_[place]) || isOutOfOrder(place);
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

void TorqueTableModel::putTyped(const QModelIndex& at, const QString& text, CaseFile& file) {
    const auto number = readCell(text);
    if (!number || rows_.empty()) {
        return;
    }
    TorqueTable table = tableOf(Angles::typed);
    const auto row = static_cast<std::size_t>(at.row());
    if (at.column() == CrankAngle) {
        table.crank_angle_deg[row] = *number;
    } else {
        table.torque[row] = *number * shownAs(units::N_m);
        if (row == 0 || row + 1 == rows_.size()) {  // the cycle repeats
            table.torque.front() = table.torque.back() = table.torque[row];
        }
    }
    if (!cycleTrouble(table).isEmpty()) {
        return;
    }
    Json input = model_->inputAfter([&](balance_shaft::Input& next) { putInto(next, table); });
    if (!input.is_null()) {
        file.input = std::move(input);
    }
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

QString TorqueTableModel::replaceByText(const std::string& text, bool isShown) {
    balance_shaft::ParsedTorqueTable read;
    const auto parse = [&] { read = balance_shaft::parse_torque_table(text); };
    if (text.size() > longestReadAtOnce) {
        runBeside(parse);
    } else {
        parse();
    }
    if (isShown && text.find("N·m") == std::string::npos && text.find("Nm") == std::string::npos) {
        for (double& torque : read.table.torque) {
            torque = torque * shownAs(units::N_m);
        }
    }
    const bool differs = !(read.table == valid_);
    setTable(read.table);
    if (differs) {
        Q_EMIT tableEdited();
    }
    return messageText(read.describe());
}

QString TorqueTableModel::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t at = static_cast<std::size_t>(row) + i;
        if (at >= rows_.size()) {
            break;
        }
        for (int j = 0; j < cells[i].size() && column + j < 2; ++j) {
            type(rows_[at], column + j, cells[i][j]);
        }
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

Json TorqueTableModel::refusedState() const {
    constexpr std::size_t longest = 20'000;
    if (trouble_.isEmpty() || rows_.size() > longest) {
        return {};
    }
    const auto cell = [](const Row& row, int column, const std::optional<double>& number) {
        return number ? Json(*number) : Json(textOf(row, column).toStdString());
    };
    Json rows = Json::array();
    for (const Row& row : rows_) {
        rows.push_back({cell(row, CrankAngle, angleOf(row)), cell(row, Torque, torqueOf(row))});
    }
    return rows;
}

void TorqueTableModel::bringRefused(const Json& state) {
    std::vector<Row> rows;
    for (const Json& each : state) {
        const std::size_t place = rows.size();
        Row& row = rows.emplace_back();
        if (state.size() == valid_.size()) {  // what holds below a text
            row.angle = valid_.crank_angle_deg[place];
            row.torque = valid_.torque[place];
        }
        const auto put = [&](const Json& cell, double& own, int column) {
            if (cell.is_number()) {
                own = cell.get<double>();
            } else {
                type(row, column, QString::fromStdString(cell.get<std::string>()));
            }
        };
        put(each.at(0), row.angle, CrankAngle);
        put(each.at(1), row.torque, Torque);
    }
    if (rows.empty()) {
        return;
    }
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
    check();
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
