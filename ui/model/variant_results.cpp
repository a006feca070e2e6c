#include "model/variant_results.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>
#include <memory>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/input_differences.h"
#include "model/scene_model.h"
#include "text/message_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

struct VariantTableWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::VariantTable)
};

/// A row of one design or of all of them, by what names it.
struct Row {
    QString key;  ///< by which another case has it: part, row, column, which of several
    QString name;
    QString tip;
    QVector<ResultCell> cells;
};

/// The numbers of the answer's tables.
std::vector<Row> numbersOf(const SceneModel& model) {
    std::vector<Row> numbers;
    std::map<QString, int> known;
    for (const PagePart& part : model.parts()) {
        const Content content = part.isAnswer ? model.part(part.id) : Content();
        const auto* results = std::get_if<Results>(&content);
        if (results == nullptr) {
            continue;
        }
        const bool hasUnits = results->columns.size() == 3;  // name, value, unit
        const QString partKey =
            QString::fromLatin1(part.id.data(), static_cast<qsizetype>(part.id.size()));
        for (const ResultRow& row : results->rows) {
            const auto last = hasUnits ? 2 : std::min(results->columns.size(), row.size());
            for (qsizetype column = 1; column < last; ++column) {
                QString name = row.value(0).text;
                QString key = partKey + QLatin1Char('/') + row.key();
                if (hasUnits) {
                    name = titleWithUnit(name, row.value(2).text);
                } else {
                    const QString heading =
                        QStringLiteral(" · ") + results->columns[column].heading;
                    name += heading;
                    key += heading;
                    const QString unit = results->columns[0].heading;
                    const bool isUnit = unitOfTitle(unit) == unit &&
                                        row[column].number() != nullptr &&
                                        row[column].number()->kind == ResultNumber::Kind::Plain;
                    name = isUnit ? titleWithUnit(name, unit) : name;
                }
                key += QLatin1Char('/') + QString::number(known[key]++);
                numbers.push_back({key, name, row.tip, {row[column]}});
            }
        }
    }
    return numbers;
}

/// Marks the best of the designs of a row, where one is better than another.
/// @param areSound  of each cell: its design has no warning; another's number is no rival
void markBest(ResultRow& row, const std::vector<bool>& areSound) {
    std::vector<double> values;
    const auto isRival = [&](qsizetype i) {
        return areSound[static_cast<std::size_t>(i)] && row[i].number() != nullptr &&
               row[i].isSmallerBetter;
    };
    for (qsizetype i = 0; i < row.size(); ++i) {
        if (isRival(i)) {
            values.push_back(std::abs(row[i].number()->value));
        }
    }
    const auto [minimum, maximum] = std::minmax_element(values.begin(), values.end());
    constexpr double rounding = 1e-9;
    if (values.size() < 2 || *maximum - *minimum <= rounding * *maximum) {
        return;
    }
    for (qsizetype i = 0; i < row.size(); ++i) {
        row[i].isBest =
            isRival(i) && std::abs(row[i].number()->value) - *minimum <= rounding * *maximum;
    }
}

}  // namespace

