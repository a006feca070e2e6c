#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "support.h"

namespace ravnoves::workshop::test {

inline Json eight(double mass) {
    return std::vector<double>(8, mass);
}

/// Weighed as it was typed.
inline Json weighed_card() {
    Json input = card();
    input["weigh_in"] = {{"piston", {{"mass_g", eight(583.9)}}},
                         {"rod_small_end", {{"mass_g", eight(162.4)}}},
                         {"rod_big_end", {{"mass_g", eight(429.8)}}}};
    return input;
}

/// Drilled after two runs, all of it measured.
inline Json twice_drilled() {
    Json input = card();
    input["tolerance"] = {{"grade_mm_s", 16}, {"rotor_mass_kg", 32}, {"service_speed_rpm", 6000}};
    Json& correction = input["correction"];
    correction["planes"][1]["radius_mm"] = 85;
    correction["earlier_runs"] = parse_json(R"([
        {"readings": [{"unbalance_g_mm": 2600, "angle_deg": 75},
                      {"unbalance_g_mm": 1450, "angle_deg": 210}],
         "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 15, "angle_deg": 75,
                      "state": "measured"},
                     {"plane": "rear", "diameter_mm": 16, "depth_mm": 10, "angle_deg": 210,
                      "state": "measured"}]},
        {"readings": [{"unbalance_g_mm": 610, "angle_deg": 75},
                      {"unbalance_g_mm": 95, "angle_deg": 70}],
         "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 16, "from_depth_mm": 15,
                      "angle_deg": 75, "state": "measured"}]}])");
    correction["readings"] = parse_json(R"([{"unbalance_g_mm": 480, "angle_deg": 80},
                                            {"unbalance_g_mm": 90, "angle_deg": 72}])");
    return input;
}

/// A job nobody doubts, with what makes it doubtful.
struct DoubtedJob {
    Json (*base)();
    Changes changes;

    Json operator()() const { return changed(base(), changes); }
};

