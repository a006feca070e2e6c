#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case-file/result_visitor.h"

namespace ravnoves {

/// Picks numbers of a result by their pointers, without writing it: what a study watches. Nothing
/// else of the result is computed. Yes and no are 1 and 0.
class ResultNumbers final : public ResultVisitor {
  public:
    /// @param pointers  below "result": "/metrics/M_ups/range_Nm", "/throws/0/rotating_mass_kg"
    explicit ResultNumbers(std::span<const std::string> pointers);

    /// To be called before each visit but the first.
    void clear();

    const std::string& pointer(std::size_t i) const { return numbers_[i].pointer; }
    /// In the unit of the key; empty without a value.
    std::optional<double> value(std::size_t i) const { return numbers_[i].value; }
    /// Of an angle 360 or 720, once a visit had a value; else 0.
    double period(std::size_t i) const { return numbers_[i].period; }
    /// Why it is empty: the reason or note of the nearest object around it that has one.
    Message why(std::size_t i) const;

    bool wants(std::string_view key) const override;

  private:
    struct Picked {
        std::string pointer;
        std::optional<double> value{};
        double period = 0.0;
    };

    void leaf(const ResultField& field, const ResultValue& value) override;
    bool begin_object(const ResultField& field) override { return wants(field.key); }
    bool begin_element(std::size_t index) override { return wants(std::to_string(index)); }

    /// Of a pointer behind a key of the visited object; nothing where it leads elsewhere.
    std::optional<std::string_view> rest(const Picked& number, std::string_view key) const;

    std::vector<Picked> numbers_;
    std::vector<std::pair<std::string, Message>> reasons_;  ///< by pointer of the object
};

}  // namespace ravnoves
