#pragma once

#include <array>
#include <optional>

#include "case-file/result_visitor.h"
#include "case-file/verdict.h"
#include "shop/job_header.h"
#include "shop/matching.h"

/// The values of results that the scenes of a workshop share.
namespace ravnoves::shop {

namespace result_field {
inline constexpr ResultField weigh_in{"weigh_in", Text::tr("Weigh-in")};
inline constexpr ResultField spread{"spread_g", Text::tr("Range"), 2,
                                    Text::tr("Heaviest minus lightest.")};

inline constexpr ResultField assignment{"assignment", Text::tr("Matching of the parts")};

}  // namespace result_field

/// The weighed columns under the words of their parts.
void visit_columns(ResultVisitor& visitor, const WeighIn& sheet);

/// The values of a placing, but for what the scene knows of the crankpins.
/// @param crank_radius  m; without it there are no forces
/// @param speed         rad/s; without it there are none in N
void visit_matched(ResultVisitor& visitor, const Matched& matched,
                   const std::optional<double>& crank_radius, const std::optional<double>& speed);

/// The lines of a bob weight's sum, of either scene.
void visit_lines(ResultVisitor& visitor, const auto& lines) {
    visitor.list({"lines", Text::tr("Lines")}, lines.size(), [&](std::size_t i) {
        visitor.word({"part"}, lines[i].name.word);
        visitor.number({"factor", Text::tr("Factor"), 4}, lines[i].factor);
        visitor.number({"mass_g", Text::tr("Mass"), 2}, lines[i].mass);
        visitor.number({"product_g", Text::tr("Total"), 2}, lines[i].product());
    });
}

/// The state at the readings of the balancing machine, where it differs from the present one.
void visit_other(ResultVisitor& visitor, const std::optional<double>& read_with,
                 const std::optional<OtherShaft>& read_on);
/// The same as a sentence; empty while the readings are valid.
Message other_readings(const std::optional<double>& read_with,
                       const std::optional<OtherShaft>& read_on,
                       const std::optional<double>& bob_weight_now);

/// Puts the machine's reading in both planes before the verdict: passes or fails. Nothing while a
/// reading that could fail, or a limit, is missing.
void add_machine_verdict(Verdict& verdict, const std::array<std::optional<double>, 2>& unbalance,
                         const std::optional<std::array<double, 2>>& permissible,
                         const std::array<std::string, 2>& own_names = {});
/// What the machine calls its planes, in a sentence; "front" and "rear" where it has no own names.
std::array<Message, 2> plane_names(const std::array<std::string, 2>& own);
/// The same where it begins a sentence.
Message plane_title(const std::array<std::string, 2>& own, std::size_t plane);

}  // namespace ravnoves::shop
