#include "model/input_differences.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "case-file/decimal.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "model/reference_case.h"
#include "model/scene_model.h"
#include "text/field_names.h"
#include "text/key_words.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

using Leaves = std::vector<std::pair<std::string, Json>>;

/// @param longest  of lists of numbers: longer ones are left out
void collectLeaves(const Json& value, const std::string& pointer, Leaves& leaves,
                   std::size_t longest = std::numeric_limits<std::size_t>::max()) {
    if (value.is_object()) {
        for (const auto& [key, child] : value.items()) {
            collectLeaves(child, pointer + '/' + escape_segment(key), leaves, longest);
        }
    } else if (value.is_array()) {
        if (value.size() > longest && !value.front().is_structured()) {
            return;
        }
        for (std::size_t i = 0; i < value.size(); ++i) {
            collectLeaves(value[i], pointer + '/' + std::to_string(i), leaves, longest);
        }
    } else {
        leaves.emplace_back(pointer, value);
    }
}

FieldNames namesOf(const SceneModel& model) {
    return FieldNames({model.describedFields(), model.fields()});
}

/// Six, as what was computed or converted needs; more where two numbers would look equal, or one
/// needs them before its point.
int digitsOf(double now, double was) {
    constexpr double maxInSix = 1e6;
    constexpr int all = 17;
    const auto shown = [](double value, int digits) {
        return formNumber(value, QLocale::c(), digits);
    };
    int digits = std::max(std::abs(now), std::abs(was)) < maxInSix ? 6 : 10;
    while (digits < all && shown(now, digits) == shown(was, digits)) {
        ++digits;
    }
    return digits;
}

/// What was typed in another unit is the same to its last digits.
bool isSame(double now, double was) {
    constexpr double rounding = 1e-12;
    return std::abs(now - was) <= rounding * std::max(std::abs(now), std::abs(was));
}

QString shownValue(const Json* value, const FieldEntry* entry, double factor, int digits) {
    if (value == nullptr || value->is_null()) {
        return {};
    }
    if (value->is_number()) {
        const double shown = factor * value->get<double>();
        const bool isAngle = entry != nullptr && entry->field.unit == units::degree;
        return shownFormNumber(isAngle ? rounded_to_decimals(shown, 2) : shown, QLocale(), digits);
    }
    return wordText(*value, entry);
}

}  // namespace

QString wordText(const Json& value, const FieldEntry* entry) {
    if (value.is_boolean()) {
        return value.get<bool>() ? QCoreApplication::translate("ravnoves::SceneModel", "yes")
                                 : QCoreApplication::translate("ravnoves::SceneModel", "no");
    }
    const std::string word = value.is_string() ? value.get<std::string>() : value.dump();
    const QString choice = entry != nullptr ? choiceText(entry->field, word) : QString();
    return !choice.isEmpty()                         ? choice
           : entry != nullptr && entry->word == word ? keyInWords(word)
                                                     : caseText(word);
}

std::vector<InputDifference> inputDifferences(const SceneModel& model, const Json& reference) {
    Leaves present;
    Leaves other;
    collectLeaves(model.inputJson(), {}, present);
    collectLeaves(reference, {}, other);
    std::map<std::string, const Json*> there;
    for (const auto& [pointer, value] : other) {
        there.emplace(pointer, &value);
    }
    const FieldNames names = namesOf(model);
    std::vector<InputDifference> differences;
    const auto add = [&](const std::string& pointer, const Json* now, const Json* was) {
        const bool areNumbers =
            now != nullptr && was != nullptr && now->is_number() && was->is_number();
        if (now != nullptr && was != nullptr &&
            (areNumbers ? isSame(now->get<double>(), was->get<double>()) : *now == *was)) {
            return;
        }
        const FieldEntry* entry = names.described(pointer);
        const ShownUnit unit = entry != nullptr ? shownUnit(entry->field) : ShownUnit{};
        const int digits = areNumbers           ? digitsOf(unit.factor * now->get<double>(),
                                                           unit.factor * was->get<double>())
                           : unit.factor == 1.0 ? 10
                                                : 7;
        // Numbers of cylinders are names.
        const bool isName = areNumbers && now->is_number_integer() && was->is_number_integer() &&
                            entry != nullptr && entry->kind == FieldKind::list &&
                            entry->field.unit == units::none;
        const auto cell = [&](const Json* value) {
            const QString text = shownValue(value, entry, unit.factor, digits);
            const bool isAngle = entry != nullptr && entry->field.unit == units::degree;
            return areNumbers && !isName
                       ? ResultCell(unit.factor * value->get<double>(), text,
                                    isAngle ? ResultCell::Kind::Direction : ResultCell::Kind::Plain)
                       : ResultCell(text);
        };
        differences.push_back({pointer, names.name(pointer), unit.name, cell(now), cell(was)});
    };
    for (const auto& [pointer, value] : present) {
        const auto found = there.find(pointer);
        add(pointer, &value, found != there.end() ? found->second : nullptr);
        there.erase(pointer);
    }
    for (const auto& [pointer, value] : other) {
        if (there.contains(pointer)) {
            add(pointer, nullptr, &value);
        }
    }
    return differences;
}

