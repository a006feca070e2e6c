#include "case-file/result_json.h"

#include <cmath>
#include <utility>

namespace ravnoves {

namespace {

Json json_of(double si, const Unit& unit) {
    const double shown = si / unit;
    if (!std::isfinite(shown)) {
        return nullptr;
    }
    return shown == 0.0 ? 0.0 : shown;  // no minus before zero
}

Json json_of(std::monostate /*nothing*/, const Unit& /*unit*/) {
    return nullptr;
}
/// Of counts, words, yes and no.
template <typename Value>
Json json_of(Value value, const Unit& /*unit*/) {
    return value;
}
Json json_of(const Message& text, const Unit& /*unit*/) {
    return text.english();
}
Json json_of(const Message* text, const Unit& /*unit*/) {
    return text->english();
}

template <typename Element>
Json json_of(std::span<const Element> elements, const Unit& unit) {
    Json::array_t list;
    list.reserve(elements.size());
    for (const Element& element : elements) {
        list.push_back(json_of(element, unit));
    }
    return list;
}

Json json_of(const NumberRows& rows, const Unit& unit) {
    Json list = Json::array();
    for (std::size_t at = 0; at + rows.columns <= rows.si.size(); at += rows.columns) {
        list.push_back(json_of(rows.si.subspan(at, rows.columns), unit));
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

void ResultJson::leaf(const ResultField& field, const ResultValue& value) {
    if (wants(field.key)) {
        const auto json = [&](const auto& it) { return json_of(it, field.unit); };
        levels_.back().value[std::string(field.key)] = std::visit(json, value);
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

bool ResultJson::begin_list(const ResultField& field) {
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

Json ResultJson::take() {
    return std::move(levels_.front().value);
}

}  // namespace ravnoves
