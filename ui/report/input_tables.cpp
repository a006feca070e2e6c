#include "report/sections.h"

#include <QLocale>
#include <algorithm>
#include <functional>
#include <map>

#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "model/input_differences.h"
#include "model/scene_model.h"
#include "text/capital.h"
#include "text/field_names.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using namespace paper;

namespace {

/// A hint's first sentence, without its full stop.
QString firstSentence(QString text) {
    for (const QLatin1String end : {QLatin1String(". "), QLatin1String(": ")}) {
        const qsizetype at = text.indexOf(end);
        if (at > 0) {
            text.truncate(at);
        }
    }
    return text.endsWith(QLatin1Char('.')) ? text.chopped(1) : text;
}

/// A number of the case as it is typed; in the unit that the user has chosen with the digits that
/// mean something.
QString numberText(double number, const ShownUnit& unit = {}) {
    constexpr int converted = 6;
    return unit.factor == 1.0 ? shownFormNumber(number, QLocale())
                              : shownFormNumber(unit.factor * number, QLocale(), converted);
}

constexpr std::size_t few = 12;          ///< values that are in one cell
constexpr std::size_t maxPrinted = 400;  ///< rows of a longer list; beyond them its bounds

bool isNumbers(const Json& value) {
    return value.is_array() && std::all_of(value.begin(), value.end(),
                                           [](const Json& each) { return each.is_number(); });
}

/// A list of objects.
bool isRows(const Json& value) {
    return value.is_array() && !value.empty() &&
           std::all_of(value.begin(), value.end(),
                       [](const Json& each) { return each.is_object(); });
}

class Inputs {
  public:
    explicit Inputs(const SceneModel& model)
        : names_({model.describedFields(), model.fields()}), replaced_(model.replacedInputs()) {
        main_.headings = {ReportWords::tr("Input"), ReportWords::tr("Value"),
                          ReportWords::tr("Unit"), ReportWords::tr("Meaning")};
        main_.numbers = {false, true, false, false};
        object(model.inputJson(), {});
        lists_.insert(lists_.begin(), std::move(main_));
    }

    std::vector<Table> take() { return std::move(lists_); }

  private:
    QString nameOf(const std::string& pointer) const {
        return capitalised(names_.ownName(pointer));
    }

    QString meaningOf(const std::string& pointer) const {
        const FieldEntry* entry = names_.entryAt(pointer);
        if (std::find(replaced_.begin(), replaced_.end(), pointer) != replaced_.end()) {
            return ReportWords::tr("Not used: other inputs replace it");
        }
        // What the field would stand for while it is empty explains no value.
        return entry == nullptr ? QString() : firstSentence(shownText(entry->field.hint));
    }

    ShownUnit unitOf(const std::string& pointer) const {
        const FieldEntry* entry = names_.entryAt(pointer);
        return entry == nullptr ? ShownUnit{} : names_.shown(*entry);
    }

    QString valueText(const std::string& pointer, const Json& value) const {
        if (value.is_number()) {
            return numberText(value.get<double>(), unitOf(pointer));
        }
        return value.is_array() ? listText(value, unitOf(pointer))
                                : wordText(value, names_.entryAt(pointer));
    }

    /// Few values as they are, many by their number and bounds.
    static QString listText(const Json& list, const ShownUnit& unit) {
        if (list.size() > few && isNumbers(list)) {
            const auto [minimum, maximum] = std::minmax_element(list.begin(), list.end());
            return ReportWords::tr("%1 values, %2 … %3")
                .arg(list.size())
                .arg(numberText(minimum->get<double>(), unit),
                     numberText(maximum->get<double>(), unit));
        }
        QStringList texts;
        for (const Json& each : list) {
            texts << (each.is_number()   ? numberText(each.get<double>(), unit)
                      : each.is_string() ? QString::fromStdString(each.get<std::string>())
                                         : QString::fromStdString(each.dump()));
        }
        return texts.join(QStringLiteral("; "));
    }

    void object(const Json& json, const std::string& pointer) {
        for (const auto& [key, value] : json.items()) {
            const std::string at = pointer + "/" + escape_segment(key);
            if (!value.is_object() && !isRows(value) && !value.empty()) {
                main_.rows << QStringList{
                    nameOf(at).toHtmlEscaped(), valueText(at, value).toHtmlEscaped(),
                    unitOf(at).name.toHtmlEscaped(), meaningOf(at).toHtmlEscaped()};
            }
        }
        for (const auto& [key, value] : json.items()) {
            const std::string at = pointer + "/" + escape_segment(key);
            if (value.is_object() && !value.empty()) {
                main_.rows << QStringList{nameOf(at).toHtmlEscaped()};
                object(value, at);
            } else if (isRows(value)) {
                std::vector<std::pair<QString, const Json*>> rows;
                for (const Json& row : value) {
                    rows.emplace_back(QString::number(rows.size() + 1), &row);
                }
                list(rows, at + "/0", nameOf(at));
            }
        }
        numberLists(json, pointer);
    }

