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

    const std::string& pointer(std::size_t i) const { return pointers_[i]; }
    /// In the unit of the key; empty without a value.
    std::optional<double> value(std::size_t i) const { return nodes_[places_[i]].value; }
    /// Of an angle 360 or 720, once a visit had a value; else 0.
    double period(std::size_t i) const { return nodes_[places_[i]].period; }
    /// Why it is empty: the reason or note of the nearest object around it that has one.
    Message why(std::size_t i) const;

    bool wants(std::string_view key) const override;

  private:
    /// A key on the way to a number that is wanted; the first node is the result.
    struct Node {
        std::size_t around = 0;
        std::vector<std::pair<std::string, std::size_t>> inside{};
        std::optional<double> value{};
        double period = 0.0;
        Message why{};
    };

    void leaf(const ResultField& field, const ResultValue& value) override;
    bool begin_object(const ResultField& field) override { return enter(field.key); }
    bool begin_list(const ResultField& field) override { return enter(field.key); }
    bool begin_element(std::size_t index) override { return enter(std::to_string(index)); }
    void end() override { at_ = nodes_[at_].around; }

    std::size_t inside(std::size_t around, std::string_view key) const;  ///< 0: not wanted
    bool enter(std::string_view key);
    void set(std::size_t node, const ResultField& field, double value);

    std::vector<Node> nodes_;
    std::vector<std::string> pointers_;
    std::vector<std::size_t> places_;  ///< nodes of the pointers
    std::size_t at_ = 0;
};

}  // namespace ravnoves
