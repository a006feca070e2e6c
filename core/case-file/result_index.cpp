#include "case-file/result_index.h"

#include <utility>

namespace ravnoves {

ResultIndex::Level ResultIndex::inside(std::string_view key, const Message& label,
                                       const Unit& unit) const {
    const Level& around = levels_.back();
    Message name = around.name.empty() ? label
                   : label.empty()     ? around.name
                                       : joined(around.name, label);
    return {(around.pointer + '/').append(key), std::move(name),
            unit == units::none ? around.unit : unit};
}

void ResultIndex::put_number(const ResultField& field, const std::optional<double>& si) {
    Level place = inside(field.key, field.label, field.unit);
    entries_.push_back(
        {std::move(place.pointer), std::move(place.name), place.unit, field.decimals, si});
}

void ResultIndex::integer(const ResultField& field, std::optional<long long> value) {
    put_number(field, value ? std::optional(static_cast<double>(*value)) : std::nullopt);
}

void ResultIndex::flag(const ResultField& field, std::optional<bool> value) {
    put_number(field, value ? std::optional(*value ? 1.0 : 0.0) : std::nullopt);
}

bool ResultIndex::begin_object(const ResultField& field) {
    levels_.push_back(inside(field.key, field.label, field.unit));
    return true;
}

bool ResultIndex::begin_list(const ResultField& field, std::size_t /*count*/) {
    return begin_object(field);
}

bool ResultIndex::begin_element(std::size_t index) {
    levels_.push_back(inside(std::to_string(index), Number{.value = static_cast<double>(index + 1)},
                             units::none));
    return true;
}

void ResultIndex::end_object() {
    levels_.pop_back();
}

void ResultIndex::end_list() {
    levels_.pop_back();
}

}  // namespace ravnoves
