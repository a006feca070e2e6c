#pragma once

#include <functional>
#include <map>
#include <string_view>

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

/// One job for each doubt.
inline const std::map<std::string_view, std::function<Json()>>& doubted() {
    static const std::map<std::string_view, std::function<Json()>> jobs{
        {"swapped-ends",
         [] {
             Json input = weighed_card();
             std::swap(input["weigh_in"]["rod_small_end"], input["weigh_in"]["rod_big_end"]);
             input["parts_g"].erase("small_end");
             input["parts_g"].erase("big_end");
             return input;
         }},
        {"kilograms",
         [] {
             Json input = card();
             input["parts_g"]["pin"] = 0.1736;
             return input;
         }},
        {"odd-mass",
         [] {
             // 30 g off among seven within 6 g: five per cent.
             Json input = weighed_card();
             input["weigh_in"]["piston"]["mass_g"] = {583, 586, 581, 585, 613, 584, 582, 587};
             return input;
         }},
        {"unlike-halves",
         [] {
             Json input = card();
             input["parts_g"]["piston"] = 5839;
             return input;
         }},
        {"typed-against-weighed",
         [] {
             Json input = weighed_card();
             input["weigh_in"]["rod_big_end"]["mass_g"] = eight(170);
             return input;
         }},
        {"nominal-against-weighed",
         [] {
             Json input = weighed_card();
             input["weigh_in"]["piston"]["nominal_g"] = 383.9;
             return input;
         }},
        {"share-of-one",
         [] {
             Json input = card();
             input["factor"]["reciprocating_percent"] = 0.5;
             return input;
         }},
        {"plug-mass",
         [] {
             Json input = plugs_card();
             input["plugs"]["engine"]["steel_plug_mass_g"] = 12;
             return input;
         }},
        {"paper-plug",
         [] {
             Json input = plugs_card();
             input["plugs"]["engine"] = "4.25 l";
             input["plugs"]["engine_overrides"] = {{"oil_mass_g", 20},
                                                   {"oil_coefficient", 1},
                                                   {"reciprocating_mass_g", 1000},
                                                   {"rotating_mass_g", 650}};
             input["plugs"]["plug"] = {{"thread", "M22x1.5"}, {"height_mm", 14}};
             return input;
         }},
        {"other-crankshaft",
         [] {
             Json input = card();
             input["job"]["crankshaft_number"] = "2";
             input["correction"]["readings"][0]["read_of"]["crankshaft_number"] = "1";
             return input;
         }},
        {"other-bob-weight",
         [] {
             Json input = card();
             input["correction"]["readings"][0]["bobweight_g"] = 1500;
             return input;
         }},
        {"beside-planes",
         [] {
             Json input = card();
             input["correction"]["readings"] = parse_json(
                 R"([{"unbalance_g_mm": 300, "position_mm": -1000}, {"unbalance_g_mm": 400}])");
             return input;
         }},
        {"rotor-mass",
         [] {
             Json input = card();
             input["tolerance"]["rotor_mass_kg"] = 24'000;
             return input;
         }},
        {"service-speed",
         [] {
             Json input = card();
             input["tolerance"]["service_speed_rpm"] = 5.5;
             return input;
         }},
        {"bearings",
         [] {
             Json input = card();
             input["tolerance"]["front_bearing_mm"] = 520;
             input["tolerance"]["rear_bearing_mm"] = 20;
             return input;
         }},
        {"drilled-at-light-spot",
         [] {
             // It was drilled and passes; then the machine is said to show the light spot.
             Json input = card();
             input["correction"]["earlier_runs"] = parse_json(R"([{
                 "readings": [{"unbalance_g_mm": 1250, "angle_deg": 40},
                              {"unbalance_g_mm": 0}],
                 "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 40}]
                 }])");
             input["correction"]["readings"] =
                 parse_json(R"([{"unbalance_g_mm": 150, "angle_deg": 40}, {"unbalance_g_mm": 0}])");
             input["machine"]["shows"] = "light";
             return input;
         }},
        {"drilled-counting-otherwise",
         [] {
             Json input = card();
             input["correction"]["earlier_runs"] = parse_json(R"([{
                 "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 40}],
                 "drilled_counting_otherwise": true}])");
             return input;
         }},
        {"drilled-otherwise",
         [] {
             Json input = card();
             input["correction"]["earlier_runs"] = parse_json(R"([{
                 "readings": [{"unbalance_g_mm": 1250, "angle_deg": 40},
                              {"unbalance_g_mm": 1200, "angle_deg": 290}],
                 "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 40}]
                 }])");
             return input;
         }},
        {"plane-radius",
         [] {
             Json input = plugs_card();
             input["correction"]["planes"][1]["radius_mm"] = 156;
             return input;
         }},
        {"unlike-radii",
         [] {
             Json input = card();
             input["correction"]["planes"][1]["radius_mm"] = 170;
             return input;
         }},
        {"plane-order",
         [] {
             Json input = card();
             input["correction"]["planes"][0]["position_mm"] = 480;
             input["correction"]["planes"][1]["position_mm"] = 60;
             return input;
         }},
        {"gear-against-parts",
         [] {
             Json input = plugs_card();
             for (const char* part : {"piston", "pin", "rings", "rod_small_end"}) {
                 input["weigh_in"][part] = {{"nominal_g", 251}, {"mass_g", eight(251)}};
             }
             return input;
         }},
        {"plug-shift",
         [] {
             // The shift of a heavy plug is worth more than a narrow limit.
             Json input = plugs_card();
             input["plugs"]["plug"].erase("bore_diameter_mm");
             input["plugs"].erase("plug");
             input["plugs"]["tolerance_g_mm"] = 1;
             return input;
         }},
        {"unequal-crankpins",
         [] {
             Json input = plugs_card();
             input["plugs"].erase("mass_changes_g");
             input["plugs"]["mass_changes_from"] = "weigh-in";
             input["plugs"]["tolerance_g_mm"] = 5;
             input["weigh_in"]["piston"] = {{"nominal_g", 560},
                                            {"mass_g", {560, 561, 562, 563, 560, 561, 562, 563}}};
             return input;
         }},
        {"spread",
         [] {
             Json input = weighed_card();
             input["weigh_in"]["piston"] = {{"permitted_spread_g", 2},
                                            {"mass_g", {580, 582, 584, 586, 581, 583, 585, 587}}};
             return input;
         }},
        {"amplification",
         [] {
             Json input = card();
             input["correction"]["readings"][0]["position_mm"] = -500;
             return input;
         }},
        {"beyond-sector",
         [] {
             Json input = card();
             input["correction"]["readings"][0] = {{"unbalance_g_mm", 900}, {"angle_deg", 40}};
             input["correction"]["planes"][0]["from_deg"] = 40;
             input["correction"]["planes"][0]["to_deg"] = 120;
             return input;
         }},
        {"all-round",
         [] {
             Json input = card();
             input["correction"]["planes"][0].erase("from_deg");
             input["correction"]["planes"][0].erase("to_deg");
             return input;
         }},
    };
    return jobs;
}

}  // namespace ravnoves::workshop::test
