#include "case-file/result_json.h"

#include <cmath>
#include <span>
#include <utility>

namespace ravnoves {

namespace {

Json in_unit(double si, const Unit& unit) {
    if (!std::isfinite(si)) {
        return nullptr;
    }
    const double shown = si / unit;
    return shown == 0.0 ? 0.0 : shown;  // no minus before zero
}

Json in_unit(std::span<const double> si, const Unit& unit) {
    Json::array_t list;
    list.reserve(si.size());
    for (const double value : si) {
        list.push_back(in_unit(value, unit));
    }
    return list;
}

}  // namespace

ResultJson::ResultJson(const Wanted& wanted) : wanted_(wanted) {
    levels_.push_back({{}, object_with_room(32), {}});
}

std::string ResultJson::place(std::string_view key) const {
    return (levels_.back().pointer + '/').append(key);
}

bool ResultJson::wants(std::string_view key) const {
    return wanted_.is_all() || wanted_.wants(place(key));
}

void ResultJson::put(const ResultField& field, Json value) {
    levels_.back().value[std::string(field.key)] = std::move(value);
}

void ResultJson::put_number(const ResultField& field, const std::optional<double>& si) {
    if (wants(field.key)) {
        put(field, si ? in_unit(*si, field.unit) : Json());
    }
}

void ResultJson::integer(const ResultField& field, std::optional<long long> value) {
    if (wants(field.key)) {
        put(field, value ? Json(*value) : Json());
    }
}

void ResultJson::flag(const ResultField& field, std::optional<bool> value) {
    if (wants(field.key)) {
        put(field, value ? Json(*value) : Json());
    }
}

void ResultJson::word(const ResultField& field, std::string_view word) {
    if (wants(field.key)) {
        put(field, word.empty() ? Json() : Json(word));
    }
}

void ResultJson::text(const ResultField& field, const Message& text) {
    if (wants(field.key)) {
        put(field, text.english());
    }
}

void ResultJson::texts(const ResultField& field, const std::vector<Message>& texts) {
    if (wants(field.key)) {
        put(field, english(texts));
    }
}

void ResultJson::numbers(const ResultField& field, const std::vector<double>& si) {
    if (wants(field.key)) {
        put(field, si.empty() ? Json() : in_unit(std::span(si), field.unit));
    }
}

void ResultJson::rows(const ResultField& field, const std::vector<double>& si,
                      std::size_t columns) {
    if (wants(field.key)) {
        Json list = Json::array();
        for (std::size_t at = 0; at + columns <= si.size(); at += columns) {
            list.push_back(in_unit(std::span(si).subspan(at, columns), field.unit));
        }
        put(field, std::move(list));
    }
}

void ResultJson::integers(const ResultField& field, const std::vector<int>& values) {
    if (wants(field.key)) {
        put(field, values);
    }
}

void ResultJson::nothing(const ResultField& field) {
    if (wants(field.key)) {
        put(field, nullptr);
    }
}

void ResultJson::begin(std::string key, Json empty) {
    std::string pointer = place(key);
    levels_.push_back({std::move(key), std::move(empty), std::move(pointer)});
}

void ResultJson::end() {
    Level whole = std::move(levels_.back());
    levels_.pop_back();
    Json& around = levels_.back().value;
    if (around.is_array()) {
        around.push_back(std::move(whole.value));
    } else {
        around[whole.key] = std::move(whole.value);
    }
}

bool ResultJson::begin_object(const ResultField& field) {
    if (!wants(field.key)) {
        return false;
    }
    begin(std::string(field.key), object_with_room(16));
    return true;
}

bool ResultJson::begin_list(const ResultField& field, std::size_t /*count*/) {
    if (!wants(field.key)) {
        return false;
    }
    begin(std::string(field.key), Json::array());
    return true;
}

bool ResultJson::begin_element(std::size_t index) {
    // All of them: an element keeps its place in the list.
    begin(std::to_string(index), object_with_room(16));
    return true;
}

void ResultJson::end_object() {
    end();
}

void ResultJson::end_list() {
    end();
}

Json ResultJson::take() {
    return std::move(levels_.front().value);
}

}  // namespace ravnoves
