#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case-file/json_fwd.h"

namespace ravnoves {

/// The wanted values of a "result" object; all by default. Others need not be computed.
class Wanted {
  public:
    Wanted() = default;
    /// @param pointers  JSON pointers below "result": "/metrics/M_ups/range_Nm", "/optimum"
    /// @throws InputError for any that is no JSON pointer
    explicit Wanted(std::vector<std::string> pointers);

    bool is_all() const { return pointers_.empty(); }
    /// Whether the value at a pointer, something in it or something around it is asked for.
    bool wants(std::string_view pointer) const;
    /// The wanted values of a result, each whole under its own path; objects around elements of
    /// lists.
    /// @throws InputError that names a pointer where the result has no value
    Json pick(Json result) const;

  private:
    std::vector<std::string> pointers_;  ///< empty: all
};

}  // namespace ravnoves
