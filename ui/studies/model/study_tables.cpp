#include "studies/model/study_tables.h"

#include <algorithm>
#include <utility>

#include "text/number_text.h"

namespace ravnoves {

StudyTable::StudyTable(StudyModel* model, ResultColumns columns, int typed, QString step,
                       QObject* parent)
    : EditableTable(parent),
      model_(model),
      columns_(std::move(columns)),
      typed_(typed),
      step_(std::move(step)) {
    connect(model_, &StudyModel::changed, this, &StudyTable::follow);
}

int StudyTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

Qt::ItemFlags StudyTable::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = EditableTable::flags(index);
    flags.setFlag(Qt::ItemIsEditable, isTyped(index));
    return flags;
}

QVariant StudyTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section >= columnCount()) {
        return {};
    }
    return role == Qt::DisplayRole   ? columns_[section].heading
           : role == Qt::ToolTipRole ? QVariant(columns_[section].tip)
                                     : QVariant();
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
    if (role != Qt::EditRole || !index.isValid() || !isTyped(index)) {
        return false;
    }
    // What was rejected beside it may stand with what is typed now, as one step.
    QStringList whole;
    for (int column = typed_; column < columnCount(); ++column) {
        whole << (column == index.column() ? value
                                           : index.siblingAtColumn(column).data(Qt::EditRole))
                     .toString();
    }
    if (write(index.row(), typed_, {whole}).isEmpty()) {
        setTaken(index.row(), typed_, {whole});
        return true;
    }
    const QString why = write(index.row(), index.column(), {{value.toString()}});
    setRejected(index.row(), index.column(), value.toString(), why);
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index, index);
    return why.isEmpty();
}

bool StudyTable::isTyped(const QModelIndex& index) const {
    return index.column() >= typed_ && !isGone(index.row());
}

QString StudyTable::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    // Whole rows go where they came from; a narrow block is of the last columns, which are typed.
    std::size_t width = 0;
    for (const QStringList& line : cells) {
        width = std::max(width, static_cast<std::size_t>(line.size()));
    }
    const int spare = columnCount() - static_cast<int>(width);
    column = spare <= 0 ? 0 : std::max(column, std::min(typed_, spare));
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

QString StudyTable::write(int row, int column, const std::vector<QStringList>& cells) {
    studies::Study next = model_->study();
    QStringList troubles;
    for (const QStringList& line : cells) {
        const int end = std::min(static_cast<int>(line.size()), columnCount() - column);
        for (int i = std::max(typed_ - column, 0); i < end; ++i) {
            const QString why = read(next, row, column + i, line[i]);
            if (!why.isEmpty()) {
                troubles << (cells.size() > 1 ? text(row, Name, false) + QStringLiteral(": ") + why
                                              : why);
            }
        }
        ++row;
    }
    return troubles.isEmpty() ? model_->change(step_, next) : saidTroubles(troubles);
}

QStringList StudyTable::rejectedNames() const {
    QStringList names;
    for (const auto& [cell, rejected] : rejected()) {
        names << model_->inputName(cell.first);
    }
    return names;
}

QString StudyTable::rejectedText(const Cell& cell, const Rejected& rejected) const {
    return model_->inputName(cell.first) + QStringLiteral(": ") + rejected.why;
}

ScatterTable::ScatterTable(StudyModel* model, QObject* parent)
    : StudyTable(model,
                 {{tr("Input")},
                  {tr("Value")},
                  {QStringLiteral("±"),
                   tr("0.02: uniform within ± 0.02. 1 %: uniform within ± 1 % of the value. σ "
                      "0.01: normal with this standard deviation.")}},
                 Scatter, StudyModel::tr("Tolerance"), parent) {
    follow();
}

const StudyModel::Input& ScatterTable::input(int row) const {
    return model_->inputs()[static_cast<std::size_t>(row)];
}

bool ScatterTable::isGone(int row) const {
    return input(row).isMissing;
}

int ScatterTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->inputs().size());
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

QString ScatterTable::read(studies::Study& next, int row, int /*column*/,
                           const QString& typed) const {
    return model_->readScatter(next, rowName(row), typed);
}

void ScatterTable::removeRowRange(int first, int count) {
    const int rows = std::min(count, rowCount() - first);
    pasteBlock(first, Scatter,
               std::vector<QStringList>(static_cast<std::size_t>(rows), {QString()}));
}

WatchTable::WatchTable(StudyModel* model, QObject* parent)
    : StudyTable(model, {{tr("Result")}, {tr("Minimum")}, {tr("Maximum")}}, Minimum,
                 StudyModel::tr("Limits"), parent) {
    follow();
}

const studies::Watched& WatchTable::watched(int row) const {
    return model_->study().watch[static_cast<std::size_t>(row)];
}

int WatchTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->study().watch.size());
}

QString WatchTable::text(int row, int column, bool /*isEdited*/) const {
    const studies::Watched& shown = watched(row);
    return column == Name
               ? model_->resultName(shown.pointer).withUnit()
               : model_->limitText(shown.pointer, column == Minimum ? shown.min : shown.max);
}

QString WatchTable::read(studies::Study& next, int row, int column, const QString& typed) const {
    studies::Watched& limits = next.watch[static_cast<std::size_t>(row)];
    return model_->readLimit(limits.pointer, typed, column == Minimum ? limits.min : limits.max);
}

void WatchTable::removeRowRange(int first, int count) {
    studies::Study next = model_->study();
    const auto begin = next.watch.begin() + first;
    next.watch.erase(begin, begin + std::min(count, rowCount() - first));
    model_->change(StudyModel::tr("Watch a result"), next);
}

}  // namespace ravnoves
