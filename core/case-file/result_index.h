#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/result_visitor.h"

namespace ravnoves {

/// One number of a result at its place.
struct ResultEntry {
    std::string pointer;  ///< below "result", for example "/metrics/M_ups/range_Nm"
    Message name;         ///< "M_ups, range", from the labels on the way to it
    Unit unit = units::none;
    int decimals = 3;
    double period = 0.0;  ///< 360 or 720 of an angle in degrees; 0 of what has none
    std::optional<double> si;
};

/// Lists the single numbers of a result with their names; curves and lists of numbers are left out.
class ResultIndex final : public ResultVisitor {
  public:
    std::vector<ResultEntry> take() { return std::move(entries_); }

    bool wants(std::string_view /*key*/) const override { return true; }

  private:
    void leaf(const ResultField& field, const ResultValue& value) override;
    bool begin_object(const ResultField& field) override;
    bool begin_list(const ResultField& field) override { return begin_object(field); }
    bool begin_element(std::size_t index) override;
    void end() override { levels_.pop_back(); }

    struct Level {
        std::string pointer;
        Message name;
        Unit unit = units::none;  ///< of what has none of its own
    };
    Level inside(std::string_view key, const Message& label, const Unit& unit) const;

    std::vector<Level> levels_{1};
    std::vector<ResultEntry> entries_;
};

}  // namespace ravnoves
