#include "inertia-moments/model/cylinder_table_model.h"

#include <QFont>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/field_index.h"
#include "case-file/input_error.h"
#include "inertia-moments/fields.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"

namespace ravnoves {

using inertia_moments::Cylinder;
using inertia_moments::Input;
namespace field = inertia_moments::field;

namespace {

using Table = CylinderTableModel;

const Field& fieldOf(int column) {
    static constexpr std::array<const Field*, Table::TopDeadCentre> list{
        &field::axial_position,     &field::bank_angle,     &field::offset,
        &field::crankpin_angle,     &field::knuckle_radius, &field::knuckle_angle,
        &field::articulated_length, &field::master,         &field::knuckle_mass};
    return *list.at(static_cast<std::size_t>(column));
}

bool isOfRod(int column) {
    return column >= Table::KnuckleRadius;
}

/// Of a column's field below a cylinder.
std::string pointerOf(int column) {
    return (isOfRod(column) ? "/articulated/" : "/") + std::string(fieldOf(column).key);
}

/// What a cylinder is given in a column, in the field's unit; empty where it is left out.
std::optional<double> given(const Cylinder& cylinder, int column) {
    if (isOfRod(column) && !cylinder.articulated) {
        return std::nullopt;
    }
    const FieldEntry entry = list_fields(cylinder, pointerOf(column)).front();
    if (entry.value == entry.usual) {
        return std::nullopt;
    }
    const int* whole = std::get_if<int>(&entry.value);
    return whole != nullptr ? *whole : std::get<double>(entry.value);
}

/// Writes a cell's text into a cylinder.
/// @throws InputError for a text that is no value for the column
void setCell(Cylinder& cylinder, int row, int column, const QString& text) {
    const Field& field = fieldOf(column);
    const ShownUnit unit = shownUnit(field.unit);
    const auto reject = [&](const Message& rule, const Message& found) {
        throw InputError("/input/cylinders/" + std::to_string(row) + pointerOf(column), rule,
                         found);
    };
    FieldValue value;
    if (!isOfRod(column) || !text.isEmpty()) {
        const auto [typed, trouble] = readTypedNumber(text, unit.name);
        if (!trouble.isEmpty()) {
            reject(trouble.toStdString(), {});
        }
        if (!typed) {
            reject(Text::tr("must be a number"), quoted_list({text.toStdString()}));
        }
        constexpr int exact = 12;  // what is shown and read again is the same
        const double own =
            unit.factor == 1.0 ? *typed : rounded_to_digits(*typed / unit.factor, exact);
        const bool isWhole = column != Table::Master || own == std::round(own);
        if (!field.range.contains(own) || !isWhole) {
            reject(column == Table::Master ? field.whole_number_rule()
                                           : field.range.message(field.unit),
                   Number{*typed});
        }
        value = column == Table::Master ? FieldValue(static_cast<int>(own)) : FieldValue(own);
    }
    if (column == Table::KnuckleRadius && text.isEmpty()) {
        cylinder.articulated.reset();
    } else if (!isOfRod(column) || column == Table::KnuckleRadius || cylinder.articulated) {
        set_field(cylinder, pointerOf(column), value);
    } else if (!text.isEmpty()) {
        reject(Text::tr("must be empty: this rod runs on the crankpin"), {});
    }
}

/// A length that was converted has no more decimals than its column has room for: where it is
/// edited, it has them all.
QString cellText(const Field& field, double shown) {
    if (const int more = shownUnit(field.unit).decimals; more > 0) {
        const double parts = std::pow(10.0, 2 + more);
        shown = std::round(shown * parts) / parts;
    }
    return shownFormNumber(shown, QLocale(), 6);
}

QString strokeText(double shown) {
    return fixedNumber(shown, 2 + shownUnit(units::mm).decimals, QLocale());
}

/// Masters keep their cylinders when rows come or go.
/// @param from  number of the first cylinder that moves by so many rows
void renumberMasters(std::vector<Cylinder>& cylinders, int from, int by) {
    for (Cylinder& cylinder : cylinders) {
        if (cylinder.articulated && cylinder.articulated->master >= from) {
            cylinder.articulated->master += by;
        }
    }
}

}  // namespace

CylinderTableModel::CylinderTableModel(InertiaMomentsModel* model, QObject* parent)
    : EditableTable(parent), model_(model) {
    connect(model_, &SceneModel::changed, this, [this] {
        strokes_.clear();
        follow();
    });
    connect(model_, &SceneModel::broughtIn, this, &CylinderTableModel::forgetRejected);
    follow();
}

std::string CylinderTableModel::rowName(int row) const {
    return QStringLiteral("%1/%2").arg(row, 3, 10, QLatin1Char('0')).arg(rowCount()).toStdString();
}

QString CylinderTableModel::held(int row, int column) const {
    const auto value = valueAt(row, column);
    return value ? QString::number(*value, 'g', 17) : QString();
}

std::optional<double> CylinderTableModel::valueAt(int row, int column) const {
    const auto i = static_cast<std::size_t>(row);
    const auto& engine = model_->result().engine;
    if (column >= TopDeadCentre) {
        for (std::size_t each = strokes_.size(); each < engine.cylinders.size(); ++each) {
            strokes_.emplace_back(engine.top_dead_centre(each) / degree,
                                  shownValue(engine.stroke(each), units::mm));
        }
        return column == Stroke ? strokes_[i].second : strokes_[i].first;
    }
    const Cylinder& cylinder = engine.cylinders[i];
    std::optional<double> value = given(cylinder, column);
    if (!value && cylinder.articulated) {
        value = 0.0;
    }
    return value ? std::optional(*value * shownUnit(fieldOf(column).unit).factor) : std::nullopt;
}

bool CylinderTableModel::isUsual(int row, int column) const {
    if (column >= TopDeadCentre) {
        return true;
    }
    const auto& table = model_->input().cylinders;  // empty for a layout, which has plain rods
    const auto i = static_cast<std::size_t>(row);
    return i < table.size() && table[i].articulated && !given(table[i], column);
}

void CylinderTableModel::say(const QString& why) {
    QString all = trouble();
    if (!all.contains(why)) {
        all += (all.isEmpty() ? QString() : QStringLiteral("\n")) + why;
    }
    Q_EMIT troubleChanged(all);
}

int CylinderTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->result().engine.cylinders.size());
}

