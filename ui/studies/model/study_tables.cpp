#include "studies/model/study_tables.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <map>
#include <utility>

#include "studies/model/result_words.h"

namespace ravnoves {

ScatterTable::ScatterTable(StudyModel* model, QObject* parent)
    : RefusingTable(parent), model_(model) {
    connect(model_, &StudyModel::changed, this, &ScatterTable::follow);
    follow();
}

std::string ScatterTable::rowName(int row) const {
    return model_->inputs()[static_cast<std::size_t>(row)].pointer;
}

QString ScatterTable::held(int row, int /*column*/) const {
    return StudyModel::scatterText(model_->inputs()[static_cast<std::size_t>(row)]);
}

QStringList ScatterTable::refusedNames() const {
    QStringList names;
    for (const Cell& cell : refusedCells()) {
        names << model_->inputName(cell.first);
    }
    return names;
}

QString ScatterTable::refusedText(const Cell& cell, const Refused& refused) const {
    return model_->inputName(cell.first) + QStringLiteral(": ") + refused.why;
}

int ScatterTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->inputs().size());
}

int ScatterTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

Qt::ItemFlags ScatterTable::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = EditableTable::flags(index);
    flags.setFlag(Qt::ItemIsEditable,
                  index.column() == Scatter &&
                      !model_->inputs()[static_cast<std::size_t>(index.row())].isGone);
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
    if (const QVariant kept = refusedData(index, role); kept.isValid()) {
        return kept;
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant((index.column() == Nominal || index.column() == Scatter ? Qt::AlignRight
                                                                                : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole && input.isGone) {
        return tr(
            "The case no longer has this input, so the study runs without it. Remove it, or "
            "undo.");
    }
    if (role == Qt::ToolTipRole && index.column() == Name) {
        return input.name;
    }
    if (role == Qt::ForegroundRole && input.isGone) {
        return QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
        case Name:
            return input.isGone ? tr("%1 (no longer in the case)").arg(input.name) : input.name;
        case Nominal:
            return StudyModel::nominalText(input);
        default:
            break;
    }
    QString text = StudyModel::scatterText(input);
    const bool isShown = role == Qt::DisplayRole && !text.isEmpty() && !text.endsWith(u'%');
    return isShown ? withUnit(text, input.shown.name) : text;
}

bool ScatterTable::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() != Scatter) {
        return false;
    }
    const QString why = model_->setScatter({{rowName(index.row()), value.toString()}});
    setRefused(index.row(), Scatter, value.toString(), why);
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index, index);
    return why.isEmpty();
}

void ScatterTable::removeRowRange(int first, int count) {
    std::vector<std::pair<std::string, QString>> texts;
    for (int row = first; row < std::min(first + count, rowCount()); ++row) {
        texts.emplace_back(rowName(row), QString());
    }
    if (model_->setScatter(texts).isEmpty()) {
        setTaken(first, Scatter, std::vector<QStringList>(texts.size(), {QString()}));
    }
}

QString ScatterTable::pasteBlock(int row, int /*column*/, const std::vector<QStringList>& cells) {
    if (QString why = noRoomText(cells, rowCount() - row, Columns); !why.isEmpty()) {
        return why;
    }
    std::vector<std::pair<std::string, QString>> texts;
    std::vector<QStringList> taken;
    for (const QStringList& line : cells) {
        texts.emplace_back(rowName(row + static_cast<int>(texts.size())), line.back());
        taken.push_back({line.back()});
    }
    const QString why = model_->setScatter(texts);
    if (!why.isEmpty()) {
        return tr("Nothing is pasted. %1").arg(why);
    }
    setTaken(row, Scatter, taken);
    return {};
}

WatchTable::WatchTable(StudyModel* model, QObject* parent) : RefusingTable(parent), model_(model) {
    connect(model_, &StudyModel::changed, this, &WatchTable::follow);
    follow();
}