VariantResults variantResults(const SceneModel& model) {
    struct Column {
        QString title;
        Json input;
        QString layout;
        std::vector<Row> numbers;
    };
    VariantResults all;
    std::vector<Column> columns;
    std::vector<bool> areSound{false};  // the names are no design
    // All by a model of one kind: what a job computes, none of them has.
    const std::unique_ptr<SceneModel> other = model.another(false);
    const auto take = [&](Column& column, const Json& input, const SceneModel& of) {
        column.input = input;
        column.layout = of.layoutText();
        column.numbers = numbersOf(of);
        const std::optional<Verdict> verdict = of.verdictShown();
        areSound.back() = !verdict || verdict->severity < Severity::warning;
        if (verdict) {
            all.verdicts << column.title + QStringLiteral(": ") + messageText(verdict->text);
        }
    };
    const auto add = [&](const QString& title, const Json& input) {
        Column& column = columns.emplace_back();
        column.title = title;
        areSound.push_back(false);
        try {
            other->loadCase(input, model.context(), title);
            other->takeView(model);
            take(column, input, *other);
        } catch (const InputError& error) {
            all.troubles << title + QStringLiteral(": ") + model.explain(error);
        }
    };
    add(VariantTableWords::tr("Present"), model.inputJson());
    if (columns.front().input.is_null()) {
        take(columns.front(), model.inputJson(), model);  // its file is gone
    }
    for (int i = 0; i < model.variants().size(); ++i) {
        const QString name = model.variants().at(i).name;
        add(name, model.variantInput(i));
        if (const QString changed = model.changedFilesText(i); !changed.isEmpty()) {
            all.troubles << name + QStringLiteral(": ") + changed;
        }
    }
    const int reference = model.reference() + 1;  // the case's own is the first
    const auto count = static_cast<qsizetype>(columns.size());
    const ResultCell missing(QStringLiteral("–"));
    Results& results = all.results;
    results.columns << VariantTableWords::tr("Result");
    Row layouts{{}, VariantTableWords::tr("Layout"), {}, {}};
    bool areLayouts = false;
    for (const Column& column : columns) {
        const bool isReference = &column == &columns[static_cast<std::size_t>(reference)];
        results.columns << (isReference && count > 1
                                ? VariantTableWords::tr("%1 (reference)").arg(column.title)
                                : column.title);
        layouts.cells << (column.input.is_null() ? missing : ResultCell(column.layout));
        areLayouts =
            areLayouts || (!column.input.is_null() && column.layout != columns.front().layout);
    }
    const auto shown = [&](const Row& row) {
        ResultRow made{row.name};
        made.tip = row.tip;
        for (ResultCell cell : row.cells) {
            cell.fromOther = cell.from(row.cells[reference]);
            made << cell;
        }
        return made;
    };
    if (areLayouts) {
        results.rows << shown(layouts);
    }
    // The inputs that differ in any of them; of other layouts those that all of them have.
    std::vector<Row> inputs;
    for (qsizetype i = 1; i < count; ++i) {
        const Json& input = columns[static_cast<std::size_t>(i)].input;
        for (const InputDifference& each :
             input.is_null() ? std::vector<InputDifference>() : inputDifferences(model, input)) {
            const QString name = titleWithUnit(each.name, each.unit);
            auto row = std::ranges::find(inputs, name, &Row::name);
            if (row == inputs.end()) {
                inputs.push_back({{},
                                  name,
                                  VariantTableWords::tr("An input that differs."),
                                  QVector<ResultCell>(count, each.present)});
                row = inputs.end() - 1;
            }
            row->cells[i] = each.reference;
        }
    }
    ResultRows last;  // what follows from the layout comes after what it does
    for (Row& row : inputs) {
        if (areLayouts && std::ranges::any_of(row.cells, [](const ResultCell& cell) {
                return cell.text.isEmpty() || cell.number() == nullptr;
            })) {
            continue;
        }
        for (qsizetype i = 0; i < count; ++i) {
            row.cells[i] =
                columns[static_cast<std::size_t>(i)].input.is_null() ? missing : row.cells[i];
        }
        (areLayouts ? last : results.rows) << shown(row);
    }
    // The rows that any of them has, each behind the one that it follows there.
    std::vector<Row> rows;
    for (qsizetype i = 0; i < count; ++i) {
        auto next = rows.begin();
        for (const Row& number : columns[static_cast<std::size_t>(i)].numbers) {
            auto known = std::ranges::find(rows, number.key, &Row::key);
            if (known == rows.end()) {
                known = rows.insert(next, number);
                known->cells = QVector<ResultCell>(count, missing);
            }
            known->cells[i] = number.cells.front();
            next = known + 1;
        }
    }
    for (const Row& each : rows) {
        ResultRow row = shown(each);
        // Of other layouts many orders are nothing in all of them.
        const bool isNothing = std::ranges::all_of(row, [](const ResultCell& cell) {
            return cell.number() == nullptr || cell.number()->value == 0.0;
        });
        if (areLayouts && isNothing) {
            continue;
        }
        markBest(row, areSound);
        results.rows << row;
    }
    results.rows << last;
    return all;
}

}  // namespace ravnoves
