#include "case-file/result_numbers.h"

#include <algorithm>
#include <cmath>

#include "case-file/object_reader.h"

namespace ravnoves {

ResultNumbers::ResultNumbers(std::span<const std::string> pointers)
    : nodes_(1), pointers_(pointers.begin(), pointers.end()) {
    for (const std::string& text : pointers) {
        std::size_t node = 0;
        for (const std::string& key : keys_of(text)) {
            std::size_t next = inside(node, key);
            if (next == 0) {
                next = nodes_.size();
                nodes_[node].inside.emplace_back(key, next);
                nodes_.push_back({.around = node});
            }
            node = next;
        }
        places_.push_back(node);
    }
}

void ResultNumbers::clear() {
    for (Node& node : nodes_) {
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

void ResultNumbers::set(std::size_t node, const ResultField& field, double value) {
    if (node != 0 && std::isfinite(value)) {
        nodes_[node].value = value;
        nodes_[node].period = period_of(field);
    }
}

void ResultNumbers::leaf(const ResultField& field, const ResultValue& value) {
    const std::size_t node = inside(at_, field.key);
    const auto elements = [&](std::size_t of, const auto& list) {
        for (std::size_t i = 0; of != 0 && i < list.size(); ++i) {
            set(inside(of, std::to_string(i)), field, list[i] / field.unit);
        }
    };
    if (const auto* const* text = std::get_if<const Message*>(&value)) {
        if (field.key == "reason" || field.key == "note") {
            nodes_[at_].why = **text;
        }
    } else if (const auto number = single_number(value)) {
        set(node, field, std::holds_alternative<double>(value) ? *number / field.unit : *number);
    } else if (const auto* numbers = std::get_if<std::span<const double>>(&value)) {
        elements(node, *numbers);
    } else if (const auto* integers = std::get_if<std::span<const int>>(&value)) {
        elements(node, *integers);
    } else if (const auto* rows = std::get_if<NumberRows>(&value); rows != nullptr && node != 0) {
        for (std::size_t row = 0; (row + 1) * rows->columns <= rows->si.size(); ++row) {
            elements(inside(node, std::to_string(row)),
                     rows->si.subspan(row * rows->columns, rows->columns));
        }
    }
}

bool ResultNumbers::enter(std::string_view key) {
    const std::size_t node = inside(at_, key);
    at_ = node != 0 ? node : at_;
    return node != 0;
}

}  // namespace ravnoves