int CylinderTableModel::columnCount(const QModelIndex& parent) const {
    if (parent.isValid()) {
        return 0;
    }
    return model_->hasArticulatedRods() ? Columns : KnuckleRadius;
}

Qt::ItemFlags CylinderTableModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = EditableTable::flags(index);
    if (index.isValid() &&
        (index.column() >= TopDeadCentre ||
         (index.column() > KnuckleRadius && !valueAt(index.row(), index.column())))) {
        flags &= ~Qt::ItemFlags(Qt::ItemIsEditable);
    }
    return flags;
}

QVariant CylinderTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount() || index.column() >= columnCount()) {
        return {};
    }
    if (const QVariant kept = rejectedData(index, role); kept.isValid()) {
        return kept;
    }
    const bool usual = isUsual(index.row(), index.column());
    const std::optional<double> value = valueAt(index.row(), index.column());
    switch (role) {
        case Qt::DisplayRole:
            return !value                            ? QString()
                   : index.column() == TopDeadCentre ? fixedNumber(*value, 3, QLocale())
                   : index.column() == Stroke        ? strokeText(*value)
                                                     : cellText(fieldOf(index.column()), *value);
        case Qt::EditRole:
            return value && (!usual || index.column() >= TopDeadCentre)
                       ? formNumber(*value, QLocale(), 15)
                       : QString();
        case Qt::FontRole: {
            if (!usual) {
                return {};
            }
            QFont font;
            font.setItalic(true);
            return font;
        }
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

bool CylinderTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() >= TopDeadCentre) {
        return false;
    }
    const auto row = static_cast<std::size_t>(index.row());
    const QString text = value.toString().trimmed();
    const std::pair cell(index.row(), index.column());
    setRejected(cell.first, cell.second, {}, {});
    // A cell of the table changes columns too: it must not look at the index afterwards.
    const QString why = model_->edit(tr("Cylinder %1").arg(index.row() + 1), [&](Input& input) {
        setCell(model_->tableOf(input).at(row), cell.first, cell.second, text);
    });
    if (why.isEmpty()) {
        model_->showTrouble({});
    } else {
        setRejected(cell.first, cell.second, text, why);
    }
    if (cell.second < columnCount()) {
        const QModelIndex at = this->index(cell.first, cell.second);
        Q_EMIT dataChanged(at, at);
    }
    say(why);
    return why.isEmpty();
}

