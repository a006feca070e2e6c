#include "shop/model/matching_text.h"

#include "shop/kilograms.h"
#include "text/capital.h"

namespace ravnoves::matching_text {

using namespace shop;

namespace {

const QString dot = QStringLiteral("·");

ResultCell gramsOf(const Words& words, double mass) {
    return words.cellWithUnit(mass, units::gram, 2);
}

/// The force as an unbalance, or as a mass at the crank radius while that is not known.
ResultCell forceOf(const Words& words, const Shown& shown, double force) {
    return shown.crank_radius ? words.cellWithUnit(force * *shown.crank_radius, units::gram_mm, 1)
                              : gramsOf(words, force);
}

/// The couple likewise, as a mass at the crank radius times a distance.
ResultCell coupleOf(const Words& words, const Shown& shown, double couple) {
    if (shown.crank_radius) {
        return words.cellWithUnit(couple * *shown.crank_radius, units::gram_mm2, 0);
    }
    // No unbalance, so not in the unit chosen for those.
    ResultCell cell = words.cell(couple / units::mm, units::gram, 1);
    cell.text += QStringLiteral(" ") + words.unit(units::gram) + QStringLiteral(" × ") +
                 words.unit(units::mm);
    return cell;
}

/// What the numbers in newtons are times.
std::optional<double> newtonsPerMass(const Shown& shown) {
    return shown.crank_radius && shown.speed
               ? std::optional(*shown.crank_radius * *shown.speed * *shown.speed)
               : std::nullopt;
}

}  // namespace

QString summary(const Words& words, const Shown& shown) {
    const Matched& matched = shown.matched;
    const bool isMoved = shown.is_moved();
    const QString before = gramsOf(words, matched.before.spread);
    if (matched.moved == 0 && isMoved) {
        return words
            .translate("Matching",
                       "Assemble by set numbers: the range of the crankpins is then %1.")
            .arg(before);
    }
    if (matched.moved == 0 && matched.remark.empty() && matched.proven) {
        return words
            .translate("Matching", "The parts are placed optimally: range of the crankpins %1.")
            .arg(before);
    }
    if (matched.moved == 0) {
        return words.translate("Matching", "Parts not moved: range of the crankpins %1.")
            .arg(before);
    }
    if (isMoved || shown.is_origin_unknown) {
        return words
            .translate("Matching", "Range of the crankpins: %1 now, %2 after moving %3 more sets.")
            .arg(before, gramsOf(words, matched.after.spread), QString::number(matched.moved));
    }
    return words
        .translate("Matching", "Range of the crankpins: %1 as weighed, %2 after moving %3 sets.")
        .arg(before, gramsOf(words, matched.after.spread), QString::number(matched.moved));
}

QStringList remarks(const Words& words, const Shown& shown) {
    const Matched& matched = shown.matched;
    QStringList list;
    if (!matched.remark.empty()) {
        list << words.message(matched.remark);
    }
    const bool byShaking = matched.goal == MatchingGoal::min_shaking;
    if (!matched.proven) {
        list << words.translate("Matching",
                                "Too many combinations to try all: this is the best found.");
    }
    if (byShaking) {
        QStringList angles;
        for (const double angle : shown.crank.angles) {
            angles << words.plain(angle / degree, 1) + QStringLiteral("°");
        }
        list << words.translate("Matching", "Throws from the front at %1.")
                    .arg(angles.join(QStringLiteral("; ")));
        if (!matched.spacing_known) {
            list << words.translate(
                "Matching", "The couple is included; enter the cylinder spacing to see its value.");
        }
    }
    return list;
}

Results effects(const Words& words, const Shown& shown) {
    const Matched& matched = shown.matched;
    Results results{
        {words.translate("Matching", "Difference"),
         shown.is_origin_unknown ? words.translate("Matching", "now")
                                 : words.translate("Matching", "as weighed"),
         words.translate("Matching", "proposed")},
        {{{words.translate("Matching", "Crankpins, range"),
           gramsOf(words, matched.as_weighed.spread), gramsOf(words, matched.after.spread)},
          words.translate("Matching", "Heaviest minus lightest crankpin, by bob weight")}}};
    ResultRows& rows = results.rows;
    if (!matched.as_weighed.shaking || !matched.after.shaking) {
        return results;
    }
    const Shaking before = *matched.as_weighed.shaking;
    const Shaking& after = *matched.after.shaking;
    const auto newtons = newtonsPerMass(shown);
    const QString speed =
        shown.speed ? words.plainWithUnit(*shown.speed, units::rpm, 0) : QString();
    rows << ResultRow(
        {shown.crank_radius ? words.translate("Matching", "Unbalance")
                            : words.translate("Matching", "Unbalance at the crank radius"),
         forceOf(words, shown, before.force), forceOf(words, shown, after.force)},
        words.translate("Matching",
                        "First-order unbalance due to deviations from the mean mass, maximum over "
                        "a turn; the unbalance of the layout itself is not included"));
    if (newtons) {
        rows << ResultRow{words.translate("Matching", "Force at %1").arg(speed),
                          words.cellWithUnit(before.force * *newtons, units::newton, 2),
                          words.cellWithUnit(after.force * *newtons, units::newton, 2)};
    }
    if (matched.spacing_known) {
        rows << ResultRow(
            {shown.crank_radius ? words.translate("Matching", "Couple")
                                : words.translate("Matching", "Couple at the crank radius"),
             coupleOf(words, shown, before.couple), coupleOf(words, shown, after.couple)},
            words.translate("Matching", "Couple along the crankshaft, about its middle"));
        if (newtons) {
            rows << ResultRow{words.translate("Matching", "Couple at %1").arg(speed),
                              words.cellWithUnit(before.couple * *newtons, units::N_m, 3),
                              words.cellWithUnit(after.couple * *newtons, units::N_m, 3)};
        }
    }
    rows << ResultRow({words.translate("Matching", "At the ends, mean"),
                       forceOf(words, shown, before.ends), forceOf(words, shown, after.ends)},
                      words.translate("Matching",
                                      "RMS of force and couple over a turn, at both end cylinders; "
                                      "“Minimum shaking” minimises it"));
    return results;
}

namespace {

/// The first heading, then the numbers from 1 on.
ResultColumns numbered(const ResultColumn& first, std::size_t count) {
    ResultColumns columns{first};
    for (std::size_t i = 1; i <= count; ++i) {
        columns.push_back(QString::number(i));
    }
    return columns;
}

}  // namespace

Results assignment(const Words& words, const Shown& shown) {
    const auto row = [](const QString& name, const SetNumbers& numbers,
                        const std::vector<int>& from, const QString& tip) {
        ResultRow cells({name}, tip);
        for (const int number : whole_numbers(moved_numbers(numbers, from), from.size())) {
            // A set that stays where it was weighed needs no number.
            const bool stays = number == static_cast<int>(cells.size());
            cells << (stays ? dot : QString::number(number));
        }
        return cells;
    };
    const ResultColumn first(
        words.translate("Matching", "Cylinder"),
        words.translate("Matching", "Dot: the part is not moved; number: its previous cylinder"));
    return {
        numbered(first, shown.matched.pistons.size()),
        {row(words.translate("JobCard", "Piston set from"), shown.piston_sets,
             shown.matched.pistons, words.translate("Matching", "Previous cylinder of the piston")),
         row(words.translate("JobCard", "Rod set from"), shown.rod_sets, shown.matched.rods,
             words.translate("Matching", "Previous cylinder of the rod"))}};
}

QString weighAgain(const Words& words, const WeighIn& sheet) {
    QStringList parts;
    const auto swapped =
        swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass);
    for (const Part part : all_parts) {
        if (!swapped.empty() && (part == Part::rod_big_end || part == Part::rod_small_end)) {
            continue;  // whole rods are named below
        }
        if (const auto odd = odd_mass(sheet[part].nominal, sheet[part].mass)) {
            for (const std::size_t cylinder : odd->cylinders()) {
                parts << words.translate("Workshop", "%1 of cylinder %2")
                             .arg(inSentence(words.text(part_word(part).label)))
                             .arg(cylinder + 1);
            }
        }
    }
    for (const std::size_t cylinder : swapped) {
        parts << words.translate("Workshop", "rod of cylinder %1").arg(cylinder + 1);
    }
    return parts.isEmpty() ? QString()
                           : words.translate("Workshop", "Weigh again first: %1.")
                                 .arg(parts.join(QStringLiteral("; ")));
}

Results takeOff(const Words& words, WeighIn sheet) {
    const bool isMoved = sheet.is_moved();
    if (isMoved) {
        move_back(sheet);  // the number of a part is that of the cylinder that it was weighed in
    }
    const bool areSwapped =
        !swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass).empty();
    Results results{numbered(
        isMoved ? words.translate("Matching", "Part no.") : words.translate("Matching", "Cylinder"),
        sheet.columns.front().mass.size())};
    for (const Part part : all_parts) {
        const bool isRod = part == Part::rod_big_end || part == Part::rod_small_end;
        if (odd_mass(std::nullopt, sheet[part].mass) || (isRod && areSwapped)) {
            continue;
        }
        constexpr double nothing = 0.005 * units::gram;  // of what a scale reads
        ResultRow cells{words.text(part_word(part).label)};
        bool differs = false;
        for (const Weighed& mass : take_off(sheet[part].mass)) {
            const bool isMore = mass && *mass > nothing;
            differs = differs || isMore;
            cells << (isMore ? words.cell(*mass, units::gram, 2)
                      : mass ? ResultCell(dot)
                             : ResultCell());
        }
        if (differs) {
            results.rows << cells;
        }
    }
    return results;
}

}  // namespace ravnoves::matching_text
