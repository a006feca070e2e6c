#include "studies/model/study_tables.h"

#include <algorithm>
#include <utility>

#include "text/number_text.h"

namespace ravnoves {

StudyTable::StudyTable(StudyModel* model, QStringList headings, QObject* parent)
    : EditableTable(parent), model_(model), headings_(std::move(headings)) {
    connect(model_, &StudyModel::changed, this, &StudyTable::follow);
}

int StudyTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(headings_.size());
}

Qt::ItemFlags StudyTable::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = EditableTable::flags(index);
    flags.setFlag(Qt::ItemIsEditable, isTyped(index.row(), index.column()));
    return flags;
}

QVariant StudyTable::headerData(int section, Qt::Orientation orientation, int role) const {
    const bool isText = orientation == Qt::Horizontal && role == Qt::DisplayRole;
    return isText ? headings_.value(section) : QVariant();
}

QVariant StudyTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    if (const QVariant kept = rejectedData(index, role); kept.isValid()) {
        return kept;
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant((index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) |
                        Qt::AlignVCenter);
    }
    const bool isTip = role == Qt::ToolTipRole && index.column() == Name;
    return isTip || role == Qt::DisplayRole || role == Qt::EditRole
               ? text(index.row(), index.column(), role == Qt::EditRole)
               : QVariant();
}

bool StudyTable::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || !isTyped(index.row(), index.column())) {
        return false;
    }
    const QString why = write(index.row(), index.column(), {{value.toString()}});
    setRejected(index.row(), index.column(), value.toString(), why);
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index, index);
    return why.isEmpty();
}

QString StudyTable::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    QString why = noRoomText(cells, rowCount() - row, columnCount() - column);
    if (why.isEmpty()) {
        why = write(row, column, cells);
        if (!why.isEmpty()) {
            return tr("Not pasted. %1").arg(why);
        }
        setTaken(row, column, cells);
    }
    return why;
}

QStringList StudyTable::rejectedNames() const {
    QStringList names;
    for (int row = 0; row < rowCount(); ++row) {
        for (const Cell& cell : rejectedCells()) {
            if (cell.first == rowName(row)) {
                names << text(row, Name, false);
            }
        }
    }
    return names;
}

QString StudyTable::rejectedText(const Cell& cell, const Rejected& rejected) const {
    for (int row = 0; row < rowCount(); ++row) {
        if (rowName(row) == cell.first) {
            return text(row, Name, false) + QStringLiteral(": ") + rejected.why;
        }
    }
    return rejected.why;
}

ScatterTable::ScatterTable(StudyModel* model, QObject* parent)
    : StudyTable(model, {tr("Input"), tr("Value"), QStringLiteral("±")}, parent) {
    follow();
}

const StudyModel::Input& ScatterTable::input(int row) const {
    return model_->inputs()[static_cast<std::size_t>(row)];
}

std::string ScatterTable::rowName(int row) const {
    return input(row).pointer;
}

QString ScatterTable::held(int row, int /*column*/) const {
    return StudyModel::scatterText(input(row));
}

int ScatterTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->inputs().size());
}

bool ScatterTable::isTyped(int row, int column) const {
    return column == Scatter && !input(row).isMissing;
}

QVariant ScatterTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (section == Scatter && orientation == Qt::Horizontal && role == Qt::ToolTipRole) {
        return tr(
            "0.02: uniform within ± 0.02. 1 %: uniform within ± 1 % of the value. σ 0.01: "
            "normal with this standard deviation.");
    }
    return StudyTable::headerData(section, orientation, role);
}

