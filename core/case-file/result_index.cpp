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

void ResultIndex::leaf(const ResultField& field, const ResultValue& value) {
    std::optional<double> si;
    if (const auto* number = std::get_if<double>(&value)) {
        si = *number;
    } else if (const auto* count = std::get_if<long long>(&value)) {
        si = static_cast<double>(*count);
    } else if (const auto* flag = std::get_if<bool>(&value)) {
        si = *flag ? 1.0 : 0.0;
    } else if (!std::holds_alternative<std::monostate>(value)) {
        return;
    }
    Level place = inside(field.key, field.label, field.unit);
    entries_.push_back({std::move(place.pointer), std::move(place.name), place.unit, field.decimals,
                        period_of(field), si});
}

bool ResultIndex::begin_object(const ResultField& field) {
    levels_.push_back(inside(field.key, field.label, field.unit));
    return true;
}

bool ResultIndex::begin_element(std::size_t index) {
    levels_.push_back(inside(std::to_string(index), Number{.value = static_cast<double>(index + 1)},
                             units::none));
    return true;
}

}  // namespace ravnoves
