#include "case-file/field_reader.h"

#include <cmath>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/whole_number.h"

namespace ravnoves {

FieldReader::FieldReader(const Json& json, Completeness completeness, std::string pointer)
    : completeness_(completeness) {
    readers_.emplace_back(json, std::move(pointer));
}

void FieldReader::visit_number(const Field& field, double& si, const double* fallback,
                               bool /*always*/) {
    if (reader().has(field.key) || (fallback == nullptr && !is_lenient())) {
        si = reader().si(field);
    } else if (fallback != nullptr) {
        si = *fallback;
    }
}

void FieldReader::visit_optional(const Field& field, std::optional<double>& si, bool required) {
    if (reader().has(field.key) || (required && !is_lenient())) {
        si = reader().si(field);
    }
}

void FieldReader::number_or_word(const Field& field, std::optional<double>& si,
                                 std::string_view word) {
    if (!reader().has(field.key)) {
        return;  // empty, as by the word
    }
    const Json& value = reader().raw(field.key);
    if (!value.is_string()) {
        si = reader().si(field);
        return;
    }
    const std::string quoted = '"' + std::string(word) + '"';
    if (show(value) != quoted) {
        throw InputError(reader().pointer_to(field.key),
                         {CORE_TEXT("core", "must be a number or %1"), quoted}, show(value));
    }
    si.reset();
}

void FieldReader::visit_integer(const Field& field, int& value, const int* fallback,
                                bool /*always*/) {
    if (reader().has(field.key) || (fallback == nullptr && !is_lenient())) {
        const Json& json = reader().raw(field.key);
        const double number = json.is_number() ? json.get<double>() : std::nan("");
        if (!allows_whole(field, number)) {
            throw InputError(reader().pointer_to(field.key), whole_number_rule(field), show(json));
        }
        value = static_cast<int>(number);
    } else if (fallback != nullptr) {
        value = *fallback;
    }
}

void FieldReader::visit_flag(const Field& field, bool& value, const bool* fallback,
                             bool /*always*/) {
    value = reader().boolean(field.key, *fallback);
}

void FieldReader::visit_text(const Field& field, std::string& value, bool required) {
    value = required && !is_lenient() ? reader().text(field.key) : reader().text(field.key, value);
}

void FieldReader::visit_choice(const Field& field, int& index, const int* fallback,
                               bool /*always*/) {
    if (!reader().has(field.key) && (fallback != nullptr || is_lenient())) {
        index = fallback != nullptr ? *fallback : index;
        return;
    }
    index = reader().choice(field.key, field.words);
}

bool FieldReader::begin_object(const Field& field, bool required, bool /*is_there*/) {
    if (!reader().has(field.key) && !(required && !is_lenient())) {
        return false;
    }
    readers_.push_back(reader().object(field.key));
    return true;
}

void FieldReader::end_object() {
    readers_.back().finish();
    readers_.pop_back();
}

bool FieldReader::begin_list(const Field& field, std::size_t& count) {
    const Json& list = reader().list(field.key);
    count = list.size();
    lists_.push_back({&list, reader().pointer_to(field.key)});
    return true;
}

void FieldReader::end_list() {
    lists_.pop_back();
}

void FieldReader::begin_element(std::size_t index) {
    const List& list = lists_.back();
    readers_.emplace_back(list.json->at(index), list.pointer + "/" + std::to_string(index));
}

void FieldReader::end_element() {
    end_object();
}

void FieldReader::numbers(const Field& field, std::vector<double>& values) {
    values = reader().numbers(field.key, field.range);
}

void FieldReader::integers(const Field& field, std::vector<int>& values) {
    values = reader().integers(field.key, static_cast<int>(field.range.min),
                               static_cast<int>(field.range.max));
}

int FieldReader::one_of(std::initializer_list<std::string_view> keys, int present) {
    int found = -1;
    int index = 0;
    std::string_view first;
    for (const std::string_view key : keys) {
        if (reader().has(key)) {
            if (found >= 0) {
                throw InputError(reader().pointer_to(key),
                                 {CORE_TEXT("core", "must be left out where %1 is given"), first});
            }
            found = index;
            first = key;
        }
        ++index;
    }
    if (found < 0 && !is_lenient()) {
        for (const std::string_view key : keys) {
            reader().refuse_mistyped(key);
        }
        throw InputError(reader().pointer_to(*keys.begin()),
                         {CORE_TEXT("core", "is required and missing (or %1)"),
                          *(keys.begin() + keys.size() - 1)});
    }
    return found < 0 ? present : found;
}

bool FieldReader::has(std::string_view key, bool /*present*/) {
    return reader().has(key);
}

void FieldReader::custom(const Field& field, bool required, Custom& value) {
    if (reader().has(field.key) || (required && !is_lenient())) {
        value.read(reader().raw(field.key), reader().pointer_to(field.key));
    }
}

}  // namespace ravnoves
