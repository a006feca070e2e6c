#include "report/input_tables.h"

#include <QLocale>
#include <algorithm>
#include <functional>
#include <map>

#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "model/input_differences.h"
#include "model/scene_model.h"
#include "report/report_words.h"
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

bool isRow(const Json& value) {
    return std::all_of(value.begin(), value.end(),
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
            const bool isNested = value.is_object() || (value.is_array() && isRow(value));
            if (!isNested && !value.is_null()) {
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
            } else if (value.is_array() && !value.empty() && isRow(value)) {
                list(value, at);
            }
        }
        numberLists(json, pointer);
    }

    /// The long lists of numbers of an object. Those of one length are the columns of one table,
    /// whose parts stand side by side.
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
            const bool isCounted = keys.size() == 1;  // a list alone: which value it is
            const std::size_t columns = keys.size() + (isCounted ? 1 : 0);
            const std::size_t parts =
                std::clamp<std::size_t>(maxColumns / columns, 1, (length + minRows - 1) / minRows);
            const std::size_t rows = (length + parts - 1) / parts;
            Table table;
            QStringList names;
            for (const std::string& key : keys) {
                names << nameOf(pointer + "/" + key);
            }
            table.caption = names.join(QStringLiteral("; "));
            for (std::size_t part = 0; part < parts; ++part) {
                if (isCounted) {
                    table.headings << QStringLiteral("№");
                    table.numbers << true;
                }
                for (const std::string& key : keys) {
                    addColumn(pointer + "/" + key, table);
                }
            }
            for (std::size_t row = 0; row < rows; ++row) {
                QStringList cells;
                for (std::size_t part = 0; part < parts; ++part) {
                    const std::size_t at = part * rows + row;
                    if (isCounted) {
                        cells << (at < length ? QString::number(at + 1) : QString());
                    }
                    for (const std::string& key : keys) {
                        cells << (at < length ? numberText(json.at(key)[at].get<double>(),
                                                           unitOf(pointer + "/" + key))
                                              : QString());
                    }
                }
                table.rows << cells;
            }
            lists_.push_back(std::move(table));
        }
    }

    void flatten(const Json& json, std::vector<std::string>& keys,
                 const std::string& prefix) const {
        for (const auto& [key, value] : json.items()) {
            const std::string path = prefix + "/" + escape_segment(key);
            if (value.is_object()) {
                flatten(value, keys, path);
            } else if (std::find(keys.begin(), keys.end(), path) == keys.end()) {
                keys.push_back(path);
            }
        }
    }

    /// What each row of a list of objects has, by the way to it; a list of objects within a row is
    /// one of them.
    std::vector<std::string> pathsOf(const Json& rows) const {
        std::vector<std::string> paths;
        for (const Json& row : rows) {
            flatten(row, paths, {});
        }
        return paths;
    }

    void addColumn(const std::string& pointer, Table& table) const {
        table.headings << titleWithUnit(nameOf(pointer), unitOf(pointer).name).toHtmlEscaped();
        table.numbers << true;
    }

    QStringList cellsOf(const Json& row, const std::vector<std::string>& paths,
                        const std::string& pointer) const {
        QStringList cells;
        for (const std::string& path : paths) {
            const Json::json_pointer at(path);
            cells << (row.contains(at) ? valueText(pointer + path, row.at(at)) : QString())
                         .toHtmlEscaped();
        }
        return cells;
    }

    /// One line a row; where the rows hold a list of objects themselves, one for each object of it,
    /// and what the row has beside in the first of its lines. Each further such list is a table of
    /// its own.
    void list(const Json& rows, const std::string& pointer) {
        std::vector<std::string> paths = pathsOf(rows);
        const auto isList = [&](const std::string& path) {
            const Json::json_pointer at(path);
            return std::any_of(rows.begin(), rows.end(), [&](const Json& row) {
                return row.contains(at) && row.at(at).is_array() && !row.at(at).empty() &&
                       isRow(row.at(at));
            });
        };
        const auto firstList =
            std::stable_partition(paths.begin(), paths.end(), std::not_fn(isList));
        const std::vector<std::string> within(firstList, paths.end());
        paths.erase(firstList, paths.end());
        const QString caption = nameOf(pointer);
        lists_.push_back(
            rowTable(rows, pointer, caption, paths, within.empty() ? std::string() : within[0]));
        for (std::size_t i = 1; i < within.size(); ++i) {
            const QString name = nameOf(pointer + "/0" + within[i]);
            lists_.push_back(
                rowTable(rows, pointer, caption + QStringLiteral(": ") + name, {}, within[i]));
        }
    }

    /// @param paths   what a row has
    /// @param within  the list of objects in a row; empty: none
    Table rowTable(const Json& rows, const std::string& pointer, const QString& caption,
                   const std::vector<std::string>& paths, const std::string& within) {
        const std::string first = pointer + "/0";
        Json parts = Json::array();  // of all rows, for the columns
        if (!within.empty()) {
            for (const Json& row : rows) {
                for (const Json& part : row.value(Json::json_pointer(within), Json::array())) {
                    parts.push_back(part);
                }
            }
        }
        const std::string firstPart = first + within + "/0";
        const std::vector<std::string> partPaths = pathsOf(parts);
        Table table;
        table.caption = caption;
        table.headings << QStringLiteral("№");
        table.numbers << false;
        for (const std::string& path : paths) {
            addColumn(first + path, table);
        }
        if (!within.empty()) {
            addColumn(first + within, table);
        }
        for (const std::string& path : partPaths) {
            addColumn(firstPart + path, table);
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QStringList cells =
                QStringList{QString::number(i + 1)} + cellsOf(rows[i], paths, first);
            if (within.empty()) {
                table.rows << cells;
                continue;
            }
            QStringList before = cells;
            int number = 0;
            for (const Json& part : rows[i].value(Json::json_pointer(within), Json::array())) {
                ++number;
                table.rows << before + QStringList{QString::number(number)} +
                                  cellsOf(part, partPaths, firstPart);
                before = QStringList(cells.size());
            }
        }
        table.isSmall = paths.size() + partPaths.size() > 5;
        return table;
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