SceneModel* CylinderTableModel::scene() const {
    return model_;
}

void CylinderTableModel::takeBackRejected(const QModelIndex& at) {
    model_->showTrouble({});
    EditableTable::takeBackRejected(at);
}

QVariant CylinderTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        if (role == Qt::ToolTipRole && section < rowCount()) {
            return tr("Top dead centre %1° from its axis, stroke %2")
                .arg(fixedNumber(*valueAt(section, TopDeadCentre), 3, QLocale()),
                     withUnit(strokeText(*valueAt(section, Stroke)), shownUnit(units::mm).name));
        }
        return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    }
    if (section >= TopDeadCentre) {
        const bool isStroke = section == Stroke;
        if (role == Qt::DisplayRole) {
            return isStroke ? shownTitle(tr("stroke, mm")).text : tr("TDC, °");
        }
        return role != Qt::ToolTipRole ? QVariant()
               : isStroke              ? tr("Stroke of the piston; follows from the other values")
                          : tr("Top dead centre: the crank's angle from the cylinder's axis; "
                               "follows from the other values");
    }
    const Field& field = fieldOf(section);
    if (role == Qt::DisplayRole) {
        const QString symbol =
            QString::fromUtf8(field.symbol.data(), static_cast<qsizetype>(field.symbol.size()));
        return section == Master ? tr("master") : titleWithUnit(symbol, shownUnit(field.unit).name);
    }
    return role == Qt::ToolTipRole ? QVariant(fieldHint(field)) : QVariant();
}

int CylinderTableModel::insertRowBelow(int row) {
    const int at = row < 0 ? rowCount() - 1 : row;
    const QString why = model_->edit(tr("Add cylinder"), [&](Input& input) {
        auto& cylinders = model_->tableOf(input);
        Cylinder copy = cylinders.at(static_cast<std::size_t>(at));
        copy.articulated.reset();  // it would hang on a pin that its direction cannot share
        renumberMasters(cylinders, at + 2, 1);
        copy.axial_position -= 2.0 * input.crank_radius;
        cylinders.insert(cylinders.begin() + at + 1, copy);
        input.firing_order.clear();  // it no longer names every cylinder
    });
    say(why);
    return why.isEmpty() ? at + 1 : -1;
}

void CylinderTableModel::removeRowRange(int first, int count) {
    if (first < 0 || count <= 0) {
        return;
    }
    if (count >= rowCount()) {
        say(tr("An engine has at least one cylinder."));
        return;
    }
    const QString why = model_->edit(tr("Remove cylinder"), [&](Input& input) {
        auto& cylinders = model_->tableOf(input);
        const auto from = cylinders.begin() + first;
        cylinders.erase(from, from + std::min(count, static_cast<int>(cylinders.size()) - first));
        for (Cylinder& cylinder : cylinders) {
            if (cylinder.articulated && cylinder.articulated->master > first &&
                cylinder.articulated->master <= first + count) {
                cylinder.articulated->master = 0;  // gone; another may be the only one left
            }
        }
        renumberMasters(cylinders, first + count + 1, -count);
        input.firing_order.clear();
    });
    say(why);
}

QString CylinderTableModel::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    const std::size_t first = static_cast<std::size_t>(row);
    if (first + cells.size() > static_cast<std::size_t>(inertia_moments::max_cylinders)) {
        return tr("At most %1 cylinders.").arg(inertia_moments::max_cylinders);
    }
    const int wide = std::min<int>(columnCount(), TopDeadCentre);
    QString why = model_->edit(tr("Paste cylinders"), [&](Input& input) {
        std::vector<Cylinder>& cylinders = model_->tableOf(input);
        cylinders.resize(std::max(cylinders.size(), first + cells.size()));
        for (std::size_t line = 0; line < cells.size(); ++line) {
            for (int cell = 0; cell < cells[line].size() && column + cell < wide; ++cell) {
                setCell(cylinders[first + line], static_cast<int>(first + line), column + cell,
                        cells[line][cell]);
            }
        }
        if (input.firing_order.size() != cylinders.size()) {
            input.firing_order.clear();
        }
    });
    if (why.isEmpty()) {
        setTaken(row, column, cells);
    }
    say(why);
    return why;
}

}  // namespace ravnoves
