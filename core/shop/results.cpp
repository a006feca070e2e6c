#include "shop/results.h"

#include <cctype>
#include <limits>

#include "shop/balance_grade.h"
#include "shop/sentences.h"

namespace ravnoves::shop {

namespace {

namespace key = result_field;

void visit_shaking(ResultVisitor& visitor, const ResultField& field, const Shaking& shaking,
                   bool spacing_known, const std::optional<double>& radius,
                   const std::optional<double>& speed) {
    visitor.object(field, [&] {
        const auto couple = [&](const ResultField& of, double value) {
            if (spacing_known) {
                visitor.number(of, value);
            }
        };
        visitor.number({"force_g", Text::tr("Force, mass at the crank radius"), 2}, shaking.force);
        visitor.number({"rms_at_ends_g", Text::tr("RMS at the ends"), 2}, shaking.ends);
        couple({"couple_g_mm", Text::tr("Couple, mass at the crank radius"), 1}, shaking.couple);
        if (radius) {
            visitor.number({"force_g_mm", Text::tr("Force, unbalance"), 1},
                           shaking.force * *radius);
            couple({"couple_g_mm2", Text::tr("Couple, unbalance"), 0}, shaking.couple * *radius);
        }
        if (radius && speed) {
            visitor.number({"force_N", Text::tr("Force"), 1},
                           shaking.force * *radius * *speed * *speed);
            couple({"couple_Nm", Text::tr("Couple"), 2},
                   shaking.couple * *radius * *speed * *speed);
        }
    });
}

std::vector<int> from_one(const std::vector<int>& cylinders) {
    std::vector<int> list;
    for (const int cylinder : cylinders) {
        list.push_back(cylinder + 1);
    }
    return list;
}

}  // namespace

void visit_columns(ResultVisitor& visitor, const WeighIn& sheet) {
    for (const Part part : all_parts) {
        const PartColumn& column = sheet[part];
        const auto found = statistics(column);
        if (!found) {
            continue;
        }
        visitor.object({part_word(part).word, part_word(part).label, 0, {}, units::none}, [&] {
            visitor.number({"mean_g", Text::tr("Mean"), 2}, found->mean);
            visitor.number(key::spread, found->spread);
            visitor.integer({"heaviest_cylinder", Text::tr("Heaviest, cylinder")},
                            found->heaviest + 1);
            visitor.integer({"lightest_cylinder", Text::tr("Lightest, cylinder")},
                            found->lightest + 1);
            visitor.flag({"within_permitted_spread", Text::tr("Within permitted range")},
                         found->within_permitted);
            if (sheet.is_moved()) {
                visitor.integers({"part_numbers", Text::tr("Part number")},
                                 part_numbers(sheet, part));
            }
            std::vector<double> off;
            for (const Weighed& mass : take_off(column.mass)) {
                off.push_back(mass.value_or(std::numeric_limits<double>::quiet_NaN()));
            }
            visitor.numbers({"take_off_g", Text::tr("Take off"), 2}, off);
            if (column.nominal) {
                visitor.number({"mean_deviation_g", Text::tr("Mean minus nominal"), 2},
                               found->mean - *column.nominal);
            }
        });
    }
}

void visit_matched(ResultVisitor& visitor, const Matched& matched,
                   const std::optional<double>& crank_radius, const std::optional<double>& speed) {
    visitor.integers({"pistons_from_cylinder"}, from_one(matched.pistons));
    visitor.integers({"rods_from_cylinder"}, from_one(matched.rods));
    visitor.integer({"sets_moved", Text::tr("Sets moved")}, matched.moved);
    visitor.word({"goal"}, goal_words[static_cast<std::size_t>(matched.goal)].word);
    visitor.number({"spread_before_g", Text::tr("Range of the crankpins before"), 2},
                   matched.before.spread);
    visitor.number({"spread_g", Text::tr("Range of the crankpins"), 2}, matched.after.spread);
    visitor.flag({"proven", Text::tr("Proven")}, matched.proven);
    if (matched.before.shaking && matched.after.shaking) {
        visit_shaking(visitor, {"shaking_before", Text::tr("Shaking before")},
                      *matched.before.shaking, matched.spacing_known, crank_radius, speed);
        visit_shaking(visitor, {"shaking", Text::tr("Shaking")}, *matched.after.shaking,
                      matched.spacing_known, crank_radius, speed);
    }
    if (!matched.remark.empty()) {
        visitor.text({"remark"}, matched.remark);
    }
}

void visit_other(ResultVisitor& visitor, const std::optional<double>& read_with,
                 const std::optional<OtherShaft>& read_on) {
    if (read_with) {
        visitor.number({"read_with_bobweight_g", Text::tr("Bob weight of the readings"), 1},
                       read_with);
    }
    if (read_on) {
        visitor.word({"read_on"}, read_on->then);
    }
}

Message other_readings(const std::optional<double>& read_with,
                       const std::optional<OtherShaft>& read_on,
                       const std::optional<double>& bob_weight_now) {
    const auto grams = [](double mass) { return Number{mass / units::gram, units::gram, -1}; };
    if (read_on) {
        return {
            Text::tr(
                "The readings are of another crankshaft: number %1 then, %2 now. Measure again."),
            read_on->then, read_on->now};
    }
    if (read_with) {
        return {
            Text::tr(
                "The readings were taken with another bob weight: %1 then, %2 now. Measure again."),
            grams(*read_with), grams(bob_weight_now.value_or(0.0))};
    }
    return {};
}

namespace {

/// With a capital, in English or Russian.
std::string capitalised(std::string name) {
    const auto byte = [&](std::size_t i) {
        return i < name.size() ? static_cast<unsigned char>(name[i]) : 0U;
    };
    if (byte(0) < 0x80U) {
        name[0] = static_cast<char>(std::toupper(static_cast<int>(byte(0))));
    } else if (byte(0) == 0xD0U && byte(1) >= 0xB0U) {
        name[1] = static_cast<char>(byte(1) - 0x20U);  // а to п
    } else if (byte(0) == 0xD1U && byte(1) < 0x90U) {
        name[0] = '\xD0';  // р to я
        name[1] = static_cast<char>(byte(1) + 0x20U);
    }
    return name;
}

}  // namespace

Message plane_title(const std::array<std::string, 2>& own, std::size_t plane) {
    return !own.at(plane).empty() ? Message(capitalised(own[plane]))
           : plane == 0           ? Text::tr("Front plane")
                                  : Text::tr("Rear plane");
}

std::array<Message, 2> plane_names(const std::array<std::string, 2>& own) {
    return {own[0].empty() ? Message(Text::tr("front")) : Message(own[0]),
            own[1].empty() ? Message(Text::tr("rear")) : Message(own[1])};
}

void add_machine_verdict(Verdict& verdict, const std::array<std::optional<double>, 2>& unbalance,
                         const std::optional<std::array<double, 2>>& permissible,
                         const std::array<std::string, 2>& own_names) {
    if (!permissible) {
        return;
    }
    bool is_whole = true;
    bool fails = false;
    std::array<Number, 2> shown{};
    for (std::size_t i = 0; i < 2; ++i) {
        is_whole = is_whole && unbalance[i];
        fails = fails || !is_within(unbalance[i].value_or(0.0), (*permissible)[i]);
        shown[i] = in_gram_millimetres(unbalance[i].value_or(0.0));
    }
    if (!is_whole && !fails) {
        return;
    }
    const std::array<Message, 2> names = plane_names(own_names);
    const Message said{fails ? Text::tr("Fails: %1 %5, %2 %6; permissible %3 and %4.")
                             : Text::tr("Passes: %1 %5, %2 %6; permissible %3 and %4."),
                       unbalance[0] ? Message(shown[0]) : Message("–"),
                       unbalance[1] ? Message(shown[1]) : Message("–"),
                       in_gram_millimetres((*permissible)[0]),
                       in_gram_millimetres((*permissible)[1]),
                       names[0],
                       names[1]};
    verdict.text = verdict.text.empty() ? said : two_sentences(said, verdict.text);
    verdict.severity = fails ? Severity::error : verdict.severity;
}

}  // namespace ravnoves::shop
