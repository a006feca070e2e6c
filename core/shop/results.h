#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "case-file/result_visitor.h"
#include "case-file/verdict.h"
#include "shop/job_header.h"
#include "shop/matching.h"

/// The values of results that the scenes of a workshop share.
namespace ravnoves::shop {

namespace result_field {
inline constexpr ResultField weigh_in{.key = "weigh_in",
                                      .label = CORE_TEXT("workshop", "Weigh-in")};
inline constexpr ResultField mean{"mean_g", units::gram, 2, CORE_TEXT("workshop", "Mean")};
inline constexpr ResultField spread{"spread_g", units::gram, 2, CORE_TEXT("workshop", "Range"),
                                    CORE_TEXT("workshop", "Heaviest minus lightest.")};
inline constexpr ResultField heaviest_cylinder{
    .key = "heaviest_cylinder", .label = CORE_TEXT("workshop", "Heaviest, cylinder")};
inline constexpr ResultField lightest_cylinder{
    .key = "lightest_cylinder", .label = CORE_TEXT("workshop", "Lightest, cylinder")};
inline constexpr ResultField within_permitted_spread{
    .key = "within_permitted_spread", .label = CORE_TEXT("workshop", "Within permitted range")};
inline constexpr ResultField part_numbers{.key = "part_numbers",
                                          .label = CORE_TEXT("workshop", "Part number")};
inline constexpr ResultField take_off{"take_off_g", units::gram, 2,
                                      CORE_TEXT("workshop", "Take off")};
inline constexpr ResultField mean_deviation{"mean_deviation_g", units::gram, 2,
                                            CORE_TEXT("workshop", "Mean minus nominal")};

inline constexpr ResultField assignment{.key = "assignment",
                                        .label = CORE_TEXT("workshop", "Matching of the parts")};
inline constexpr ResultField pistons_from{.key = "pistons_from_cylinder"};
inline constexpr ResultField rods_from{.key = "rods_from_cylinder"};
inline constexpr ResultField sets_moved{.key = "sets_moved",
                                        .label = CORE_TEXT("workshop", "Sets moved")};
inline constexpr ResultField goal{.key = "goal"};
inline constexpr ResultField spread_before{"spread_before_g", units::gram, 2,
                                           CORE_TEXT("workshop", "Range of the crankpins before")};
inline constexpr ResultField spread_after{"spread_g", units::gram, 2,
                                          CORE_TEXT("workshop", "Range of the crankpins")};
inline constexpr ResultField proven{.key = "proven", .label = CORE_TEXT("workshop", "Proven")};
inline constexpr ResultField shaking_before{.key = "shaking_before",
                                            .label = CORE_TEXT("workshop", "Shaking before")};
inline constexpr ResultField shaking{.key = "shaking", .label = CORE_TEXT("workshop", "Shaking")};
inline constexpr ResultField remark{.key = "remark"};
inline constexpr ResultField force_mass{"force_g", units::gram, 2,
                                        CORE_TEXT("workshop", "Force, mass at the crank radius")};
inline constexpr ResultField ends{"rms_at_ends_g", units::gram, 2,
                                  CORE_TEXT("workshop", "RMS at the ends")};
inline constexpr ResultField couple_mass{"couple_g_mm", units::gram_mm, 1,
                                         CORE_TEXT("workshop", "Couple, mass at the crank radius")};
inline constexpr ResultField force_unbalance{"force_g_mm", units::gram_mm, 1,
                                             CORE_TEXT("workshop", "Force, unbalance")};
inline constexpr ResultField couple_unbalance{"couple_g_mm2", units::gram_mm2, 0,
                                              CORE_TEXT("workshop", "Couple, unbalance")};
inline constexpr ResultField force{"force_N", units::newton, 1, CORE_TEXT("workshop", "Force")};
inline constexpr ResultField couple{"couple_Nm", units::N_m, 2, CORE_TEXT("workshop", "Couple")};

inline constexpr ResultField read_with{"read_with_bobweight_g", units::gram, 1,
                                       CORE_TEXT("workshop", "Bob weight of the readings")};
inline constexpr ResultField read_on{.key = "read_on"};

inline constexpr ResultField lines{.key = "lines", .label = CORE_TEXT("workshop", "Lines")};
inline constexpr ResultField part{.key = "part"};
inline constexpr ResultField factor{"factor", units::none, 4, CORE_TEXT("workshop", "Factor")};
inline constexpr ResultField mass{"mass_g", units::gram, 2, CORE_TEXT("workshop", "Mass")};
inline constexpr ResultField product{"product_g", units::gram, 2, CORE_TEXT("workshop", "Total")};
}  // namespace result_field

/// The weighed columns under the words of their parts.
void visit_columns(ResultVisitor& visitor, const WeighIn& sheet);

/// The values of a placing, but for what the scene knows of the crankpins.
/// @param crank_radius  m; without it there are no forces
/// @param speed         rad/s; without it there are none in N
void visit_matched(ResultVisitor& visitor, const Matched& matched,
                   const std::optional<double>& crank_radius, const std::optional<double>& speed);

/// A line of a bob weight's sum.
struct CardLine {
    std::string_view part;
    double factor;
    double mass;  ///< kg
};
template <typename LineAt>
void visit_lines(ResultVisitor& visitor, std::size_t count, const LineAt& line_at) {
    visitor.list(result_field::lines, count, [&](std::size_t i) {
        const CardLine line = line_at(i);
        visitor.word(result_field::part, line.part);
        visitor.number(result_field::factor, line.factor);
        visitor.number(result_field::mass, line.mass);
        visitor.number(result_field::product, line.factor * line.mass);
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