std::vector<InputNumber> inputNumbers(const SceneModel& model) {
    constexpr std::size_t longest = 12;
    std::vector<std::string> named;
    for (const FieldEntry& field : model.fields()) {
        if (field.kind == FieldKind::number && !field.field.label.empty()) {
            named.push_back(field.pointer);
        }
    }
    Json input = model.inputJson();
    model.giveDefaults(input, named);
    Leaves leaves;
    collectLeaves(input, {}, leaves, longest);
    const FieldNames names = namesOf(model);
    std::vector<InputNumber> numbers;
    for (const auto& [pointer, value] : leaves) {
        const FieldEntry* entry = names.described(pointer);
        if (!value.is_number() ||
            (entry != nullptr && (entry->kind == FieldKind::integer || entry->field.is_setting))) {
            continue;
        }
        // Counts, and numbers that are names: of cylinders in a firing order.
        if (value.is_number_integer() && (entry == nullptr || entry->field.unit == units::none)) {
            continue;
        }
        numbers.push_back({pointer, names.name(pointer),
                           entry != nullptr ? unitText(entry->field.unit.name) : QString(),
                           value.get<double>(), names.find(pointer) != nullptr,
                           entry != nullptr ? names.shown(*entry) : ShownUnit{}});
    }
    return numbers;
}

QString nameByDifferences(SceneModel& model) {
    const QString layout = model.layoutText();
    const SceneModel* reference = model.referenceCase().model();
    if (reference == nullptr || reference->layoutText() != layout) {
        return layout;
    }
    const auto differences = inputDifferences(model, model.variantInput(model.reference()));
    constexpr std::size_t maximum = 3;
    if (differences.empty() || differences.size() > maximum) {
        return {};
    }
    const FieldNames names = namesOf(model);
    QStringList values;
    for (const InputDifference& each : differences) {
        if (each.present.text.isEmpty()) {
            return {};
        }
        const FieldEntry* entry = names.described(each.pointer);
        const std::string_view symbol = entry != nullptr ? entry->field.symbol : "";
        const QString quantity = !symbol.empty()
                                     ? QString::fromUtf8(symbol.data(), std::ssize(symbol))
                                 : each.present.number() != nullptr ? each.name
                                                                    : QString();
        values << (quantity + QChar::Nbsp + withUnit(each.present.text, each.unit)).trimmed();
    }
    return values.join(QStringLiteral(", "));
}

QString designText(const SceneModel& model) {
    constexpr int digits = 7;
    const Json input = model.inputJson();
    const FieldNames names = namesOf(model);
    QStringList values{model.layoutText()};
    values.removeAll(QString());
    for (const char* pointer : model.designInputs()) {
        const Json::json_pointer at(pointer);
        const FieldEntry* entry = names.described(pointer);
        if (entry != nullptr && input.contains(at)) {
            const ShownUnit unit = shownUnit(entry->field);
            values << names.name(pointer) + QLatin1Char(' ') +
                          withUnit(shownValue(&input.at(at), entry, unit.factor, digits),
                                   unit.name);
        }
    }
    return values.join(QStringLiteral(", "));
}

}  // namespace ravnoves
