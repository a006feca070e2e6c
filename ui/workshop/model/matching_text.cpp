// What page and card say of matched parts: which sets to move, the gain, and what to take off.

#include "bob-weights/matching.h"
#include "shop/kilograms.h"
#include "text/capital.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

using shop::Part;

namespace {

const QString dot = QStringLiteral("·");

ResultCell gramsOf(const Words& words, double mass) {
    return words.cellWithUnit(mass, units::gram, 2);
}

/// The first heading, then the numbers from 1 on.
ResultColumns numbered(const ResultColumn& first, std::size_t count) {
    ResultColumns columns{first};
    for (std::size_t i = 1; i <= count; ++i) {
        columns.push_back(QString::number(i));
    }
    return columns;
}

}  // namespace

bool WorkshopModel::isOriginUnknown() const {
    return input().weigh_in->is_moved() && !canMoveBack();
}

QString WorkshopModel::assignmentText(const Words& words) const {
    if (placing() == nullptr) {
        return weighAgain(words);
    }
    const shop::Matched& matched = *placing();
    const QString before = gramsOf(words, matched.before.spread);
    if (matched.moved == 0 && canMoveBack()) {
        return words
            .translate("Matching",
                       "Assemble by set numbers: the range of the crankpins is then %1.")
            .arg(before);
    }
    if (matched.moved == 0) {
        return (matched.remark.empty() && matched.proven
                    ? words.translate("Matching",
                                      "The parts are placed optimally: range of the crankpins %1.")
                    : words.translate("Matching", "Parts not moved: range of the crankpins %1."))
            .arg(before);
    }
    return (input().weigh_in->is_moved()
                ? words.translate("Matching",
                                  "Range of the crankpins: %1 now, %2 after moving %3 more sets.")
                : words.translate(
                      "Matching",
                      "Range of the crankpins: %1 as weighed, %2 after moving %3 sets."))
        .arg(before, gramsOf(words, matched.after.spread), QString::number(matched.moved));
}