    /// The long lists of numbers of an object. Those of one length are the columns of one table,
    /// whose parts stand side by side; a list alone has the numbers of its values.
    void numberLists(const Json& json, const std::string& pointer) {
        std::map<std::size_t, std::vector<std::string>> byLength;
        for (const auto& [key, value] : json.items()) {
            if (isNumbers(value) && value.size() > few && value.size() <= maxPrinted) {
                byLength[value.size()].push_back(key);
            }
        }
        for (const auto& [length, keys] : byLength) {
            constexpr std::size_t maxColumns = 8;
            constexpr std::size_t minRows = 8;
            const bool isCounted = keys.size() == 1;
            const std::size_t parts =
                std::clamp<std::size_t>(maxColumns / std::max<std::size_t>(keys.size(), 2), 1,
                                        (length + minRows - 1) / minRows);
            const std::size_t rows = (length + parts - 1) / parts;
            Table table;
            QStringList names;
            for (const std::string& key : keys) {
                names << nameOf(pointer + "/" + key);
            }
            table.caption = names.join(QStringLiteral("; "));
            table.rows.resize(static_cast<qsizetype>(rows));
            for (std::size_t at = 0; at < parts * rows; ++at) {
                QStringList& cells = table.rows[static_cast<qsizetype>(at % rows)];
                const bool isHead = at % rows == 0;
                if (isHead && isCounted) {
                    table.headings << QStringLiteral("№");
                    table.numbers << true;
                }
                if (isCounted) {
                    cells << (at < length ? QString::number(at + 1) : QString());
                }
                for (const std::string& key : keys) {
                    if (isHead) {
                        addColumn(pointer + "/" + key, table);
                    }
                    cells << (at < length ? numberText(json.at(key)[at].get<double>(),
                                                       unitOf(pointer + "/" + key))
                                          : QString());
                }
            }
            lists_.push_back(std::move(table));
        }
    }

    void addColumn(const std::string& pointer, Table& table) const {
        table.headings << titleWithUnit(nameOf(pointer), unitOf(pointer).name).toHtmlEscaped();
        table.numbers << true;
    }

    /// The ways to the values of an object.
    static void collectPaths(const Json& json, const std::string& prefix,
                             std::vector<std::string>& paths) {
        for (const auto& [key, value] : json.items()) {
            const std::string path = prefix + "/" + escape_segment(key);
            if (value.is_object()) {
                collectPaths(value, path, paths);
            } else if (std::find(paths.begin(), paths.end(), path) == paths.end()) {
                paths.push_back(path);
            }
        }
    }

    /// A list of objects, a line for each. A list within them is a table of its own, whose lines
    /// have the number of the object before their own: 2.1.
    /// @param pointer  of any of them, to what describes it
    void list(const std::vector<std::pair<QString, const Json*>>& objects,
              const std::string& pointer, const QString& caption) {
        std::vector<std::string> paths;
        for (const auto& [number, json] : objects) {
            collectPaths(*json, {}, paths);
        }
        const auto isWithin = [&](const std::string& path) {
            const Json::json_pointer at(path);
            return std::any_of(objects.begin(), objects.end(), [&](const auto& object) {
                return object.second->contains(at) && isRows(object.second->at(at));
            });
        };
        const auto firstWithin =
            std::stable_partition(paths.begin(), paths.end(), std::not_fn(isWithin));
        Table table{.caption = caption, .headings = {QStringLiteral("№")}, .numbers = {false}};
        std::for_each(paths.begin(), firstWithin,
                      [&](const std::string& path) { addColumn(pointer + path, table); });
        for (const auto& [number, json] : objects) {
            QStringList cells{number};
            for (auto path = paths.begin(); path != firstWithin; ++path) {
                const Json::json_pointer at(*path);
                cells << (json->contains(at) ? valueText(pointer + *path, json->at(at)) : QString())
                             .toHtmlEscaped();
            }
            table.rows << cells;
        }
        table.isSmall = table.headings.size() > 6;
        if (table.headings.size() > 1) {
            lists_.push_back(std::move(table));
        }
        for (auto within = firstWithin; within != paths.end(); ++within) {
            std::vector<std::pair<QString, const Json*>> parts;
            for (const auto& [number, json] : objects) {
                const Json::json_pointer at(*within);
                for (std::size_t i = 0; json->contains(at) && i < json->at(at).size(); ++i) {
                    parts.emplace_back(number + QStringLiteral(".%1").arg(i + 1), &json->at(at)[i]);
                }
            }
            list(parts, pointer + *within + "/0",
                 caption + QStringLiteral(": ") + nameOf(pointer + *within));
        }
    }

    FieldNames names_;
    std::vector<std::string> replaced_;
    Table main_;
    std::vector<Table> lists_;
};

}  // namespace

std::vector<Table> inputTables(const SceneModel& model) {
    return Inputs(model).take();
}

Table leftOut(const SceneModel& model) {
    const Json input = model.inputJson();
    const std::vector<std::string> replaced = model.replacedInputs();
    const std::vector<std::string> usual = model.usualObjects();
    Table table;
    table.headings = {ReportWords::tr("Not given"), ReportWords::tr("Assumed")};
    table.numbers = {false, false};
    for (const FieldEntry& entry : model.fields()) {
        const Json::json_pointer object = Json::json_pointer(entry.pointer).parent_pointer();
        if (!input.contains(object) &&
            std::find(usual.begin(), usual.end(), object.to_string()) == usual.end()) {
            continue;  // nothing of it counts
        }
        const auto* number = std::get_if<double>(&entry.value);
        const bool isEmpty = std::holds_alternative<std::monostate>(entry.value);
        if (entry.kind != FieldKind::number || entry.field.label.empty() ||
            !entry.alternatives.empty() || input.contains(Json::json_pointer(entry.pointer)) ||
            std::find(replaced.begin(), replaced.end(), entry.pointer) != replaced.end()) {
            continue;
        }
        QString assumed;
        if (number != nullptr) {
            const ShownUnit unit = shownUnit(entry.field);
            assumed = withUnit(numberText(*number, unit), unit.name);
        } else if (isEmpty) {
            assumed = shownText(entry.field.if_empty).toHtmlEscaped();
        }
        const QStringList row{capitalised(fieldName(entry.field)).toHtmlEscaped(), assumed};
        // Each cylinder of a layout assumes the same.
        if (!assumed.isEmpty() && !table.rows.contains(row)) {
            table.rows << row;
        }
    }
    return table;
}

}  // namespace ravnoves
