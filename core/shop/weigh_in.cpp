#include "shop/weigh_in.h"

#include <limits>
#include <numeric>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves::shop {

std::optional<ColumnStatistics> statistics(std::span<const Weighed> masses,
                                           const std::optional<double>& permitted_spread) {
    ColumnStatistics result{0, 0.0, 0.0, -1, -1, true};
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        if (!masses[i]) {
            continue;
        }
        const double mass = *masses[i];
        ++result.count;
        result.mean += mass;
        if (mass > most) {
            most = mass;
            result.heaviest = static_cast<int>(i);
        }
        if (mass < least) {
            least = mass;
            result.lightest = static_cast<int>(i);
        }
    }
    if (result.count == 0) {
        return std::nullopt;
    }
    result.mean /= result.count;
    result.spread = most - least;
    // A scale reads to hundredths of a gram: a microgram of rounding is no violation.
    constexpr double rounding = 1e-9;
    result.within_permitted = !permitted_spread || result.spread <= *permitted_spread + rounding;
    return result;
}

namespace {

SetNumbers as_weighed(std::size_t cylinders) {
    SetNumbers numbers(cylinders);
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

struct SetNumberList final : FieldVisitor::Custom {
    SetNumberList(SetNumbers& it, std::size_t count) : numbers(it), cylinders(count) {}

    void read(const Json& list, const std::string& pointer) override {
        const SetNumbers usual = as_weighed(cylinders);
        SetNumbers found;
        if (list.is_array()) {
            for (const Json& number : list) {
                found.push_back(number.is_number_integer() ? number.get<int>() : 0);
            }
        }
        if (found.size() != cylinders ||
            !std::is_permutation(found.begin(), found.end(), usual.begin())) {
            throw InputError(
                pointer,
                {CORE_TEXT("workshop", "must be the numbers 1 to %1, each once"), cylinders},
                show(list));
        }
        numbers = found == usual ? SetNumbers() : found;
    }
    Json write() override { return numbers.empty() ? Json() : Json(numbers); }

    SetNumbers& numbers;
    std::size_t cylinders;
};

}  // namespace

SetNumbers whole_numbers(const SetNumbers& numbers, std::size_t cylinders) {
    return numbers.size() == cylinders ? numbers : as_weighed(cylinders);
}

SetNumbers moved_numbers(const SetNumbers& numbers, const std::vector<int>& from) {
    const SetNumbers before = whole_numbers(numbers, from.size());
    SetNumbers after;
    for (const int cylinder : from) {
        after.push_back(before.at(static_cast<std::size_t>(cylinder)));
    }
    return after == as_weighed(from.size()) ? SetNumbers() : after;
}

void visit_set_numbers(FieldVisitor& visitor, const Field& field, SetNumbers& numbers,
                       std::size_t cylinders) {
    SetNumberList list(numbers, cylinders);
    visitor.custom(field, false, list);
}

void WeightList::read(const Json& masses, const std::string& pointer) {
    if (!masses.is_array() || masses.size() != weights_.size()) {
        throw InputError(
            pointer,
            {CORE_TEXT("workshop", "must be a list of %1 masses, one for each cylinder"),
             weights_.size()},
            show(masses));
    }
    for (std::size_t i = 0; i < masses.size(); ++i) {
        const Json& mass = masses.at(i);
        if (!mass.is_null() && !mass.is_number()) {
            throw InputError(pointer + "/" + std::to_string(i),
                             CORE_TEXT("core", "must be a number"), show(mass));
        }
        weights_[i] =
            mass.is_null() ? std::nullopt : std::optional(mass.get<double>() * mass_.unit);
    }
    check(pointer);
}

Json WeightList::write() {
    if (std::none_of(weights_.begin(), weights_.end(), [](const Weighed& m) { return m; })) {
        return {};
    }
    Json masses = Json::array();
    for (const Weighed& mass : weights_) {
        masses.push_back(mass ? Json(from_si(mass_, *mass)) : Json());
    }
    return masses;
}

void WeightList::check(const std::string& pointer) {
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        if (weights_[i]) {
            check_range(mass_, from_si(mass_, *weights_[i]), pointer + "/" + std::to_string(i));
        }
    }
}

void check_weighed(Part part, std::span<const Weighed> masses) {
    const auto gap = std::find(masses.begin(), masses.end(), std::nullopt);
    if (gap != masses.end()) {
        throw InputError("/input/weigh_in/" + std::string(part_word(part).word) + "/mass_g/" +
                             std::to_string(gap - masses.begin()),
                         CORE_TEXT("core", "must be a number"), "null");
    }
}

}  // namespace ravnoves::shop
