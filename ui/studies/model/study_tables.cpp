#include "studies/model/study_tables.h"

#include "studies/model/result_words.h"
#include "text/number_text.h"

namespace ravnoves {

ScatterTable::ScatterTable(StudyModel* model, QObject* parent)
    : EditableTable(parent), model_(model), rows_(rowCount()) {
    connect(model_, &StudyModel::changed, this, [this] {
        if (rowCount() != rows_) {
            beginResetModel();
            rows_ = rowCount();
            refused_.clear();
            endResetModel();
        } else if (rows_ > 0) {
            Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, Columns - 1));
        }
    });
}

int ScatterTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->inputs().size());
}

int ScatterTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

Qt::ItemFlags ScatterTable::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = EditableTable::flags(index);
    flags.setFlag(Qt::ItemIsEditable, index.column() == Scatter);
    return flags;
}

QVariant ScatterTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
        return {};
    }
    if (role == Qt::ToolTipRole) {
        return section == Scatter
                   ? tr("0.02: anywhere within ± 0.02, as likely here as there. 1 %: within ± 1 % "
                        "of the value. σ 0.01: normal, with this standard deviation.")
                   : QVariant();
    }
    switch (section) {
        case Name:
            return tr("Input");
        case Nominal:
            return tr("Value");
        default:
            return QStringLiteral("±");
    }
}

QVariant ScatterTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const StudyModel::Input& input = model_->inputs()[static_cast<std::size_t>(index.row())];
    const auto refused = refused_.find(input.pointer);
    if (role == TroubleRole) {
        return index.column() == Scatter && refused != refused_.end();
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant((index.column() == Nominal || index.column() == Scatter ? Qt::AlignRight
                                                                                : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole && index.column() == Name) {
        return input.name;
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
        case Name:
            return input.name;
        case Nominal:
            return withUnit(formNumber(input.nominal, QLocale(), 8), input.unit);
        default:
            return refused != refused_.end() ? refused->second
                                             : StudyModel::scatterText(input.varied);
    }
}

bool ScatterTable::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() != Scatter) {
        return false;
    }
    const std::string pointer = model_->inputs()[static_cast<std::size_t>(index.row())].pointer;
    const QString why = model_->setScatter({{pointer, value.toString()}});
    if (why.isEmpty()) {
        refused_.erase(pointer);
    } else {
        refused_[pointer] = value.toString();
    }
    Q_EMIT troubleChanged(why);
    Q_EMIT dataChanged(index, index);
    return why.isEmpty();
}

void ScatterTable::removeRowRange(int first, int count) {
    for (int row = first; row < first + count; ++row) {
        setData(index(row, Scatter), QString(), Qt::EditRole);
    }
}

QString ScatterTable::pasteBlock(int row, int /*column*/, const std::vector<QStringList>& cells) {
    std::vector<std::pair<std::string, QString>> texts;
    for (const QStringList& line : cells) {
        if (row >= rowCount() || line.isEmpty()) {
            break;
        }
        texts.emplace_back(model_->inputs()[static_cast<std::size_t>(row)].pointer, line.back());
        ++row;
    }
    return model_->setScatter(texts);
}

WatchTable::WatchTable(StudyModel* model, QObject* parent)
    : EditableTable(parent), model_(model), rows_(rowCount()) {
    connect(model_, &StudyModel::changed, this, [this] {
        if (rowCount() != rows_) {
            beginResetModel();
            rows_ = rowCount();
            endResetModel();
        } else if (rows_ > 0) {
            Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, Columns - 1));
        }
    });
}

int WatchTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->study().watch.size());
}

int WatchTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

Qt::ItemFlags WatchTable::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = EditableTable::flags(index);
    flags.setFlag(Qt::ItemIsEditable, index.column() != Name);
    return flags;
}

QVariant WatchTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical || role != Qt::DisplayRole) {
        return {};
    }
    return section == Name ? tr("Result") : section == Least ? tr("At least") : tr("At most");
}

QVariant WatchTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const studies::Watched& watched = model_->study().watch[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole) {
        return QVariant((index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) |
                        Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole && index.column() == Name) {
        return QString::fromStdString(watched.pointer);
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    if (index.column() == Name) {
        return resultName(watched.pointer).withUnit();
    }
    const auto& limit = index.column() == Least ? watched.min : watched.max;
    return limit ? formNumber(*limit, QLocale()) : QString();
}

bool WatchTable::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() == Name) {
        return false;
    }
    const QString why = pasteBlock(index.row(), index.column(), {{value.toString()}});
    Q_EMIT troubleChanged(why);
    return why.isEmpty();
}

void WatchTable::removeRowRange(int first, int count) {
    std::vector<std::string> gone;
    for (int row = first; row < std::min(first + count, rowCount()); ++row) {
        gone.push_back(model_->study().watch[static_cast<std::size_t>(row)].pointer);
    }
    for (const std::string& pointer : gone) {
        model_->unwatch(pointer);
    }
}

QString WatchTable::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    std::vector<studies::Watched> limits;
    for (const QStringList& line : cells) {
        if (row >= rowCount()) {
            break;
        }
        studies::Watched watched = model_->study().watch[static_cast<std::size_t>(row++)];
        for (int i = 0; i < line.size() && column + i < Columns; ++i) {
            const QString text = line[i].trimmed();
            const auto number = readFormNumber(text);
            if (column + i == Name) {
                continue;
            }
            if (!text.isEmpty() && !number) {
                return tr("A limit is a number, or nothing; %1 is none.").arg(text);
            }
            (column + i == Least ? watched.min : watched.max) = number;
        }
        limits.push_back(watched);
    }
    return model_->setLimits(limits);
}

}  // namespace ravnoves