QString ScatterTable::text(int row, int column, bool isEdited) const {
    const StudyModel::Input& shown = input(row);
    if (column == Name) {
        return shown.isMissing ? StudyModel::tr("%1 (no longer in the case)").arg(shown.name)
                               : shown.name;
    }
    if (column == Nominal) {
        constexpr int digits = 8;
        const double value = shown.shown.factor * shown.value;
        return shown.isMissing
                   ? QStringLiteral("–")
                   : withUnit(trueMinus(writtenOut(value, QLocale(), digits)), shown.shown.name);
    }
    const QString scatter = StudyModel::scatterText(shown);
    const bool isPlain = isEdited || scatter.isEmpty() || scatter.endsWith(u'%');
    return isPlain ? scatter : withUnit(scatter, shown.shown.name);
}

QString ScatterTable::write(int row, int /*column*/, const std::vector<QStringList>& cells) {
    std::vector<std::pair<std::string, QString>> texts;
    for (const QStringList& line : cells) {
        texts.emplace_back(rowName(row++), line.back());
    }
    return model_->setScatter(texts);
}

QString ScatterTable::pasteBlock(int row, int /*column*/, const std::vector<QStringList>& cells) {
    std::vector<QStringList> tolerances;
    for (const QStringList& line : cells) {
        tolerances.push_back({line.back()});
    }
    return StudyTable::pasteBlock(row, Scatter, tolerances);
}

void ScatterTable::removeRowRange(int first, int count) {
    const int rows = std::min(count, rowCount() - first);
    pasteBlock(first, Scatter,
               std::vector<QStringList>(static_cast<std::size_t>(rows), {QString()}));
}

WatchTable::WatchTable(StudyModel* model, QObject* parent)
    : StudyTable(model, {tr("Result"), tr("Minimum"), tr("Maximum")}, parent) {
    follow();
}

const studies::Watched& WatchTable::watched(int row) const {
    return model_->study().watch[static_cast<std::size_t>(row)];
}

std::string WatchTable::rowName(int row) const {
    return watched(row).pointer;
}

int WatchTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->study().watch.size());
}

bool WatchTable::isTyped(int /*row*/, int column) const {
    return column != Name;
}

QString WatchTable::text(int row, int column, bool /*isEdited*/) const {
    const studies::Watched& shown = watched(row);
    return column == Name
               ? model_->resultName(shown.pointer).withUnit()
               : model_->limitText(shown.pointer, column == Minimum ? shown.min : shown.max);
}

bool WatchTable::setData(const QModelIndex& index, const QVariant& value, int role) {
    const int other = index.column() == Minimum ? Maximum : Minimum;
    if (index.isValid() && rejected().contains({rowName(index.row()), other})) {
        // It may be beside what is typed now, as one step.
        QStringList both{text(index.row(), Minimum, true), text(index.row(), Maximum, true)};
        both[other - 1] = this->index(index.row(), other).data(Qt::EditRole).toString();
        both[index.column() - 1] = value.toString();
        if (write(index.row(), Minimum, {both}).isEmpty()) {
            setTaken(index.row(), Minimum, {both});
            return true;
        }
    }
    return StudyTable::setData(index, value, role);
}

void WatchTable::removeRowRange(int first, int count) {
    std::vector<std::string> gone;
    for (int row = first; row < std::min(first + count, rowCount()); ++row) {
        gone.push_back(rowName(row));
    }
    model_->unwatch(gone);
}

QString WatchTable::write(int row, int column, const std::vector<QStringList>& cells) {
    std::vector<studies::Watched> limits;
    QStringList troubles;
    for (const QStringList& line : cells) {
        studies::Watched limit = watched(row);
        for (int i = 0; i < line.size(); ++i) {
            if (column + i == Name) {
                continue;
            }
            const QString why = model_->readLimit(limit.pointer, line[i],
                                                  column + i == Minimum ? limit.min : limit.max);
            if (!why.isEmpty()) {
                troubles << (cells.size() > 1 ? text(row, Name, false) + QStringLiteral(": ") + why
                                              : why);
            }
        }
        limits.push_back(limit);
        ++row;
    }
    QString all = saidTroubles(troubles);
    return all.isEmpty() ? model_->setLimits(limits) : all;
}

}  // namespace ravnoves