std::string WatchTable::rowName(int row) const {
    return model_->study().watch[static_cast<std::size_t>(row)].pointer;
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
    if (const QVariant kept = refusedData(index, role); kept.isValid()) {
        return kept;
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant((index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) |
                        Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole && index.column() == Name) {
        return resultName(watched.pointer).withUnit();
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    if (index.column() == Name) {
        return resultName(watched.pointer).withUnit();
    }
    const auto& limit = index.column() == Least ? watched.min : watched.max;
    return StudyModel::limitText(watched.pointer, limit);
}

bool WatchTable::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() == Name) {
        return false;
    }
    const int other = index.column() == Least ? Most : Least;
    const auto there = refused().find({rowName(index.row()), other});
    if (there != refused().end()) {  // it may stand beside what is typed now, as one step
        QStringList both{value.toString(), there->second.text};
        if (other == Least) {
            std::swap(both[0], both[1]);
        }
        if (write(index.row(), Least, {both}).isEmpty()) {
            setTaken(index.row(), Least, {both});
            return true;
        }
    }
    const QString why = take(index.row(), index.column(), value.toString());
    retry(index.row(), other);
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(this->index(index.row(), Least), this->index(index.row(), Most));
    return why.isEmpty();
}

QString WatchTable::take(int row, int column, const QString& text) {
    QString why = write(row, column, {{text}});
    setRefused(row, column, text, why);
    return why;
}

void WatchTable::retry(int row, int column) {
    const auto there = refused().find({rowName(row), column});
    if (there != refused().end()) {
        take(row, column, QString(there->second.text));
    }
}

void WatchTable::takeBackRefused(const QModelIndex& at) {
    setRefused(at.row(), at.column(), {}, {});
    retry(at.row(), at.column() == Least ? Most : Least);
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index(at.row(), Least), index(at.row(), Most));
}

QString WatchTable::refusedText(const Cell& cell, const Refused& refused) const {
    return resultName(cell.first).text + QStringLiteral(": ") + refused.why;
}

void WatchTable::removeRowRange(int first, int count) {
    std::vector<std::string> gone;
    for (int row = first; row < std::min(first + count, rowCount()); ++row) {
        gone.push_back(rowName(row));
    }
    model_->unwatch(gone);
}

void WatchTable::clearLimits(const QModelIndexList& cells) {
    std::map<int, studies::Watched> limits;
    for (const QModelIndex& at : cells) {
        const auto& watched = model_->study().watch[static_cast<std::size_t>(at.row())];
        auto& limit = limits.try_emplace(at.row(), watched).first->second;
        (at.column() == Least ? limit.min : limit.max).reset();
    }
    std::vector<studies::Watched> all;
    for (const auto& [row, limit] : limits) {
        all.push_back(limit);
    }
    if (model_->setLimits(all).isEmpty()) {
        for (const QModelIndex& at : cells) {
            setTaken(at.row(), at.column(), {{QString()}});
        }
    }
}

QString WatchTable::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    QString why = noRoomText(cells, rowCount() - row, Columns - column);
    if (why.isEmpty()) {
        why = write(row, column, cells);
        if (why.isEmpty()) {
            setTaken(row, column, cells);
        } else {
            why = tr("Nothing is pasted. %1").arg(why);
        }
    }
    return why;
}

QString WatchTable::write(int row, int column, const std::vector<QStringList>& cells) {
    std::vector<studies::Watched> limits;
    SaidTroubles troubles;
    for (const QStringList& line : cells) {
        studies::Watched watched = model_->study().watch[static_cast<std::size_t>(row++)];
        for (int i = 0; i < line.size() && column + i < Columns; ++i) {
            if (column + i == Name) {
                continue;
            }
            const QString why = StudyModel::readLimit(
                watched.pointer, line[i], column + i == Least ? watched.min : watched.max);
            if (!why.isEmpty()) {
                troubles.add(cells.size() > 1
                                 ? resultName(watched.pointer).text + QStringLiteral(": ") + why
                                 : why);
            }
        }
        limits.push_back(watched);
    }
    QString all = troubles.text(RefusingTable::tr("Refused besides: %1"));
    return all.isEmpty() ? model_->setLimits(limits) : all;
}

}  // namespace ravnoves
