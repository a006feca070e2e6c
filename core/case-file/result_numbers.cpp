#include "case-file/result_numbers.h"

#include <algorithm>
#include <cmath>

#include "case-file/json.h"

namespace ravnoves {

ResultNumbers::ResultNumbers(std::span<const std::string> pointers)
    : nodes_(1), pointers_(pointers.begin(), pointers.end()) {
    for (const std::string& text : pointers) {
        std::vector<std::string> keys;
        for (Json::json_pointer rest(text); !rest.empty(); rest.pop_back()) {
            keys.push_back(rest.back());
        }
        std::size_t node = 0;
        for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
            std::size_t next = inside(node, *key);
            if (next == 0) {
                next = nodes_.size();
                nodes_[node].inside.emplace_back(*key, next);
                nodes_.push_back({.around = node});
            }
            node = next;
        }
        places_.push_back(node);
    }
}

void ResultNumbers::clear() {
    for (Node& node : nodes_) {
        node.found = Found::nothing;
        node.value.reset();
        if (!node.why.empty()) {
            node.why = {};
        }
    }
    at_ = 0;
}

Message ResultNumbers::why(std::size_t i) const {
    for (std::size_t node = places_[i]; node != 0;) {
        node = nodes_[node].around;
        if (!nodes_[node].why.empty()) {
            return nodes_[node].why;
        }
    }
    return {};
}

std::size_t ResultNumbers::inside(std::size_t around, std::string_view key) const {
    for (const auto& [name, node] : nodes_[around].inside) {
        if (name == key) {
            return node;
        }
    }
    return 0;
}

bool ResultNumbers::wants(std::string_view key) const {
    std::size_t node = at_;
    while (true) {
        const std::size_t end = std::min(key.find('/'), key.size());
        node = inside(node, key.substr(0, end));
        if (node == 0 || end == key.size()) {
            return node != 0;
        }
        if (nodes_[node].inside.empty()) {
            return true;  // all in it
        }
        key.remove_prefix(end + 1);
    }
}

void ResultNumbers::set(std::size_t node, const std::optional<double>& value) {
    if (node != 0) {
        const bool is_number = value && std::isfinite(*value);
        nodes_[node].found = is_number ? Found::number : Found::null;
        nodes_[node].value = is_number ? value : std::nullopt;
    }
}

void ResultNumbers::put_number(const ResultField& field, const std::optional<double>& si) {
    set(inside(at_, field.key), si ? std::optional(*si / field.unit) : std::nullopt);
}

void ResultNumbers::integer(const ResultField& field, std::optional<long long> value) {
    set(inside(at_, field.key), value ? std::optional(static_cast<double>(*value)) : std::nullopt);
}

void ResultNumbers::flag(const ResultField& field, std::optional<bool> value) {
    set(inside(at_, field.key), value ? std::optional(*value ? 1.0 : 0.0) : std::nullopt);
}

void ResultNumbers::word(const ResultField& field, std::string_view /*word*/) {
    if (const std::size_t node = inside(at_, field.key)) {
        nodes_[node].found = Found::no_number;
    }
}

void ResultNumbers::text(const ResultField& field, const Message& text) {
    if (field.key == "reason" || field.key == "note") {
        nodes_[at_].why = text;
    }
    word(field, {});
}

void ResultNumbers::texts(const ResultField& field, const std::vector<Message>& /*texts*/) {
    word(field, {});
}

void ResultNumbers::numbers(const ResultField& field, const std::vector<double>& si) {
    const std::size_t node = inside(at_, field.key);
    if (node == 0) {
        return;
    }
    nodes_[node].found = Found::no_number;
    for (const auto& [place, element] : nodes_[node].inside) {
        for (std::size_t i = 0; i < si.size(); ++i) {
            if (place == std::to_string(i)) {
                set(element, si[i] / field.unit);
            }
        }
    }
}

void ResultNumbers::integers(const ResultField& field, const std::vector<int>& values) {
    numbers({field.key}, std::vector<double>(values.begin(), values.end()));
}

void ResultNumbers::rows(const ResultField& field, const std::vector<double>& si,
                         std::size_t columns) {
    if (enter(field.key)) {
        for (std::size_t row = 0; (row + 1) * columns <= si.size(); ++row) {
            const auto from = si.begin() + static_cast<std::ptrdiff_t>(row * columns);
            numbers({std::to_string(row), field.unit},
                    {from, from + static_cast<std::ptrdiff_t>(columns)});
        }
        end_object();
    }
}

void ResultNumbers::nothing(const ResultField& field) {
    set(inside(at_, field.key), std::nullopt);
}

bool ResultNumbers::enter(std::string_view key) {
    const std::size_t node = inside(at_, key);
    if (node == 0) {
        return false;
    }
    nodes_[node].found = Found::no_number;
    at_ = node;
    return true;
}

bool ResultNumbers::begin_object(const ResultField& field) {
    return enter(field.key);
}

bool ResultNumbers::begin_list(const ResultField& field, std::size_t /*count*/) {
    return enter(field.key);
}

bool ResultNumbers::begin_element(std::size_t index) {
    return enter(std::to_string(index));
}

void ResultNumbers::end_object() {
    at_ = nodes_[at_].around;
}

void ResultNumbers::end_list() {
    end_object();
}

}  // namespace ravnoves
