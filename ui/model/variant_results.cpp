#include "model/variant_results.h"

#include <QCoreApplication>
#include <algorithm>
#include <memory>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/input_differences.h"
#include "model/scene_model.h"
#include "model/variant_files.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

struct VariantTableWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::VariantTable)
};

/// A number of a column, by what names it.
struct Named {
    QString name;
    QString tip;
    ResultCell cell;
};

/// The numbers of the answer's tables.
std::vector<Named> numbersOf(const SceneModel& model) {
    std::vector<Named> numbers;
    for (const PagePart& part : model.parts()) {
        const Content content = part.isAnswer ? model.part(part.id) : Content();
        const auto* results = std::get_if<Results>(&content);
        if (results == nullptr) {
            continue;
        }
        const bool hasUnits = results->columns.size() == 3;  // name, value, unit
        for (const ResultRow& row : results->rows) {
            const auto last = hasUnits ? 2 : std::min(results->columns.size(), row.size());
            for (qsizetype column = 1; column < last; ++column) {
                QString name = row.value(0).text;
                if (hasUnits) {
                    name = titleWithUnit(name, row.value(2).text);
                } else {
                    name += QStringLiteral(" · ") + results->columns[column].heading;
                    const QString unit = results->columns[0].heading;
                    const bool isUnit = unitOfTitle(unit) == unit &&
                                        row[column].number() != nullptr &&
                                        row[column].number()->kind == ResultNumber::Kind::Plain;
                    name = isUnit ? titleWithUnit(name, unit) : name;
                }
                numbers.push_back({name, row.tip, row[column]});
            }
        }
    }
    return numbers;
}

/// The cell with its difference from the reference behind it.
ResultCell against(const ResultCell& cell, const ResultCell* reference) {
    const auto difference =
        reference != nullptr && reference->text != cell.text ? cell.from(*reference) : std::nullopt;
    ResultCell shown = cell;
    if (difference && !difference->absolute.isEmpty()) {
        shown.text += QStringLiteral(" (%1)").arg(difference->absolute);
    }
    return shown;
}

}  // namespace

Results variantResults(const SceneModel& model, QStringList& troubles) {
    struct Column {
        QString title;
        Json input;
        std::vector<Named> numbers;
    };
    std::vector<Column> columns;
    const std::unique_ptr<SceneModel> other = model.another(false);
    columns.push_back({VariantTableWords::tr("Present"), model.inputJson(), numbersOf(model)});
    for (int i = 0; i < model.variants().size(); ++i) {
        const QString name = model.variants().at(i).name;
        Column& column = columns.emplace_back(Column{name, nullptr, {}});
        const QString trouble = model.variantTrouble(i);
        if (!trouble.isEmpty()) {
            troubles << name + QStringLiteral(": ") + trouble;
            continue;
        }
        column.input = model.variantInput(i);
        other->loadCase(column.input, model.context(), name);
        other->takeView(model);
        column.numbers = numbersOf(*other);
        if (const QString changed = changedFilesText(model, i); !changed.isEmpty()) {
            troubles << name + QStringLiteral(": ") + changed;
        }
    }
    const auto reference = static_cast<std::size_t>(model.reference() + 1);
    Results results;
    results.columns << VariantTableWords::tr("Result");
    for (std::size_t i = 0; i < columns.size(); ++i) {
        results.columns << (i == reference && columns.size() > 1
                                ? VariantTableWords::tr("%1 (reference)").arg(columns[i].title)
                                : columns[i].title);
    }
    // The inputs that differ in any of them.
    QList<std::pair<QString, QStringList>> inputs;
    for (std::size_t i = 1; i < columns.size(); ++i) {
        if (columns[i].input.is_null()) {
            continue;
        }
        for (const InputDifference& each : inputDifferences(model, columns[i].input)) {
            const QString name = titleWithUnit(each.name, each.unit);
            auto row = std::find_if(inputs.begin(), inputs.end(),
                                    [&](const auto& known) { return known.first == name; });
            if (row == inputs.end()) {
                inputs.append(
                    {name, QStringList(static_cast<qsizetype>(columns.size()), each.present)});
                row = inputs.end() - 1;
            }
            row->second[static_cast<qsizetype>(i)] = each.reference;
        }
    }
    for (const auto& [name, values] : inputs) {
        ResultRow row{name};
        for (const QString& value : values) {
            row << ResultCell(value);
        }
        row.tip = VariantTableWords::tr("An input that differs.");
        results.rows << row;
    }
    for (std::size_t n = 0; n < columns.front().numbers.size(); ++n) {
        const Named& named = columns.front().numbers[n];
        const auto cellOf = [&](const Column& column) -> const ResultCell* {
            if (n < column.numbers.size() && column.numbers[n].name == named.name) {
                return &column.numbers[n].cell;
            }
            const auto found =
                std::find_if(column.numbers.begin(), column.numbers.end(),
                             [&](const Named& each) { return each.name == named.name; });
            return found != column.numbers.end() ? &found->cell : nullptr;
        };
        ResultRow row{named.name};
        row.tip = named.tip;
        const ResultCell* base = cellOf(columns[reference]);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const ResultCell* cell = cellOf(columns[i]);
            row << (cell == nullptr  ? ResultCell(QStringLiteral("–"))
                    : i == reference ? *cell
                                     : against(*cell, base));
        }
        // What a job computes is there of the present case alone.
        const bool isCompared =
            columns.size() == 1 ||
            std::any_of(row.begin() + 2, row.end(), [](const ResultCell& cell) {
                return cell.text != QStringLiteral("–");
            });
        if (isCompared) {
            results.rows << row;
        }
    }
    return results;
}

}  // namespace ravnoves
