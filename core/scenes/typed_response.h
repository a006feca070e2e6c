#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/field_index.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/response.h"
#include "case-file/result_numbers.h"

namespace ravnoves {

/// Visits each input's results again.
template <typename Input>
struct FreshResults {
    void visit(ResultVisitor& visitor, const Input& input) { visit_results(visitor, input); }
};

/// Values of a scene's result as functions of numbers of its input: puts them into the input and
/// visits the watched ones, without a file in between. A number that the fields hand out as a copy
/// is put into the JSON instead, which is read again for each evaluation.
/// @tparam read_input   of the scene, from the "input" object of a case
/// @tparam check_input  throws where the input as a whole is rejected
/// @tparam Results      visits the results of one input after the other
template <typename Input, auto read_input, auto check_input, typename Results>
class TypedResponse final : public Response {
  public:
    TypedResponse(const Json& json, const CaseContext& context, std::span<const std::string> varied,
                  std::span<const std::string> watched)
        : context_(context), json_(json), input_(read_input(json_, context_)), numbers_(watched) {
        Input other = input_;
        for (const std::string& pointer : varied) {
            auto found = list_fields(input_, pointer);
            const auto others = list_fields(other, pointer);
            has_places_ = has_places_ && !found.empty() && found[0].place != nullptr &&
                          found[0].place != others[0].place;
            places_.push_back(found.empty() ? FieldEntry() : std::move(found[0]));
            slots_.push_back(&json_[Json::json_pointer(pointer)]);
        }
    }

    bool evaluate(std::span<const double> x, std::span<double> y) override {
        std::fill(y.begin(), y.end(), std::numeric_limits<double>::quiet_NaN());
        numbers_.clear();
        try {
            if (!set(x)) {
                return false;
            }
            results_.visit(numbers_, input_);
        } catch (const InputError& error) {
            reason_ = {error.where_message(), error.allowed_message()};
            return false;
        }
        bool whole = true;
        for (std::size_t w = 0; w < y.size(); ++w) {
            if (const auto value = numbers_.value(w)) {
                y[w] = *value;
            } else if (whole) {
                whole = false;
                Message why = numbers_.why(w);
                reason_ = {numbers_.pointer(w), why.empty() ? Message(no_value) : std::move(why)};
            }
        }
        return whole;
    }
    double period(std::size_t watched) const override { return numbers_.period(watched); }

  private:
    bool set(std::span<const double> x) {
        if (!has_places_) {
            for (std::size_t j = 0; j < x.size(); ++j) {
                *slots_[j] = x[j];
            }
            input_ = read_input(json_, context_);
            return true;
        }
        for (std::size_t j = 0; j < x.size(); ++j) {
            const FieldEntry& entry = places_[j];
            if (const Range* range = entry.field.left_by(x[j])) {
                reason_ = {"/input" + entry.pointer, range->message()};
                return false;
            }
            *entry.place = x[j] * entry.place_unit;
        }
        check_input(input_);
        return true;
    }

    CaseContext context_;
    Json json_;
    Input input_;
    std::vector<FieldEntry> places_;
    std::vector<Json*> slots_;
    bool has_places_ = true;
    ResultNumbers numbers_;
    Results results_;
};

}  // namespace ravnoves