/// One job for each doubt.
inline const std::map<std::string_view, DoubtedJob>& doubted() {
    const auto weighed = [](const Json& masses) { return Json{{"mass_g", masses}}; };
    const auto of_nominal = [](double nominal, const Json& masses) {
        return Json{{"nominal_g", nominal}, {"mass_g", masses}};
    };
    const auto hole = [](double angle_deg, double depth_mm = 9) {
        return Json{{"plane", "front"},
                    {"diameter_mm", 16},
                    {"depth_mm", depth_mm},
                    {"angle_deg", angle_deg}};
    };
    const auto holes_before = [&](const Json& hole) {
        return Json::array({{{"drilled", {hole}}}});
    };
    const auto read = [](double unbalance_g_mm, double angle_deg) {
        return Json{{"unbalance_g_mm", unbalance_g_mm}, {"angle_deg", angle_deg}};
    };
    const Json nothing{{"unbalance_g_mm", 0}};
    const auto run = [&](const Json& rear) {
        return Json::array({{{"readings", {read(1250, 40), rear}}, {"drilled", {hole(40)}}}});
    };
    static const std::map<std::string_view, DoubtedJob> jobs{
        {"swapped-ends",
         {weighed_card,
          {{"/weigh_in/rod_small_end", weighed(eight(429.8))},
           {"/weigh_in/rod_big_end", weighed(eight(162.4))},
           {"/parts_g/small_end", nullptr},
           {"/parts_g/big_end", nullptr}}}},
        {"kilograms", {card, {{"/parts_g/pin", 0.1736}}}},
        // 30 g off among seven within 6 g: five per cent.
        {"odd-mass",
         {weighed_card, {{"/weigh_in/piston/mass_g", {583, 586, 581, 585, 613, 584, 582, 587}}}}},
        {"unlike-halves", {card, {{"/parts_g/piston", 5839}}}},
        {"unlike-parts", {card, {{"/parts_g/shells", 441}}}},
        {"much-oil", {card, {{"/parts_g/oil", 400}}}},
        {"typed-against-weighed", {weighed_card, {{"/weigh_in/rod_big_end/mass_g", eight(170)}}}},
        {"nominal-against-weighed", {weighed_card, {{"/weigh_in/piston/nominal_g", 383.9}}}},
        {"share-of-one", {card, {{"/factor/reciprocating_percent", 0.5}}}},
        {"plug-mass", {plugs_card, {{"/plugs/engine/steel_plug_mass_g", 12}}}},
        {"plug-radius", {plugs_card, {{"/plugs/engine/plug_radius_mm", 4.72}}}},
        {"half-weighed",
         {plugs_card,
          {{"/plugs/mass_changes_g", nullptr},
           {"/plugs/mass_changes_from", "weigh-in"},
           {"/weigh_in/piston", of_nominal(560, eight(560))},
           {"/weigh_in/rings", of_nominal(60, {60, 60, nullptr, nullptr, 60, 60, 60, 60})}}}},
        {"taken-as-nominal",
         {plugs_card,
          {{"/plugs/mass_changes_g", nullptr},
           {"/plugs/mass_changes_from", "weigh-in"},
           {"/weigh_in/piston", of_nominal(560, eight(562))}}}},
        {"paper-plug", {plugs_card, {{"/plugs/plug", {{"thread", "M22x1.5"}, {"height_mm", 14}}}}}},
        {"paper-limit",
         {plugs_card,
          {{"/plugs/engine", "4.25 l"},
           {"/plugs/engine_overrides",
            {{"steel_plug_mass_g", 28.5},
             {"aluminium_plug_mass_g", 9.8},
             {"oil_mass_g", 20},
             {"oil_coefficient", 1},
             {"reciprocating_mass_g", 1000},
             {"rotating_mass_g", 650}}}}}},
        {"other-crankshaft",
         {card,
          {{"/job/crankshaft_number", "2"},
           {"/correction/readings/0/read_of", {{"crankshaft_number", "1"}}}}}},
        {"other-bob-weight", {card, {{"/correction/readings/0/bobweight_g", 1500}}}},
        {"beside-planes",
         {card,
          {{"/correction/readings/0", {{"unbalance_g_mm", 300}, {"position_mm", -1000}}},
           {"/correction/readings/1", {{"unbalance_g_mm", 400}}}}}},
        {"unknown-bob-weight", {card, {{"/parts_g", nullptr}}}},
        {"rotor-mass", {card, {{"/tolerance/rotor_mass_kg", 120}}}},
        {"service-speed", {card, {{"/tolerance/service_speed_rpm", 5.5}}}},
        {"grade", {card, {{"/tolerance/grade_mm_s", 63}}}},
        {"bearings",
         {card, {{"/tolerance/front_bearing_mm", 520}, {"/tolerance/rear_bearing_mm", 20}}}},
        // It was drilled and passes; then the machine is said to show the light spot.
        {"drilled-at-light-spot",
         {card,
          {{"/correction/earlier_runs", run(nothing)},
           {"/correction/readings", {read(150, 40), nothing}},
           {"/machine/shows", "light"}}}},
        {"drilled-counting-otherwise",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"drilled", {hole(40)}}, {"drilled_counting_otherwise", true}}})}}}},
        {"drilled-otherwise", {card, {{"/correction/earlier_runs", run(read(1200, 290))}}}},
        {"drilled-beside-plan",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"readings", {read(3700, 40), nothing}},
                          {"drilled", {changed(hole(40, 29), {{"/state", "measured"}})}}}})},
           {"/correction/readings", {read(1000, 40), nothing}}}}},
        // By a radius of 100 mm.
        {"drilled-by-other-values",
         {card,
          {{"/correction/earlier_runs",
            holes_before(changed(hole(40), {{"/removed_g_mm", 1584}}))}}}},
        // By the record 1167 was to be left; the deepening acted as it was to.
        {"drilled-unlike-record",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"readings", {read(2500, 40), nothing}}, {"drilled", {hole(40)}}},
                         {{"readings", {read(1600, 40), nothing}},
                          {"drilled", {changed(hole(40, 20), {{"/from_depth_mm", 9}})}}}})},
           {"/correction/readings", {read(150, 40), nothing}}}}},
        // By the record 150 was to be left: the hole is less deep than planned.
        {"deepens-unmeasured",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"readings", {read(2600, 40), nothing}}, {"drilled", {hole(40, 20)}}}})},
           {"/correction/readings", {read(650, 40), nothing}}}}},
        // A further run was emptied again.
        {"drilled-unread", {card, {{"/correction/drilled", Json::array({hole(40)})}}}},
        {"other-plan", {card, {{"/correction/planned", {{"drilled", Json::array({hole(40)})}}}}}},
        {"incomplete-run",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"readings", {{{"unbalance_g_mm", 1250}}, nothing}},
                          {"drilled", {hole(40)}}}})}}}},
        {"missing-angle",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"readings", {read(1250, 40), read(1200, 290)}}}})},
           {"/correction/readings", {read(60, 100), {{"unbalance_g_mm", 150}}}}}}},
        {"shallower-hole",
         {card,
          {{"/correction/earlier_runs",
            Json::array({{{"drilled", {hole(40, 15)}}},
                         {{"drilled",
                           {changed(hole(40, 14),
                                    {{"/from_depth_mm", 15}, {"/state", "measured"}})}}}})}}}},
        {"half-sector", {card, {{"/correction/planes/0/to_deg", nullptr}}}},
        {"outside-sector",
         {card,
          {{"/correction/earlier_runs", holes_before(hole(200))},
           {"/correction/planes/0/to_deg", 120}}}},
        {"drilled-too-deep", {card, {{"/correction/earlier_runs", holes_before(hole(40, 50))}}}},
        {"drilled-deep", {card, {{"/correction/earlier_runs", holes_before(hole(40, 33))}}}},
        {"swapped-planes", {card, {{"/machine/planes", {"flywheel", "pulley"}}}}},
        {"left-and-right", {card, {{"/machine/planes", {"Right", "left"}}}}},
        {"plane-radius", {plugs_card, {{"/correction/planes/1/radius_mm", 156}}}},
        {"implausible-radius", {card, {{"/correction/planes/1/radius_mm", 780}}}},
        {"deep-holes", {card, {{"/correction/drill/maximum_depth_mm", 250}}}},
        {"far-radius", {card, {{"/correction/planes/1/radius_mm", 170}}}},
        {"unlike-radii", {card, {{"/correction/planes/1/radius_mm", 40}}}},
        {"plane-order",
         {card,
          {{"/correction/planes/0/position_mm", 480}, {"/correction/planes/1/position_mm", 60}}}},
        {"gear-against-parts",
         {plugs_card,
          {{"/weigh_in/piston", of_nominal(251, eight(251))},
           {"/weigh_in/pin", of_nominal(251, eight(251))},
           {"/weigh_in/rings", of_nominal(251, eight(251))},
           {"/weigh_in/rod_small_end", of_nominal(251, eight(251))}}}},
        // The shift of a heavy plug is worth more than a narrow limit.
        {"plug-shift", {plugs_card, {{"/plugs/plug", nullptr}, {"/plugs/tolerance_g_mm", 1}}}},
        {"unequal-crankpins",
         {plugs_card,
          {{"/plugs/mass_changes_g", nullptr},
           {"/plugs/mass_changes_from", "weigh-in"},
           {"/plugs/tolerance_g_mm", 5},
           {"/weigh_in/piston", of_nominal(560, {560, 561, 562, 563, 560, 561, 562, 563})}}}},
        {"spread",
         {weighed_card,
          {{"/weigh_in/piston/permitted_spread_g", 2},
           {"/weigh_in/piston/mass_g", {580, 582, 584, 586, 581, 583, 585, 587}}}}},
        {"amplification", {card, {{"/correction/readings/0/position_mm", -500}}}},
        {"beyond-sector",
         {card,
          {{"/correction/readings/0", read(600, 40)},
           {"/correction/earlier_runs", holes_before(hole(40))},
           {"/correction/planes/0/from_deg", 40},
           {"/correction/planes/0/to_deg", 120}}}},
        {"great-reading", {card, {{"/correction/readings/0/unbalance_g_mm", 85'000}}}},
        {"reading-in-grams",
         {card, {{"/correction/readings", Json::array({read(35, 120), read(20, 250)})}}}},
        {"drill-size", {card, {{"/correction/drill/diameters_mm", {10.12, 12.7, 9.53, 8.25}}}}},
        // Beside the sector nothing can be drilled, and little is to be pressed in opposite.
        {"short-slug",
         {card,
          {{"/correction/readings/0", read(600, 40)},
           {"/correction/planes/0/from_deg", 130},
           {"/correction/planes/0/to_deg", 300},
           {"/correction/slug", {{"diameter_mm", 25}, {"density_kg_m3", 17'500}}}}}},
        {"all-round",
         {card,
          {{"/correction/planes/0/from_deg", nullptr}, {"/correction/planes/0/to_deg", nullptr}}}},
    };
    return jobs;
}

}  // namespace ravnoves::workshop::test
