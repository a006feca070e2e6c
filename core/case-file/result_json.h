#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/json.h"
#include "case-file/result_visitor.h"

namespace ravnoves {

/// The wanted values of a "result" object; all by default. Others need not be computed.
class Wanted {
  public:
    Wanted() = default;
    /// @param pointers  JSON pointers below "result": "/metrics/M_ups/range_Nm", "/optimum"
    /// @throws InputError for any that is no JSON pointer
    explicit Wanted(std::vector<std::string> pointers);

    /// Whether the value at a pointer, something in it or something around it is asked for.
    bool wants(std::string_view pointer) const;
    /// The wanted values of a result, each whole under its own path; objects around elements of
    /// lists.
    /// @throws InputError that names a pointer where the result has no value
    Json pick(Json result) const;

  private:
    std::vector<std::string> pointers_;  ///< empty: all
};

/// Visits the values of some result.
using VisitResults = std::function<void(ResultVisitor& visitor)>;

/// The "result" object of a file, with the wanted members alone.
Json result_json(const Wanted& wanted, const VisitResults& visit);
/// The same by the scene's visit_results() of these arguments: an input, or a solved one.
template <typename... Solved>
auto result_json(const Wanted& wanted, const Solved&... solved) {
    return result_json(
        wanted, VisitResults([&](ResultVisitor& visitor) { visit_results(visitor, solved...); }));
}

/// One number of a result at its place.
struct ResultEntry {
    std::string pointer;  ///< below "result", for example "/metrics/M_ups/range_Nm"
    Message name;         ///< "M_ups, range", from the labels on the way to it
    Unit unit = units::none;
    int decimals = 3;
    double period = 0.0;  ///< 360 or 720 of an angle in degrees; 0 of what has none
    std::optional<double> si;
};

/// The single numbers of a result with their names; curves and lists of numbers are left out.
std::vector<ResultEntry> list_results(const VisitResults& visit);

}  // namespace ravnoves