QStringList WorkshopModel::assignmentRemarks() const {
    QStringList list;
    if (placing() == nullptr) {
        return list;
    }
    const Words words;
    const shop::Matched& matched = *placing();
    if (!matched.remark.empty()) {
        list << words.message(matched.remark);
    }
    if (!matched.proven) {
        list << words.translate("Matching",
                                "Too many combinations to try all: this is the best found.");
    }
    if (matched.goal == shop::MatchingGoal::min_shaking) {
        QStringList angles;
        for (const double angle : crank_of(bob_weights::fitted(input())).angles) {
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

Results WorkshopModel::effectResults(const Words& words) const {
    if (placing() == nullptr) {
        return {};
    }
    const shop::Matched& matched = *placing();
    Results results{
        {words.translate("Matching", "Difference"),
         isOriginUnknown() ? words.translate("Matching", "now")
                           : words.translate("Matching", "as weighed"),
         words.translate("Matching", "proposed")},
        {{{words.translate("Matching", "Crankpins, range"),
           gramsOf(words, matched.as_weighed.spread), gramsOf(words, matched.after.spread)},
          words.translate("Matching", "Heaviest minus lightest crankpin, by bob weight")}}};
    ResultRows& rows = results.rows;
    if (!matched.as_weighed.shaking || !matched.after.shaking) {
        return results;
    }
    const shop::Shaking before = *matched.as_weighed.shaking;
    const shop::Shaking& after = *matched.after.shaking;
    const std::optional<double> radius = plugsInput() != nullptr
                                             ? plugsInput()->engine.crank_radius
                                             : input().weigh_in->matching.crank_radius;
    const auto speed = service_speed(input());
    // As unbalances, or as masses at the crank radius while that is not known.
    const auto force = [&](double mass) {
        return radius ? words.cellWithUnit(mass * *radius, units::gram_mm, 1)
                      : gramsOf(words, mass);
    };
    const auto couple = [&](double moment) {
        if (radius) {
            return words.cellWithUnit(moment * *radius, units::gram_mm2, 0);
        }
        // No unbalance, so not in the unit chosen for those.
        ResultCell cell = words.cell(moment / units::mm, units::gram, 1);
        cell.text += QStringLiteral(" ") + words.unit(units::gram) + QStringLiteral(" × ") +
                     words.unit(units::mm);
        return cell;
    };
    const double newtons = radius && speed ? *radius * *speed * *speed : 0.0;
    const QString at = speed ? words.plainWithUnit(*speed, units::rpm, 0) : QString();
    rows << ResultRow(
        {radius ? words.translate("Matching", "Unbalance")
                : words.translate("Matching", "Unbalance at the crank radius"),
         force(before.force), force(after.force)},
        words.translate("Matching",
                        "First-order unbalance due to deviations from the mean mass, maximum over "
                        "a turn; the unbalance of the layout itself is not included"));
    if (newtons > 0.0) {
        rows << ResultRow{words.translate("Matching", "Force at %1").arg(at),
                          words.cellWithUnit(before.force * newtons, units::newton, 2),
                          words.cellWithUnit(after.force * newtons, units::newton, 2)};
    }
    if (matched.spacing_known) {
        rows << ResultRow(
            {radius ? words.translate("Matching", "Couple")
                    : words.translate("Matching", "Couple at the crank radius"),
             couple(before.couple), couple(after.couple)},
            words.translate("Matching", "Couple along the crankshaft, about its middle"));
        if (newtons > 0.0) {
            rows << ResultRow{words.translate("Matching", "Couple at %1").arg(at),
                              words.cellWithUnit(before.couple * newtons, units::N_m, 3),
                              words.cellWithUnit(after.couple * newtons, units::N_m, 3)};
        }
    }
    rows << ResultRow(
        {words.translate("Matching", "At the ends, mean"), force(before.ends), force(after.ends)},
        words.translate("Matching",
                        "RMS of force and couple over a turn, at both end cylinders; "
                        "“Minimum shaking” minimises it"));
    return results;
}

Results WorkshopModel::assignmentResults(const Words& words) const {
    if (placing() == nullptr) {
        return {};
    }
    const shop::Matched& matched = *placing();
    const shop::WeighIn& sheet = *solved().sheet;
    const auto row = [](const QString& name, const shop::SetNumbers& numbers,
                        const std::vector<int>& from, const QString& tip) {
        ResultRow cells({name}, tip);
        for (const int number :
             shop::whole_numbers(shop::moved_numbers(numbers, from), from.size())) {
            // A set that stays where it was weighed needs no number.
            const bool stays = number == static_cast<int>(cells.size());
            cells << (stays ? dot : QString::number(number));
        }
        return cells;
    };
    const ResultColumn first(
        words.translate("Matching", "Cylinder"),
        words.translate("Matching", "Dot: the part is not moved; number: its previous cylinder"));
    return {numbered(first, matched.pistons.size()),
            {row(words.translate("JobCard", "Piston set from"), sheet.piston_sets, matched.pistons,
                 words.translate("Matching", "Previous cylinder of the piston")),
             row(words.translate("JobCard", "Rod set from"), sheet.rod_sets, matched.rods,
                 words.translate("Matching", "Previous cylinder of the rod"))}};
}

QString WorkshopModel::weighAgain(const Words& words) const {
    QStringList parts;
    for (const auto& [part, cylinder] : solved().unlikely) {
        parts << (part ? words.translate("Workshop", "%1 of cylinder %2")
                             .arg(inSentence(words.text(shop::part_word(*part).label)))
                       : words.translate("Workshop", "rod of cylinder %1"))
                     .arg(cylinder + 1);
    }
    return parts.isEmpty() ? QString()
                           : words.translate("Workshop", "Weigh again first: %1.")
                                 .arg(parts.join(QStringLiteral("; ")));
}

Results WorkshopModel::takeOffResults(const Words& words) const {
    if (!solved().sheet) {
        return {};
    }
    shop::WeighIn sheet = *solved().sheet;
    const bool isMoved = sheet.is_moved();
    if (isMoved) {
        move_back(sheet);  // the number of a part is that of the cylinder that it was weighed in
    }
    const bool areSwapped =
        !shop::swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass)
             .empty();
    Results results{numbered(
        isMoved ? words.translate("Matching", "Part no.") : words.translate("Matching", "Cylinder"),
        sheet.columns.front().mass.size())};
    for (const Part part : shop::all_parts) {
        const bool isRod = part == Part::rod_big_end || part == Part::rod_small_end;
        if (shop::odd_mass(sheet[part]) || (isRod && areSwapped)) {
            continue;
        }
        constexpr double nothing = 0.005 * units::gram;  // of what a scale reads
        ResultRow cells{words.text(shop::part_word(part).label)};
        bool differs = false;
        for (const shop::Weighed& mass : shop::take_off(sheet[part].mass)) {
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

}  // namespace ravnoves
