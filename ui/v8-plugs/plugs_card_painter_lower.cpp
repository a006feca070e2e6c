// The lower half of the job card: weights of the parts, remarks, notes, machine, signatures.

#include <algorithm>
#include <cmath>

#include "shop/balance_grade.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/plugs_card_painter.h"
#include "workshop/card_blocks.h"
#include "workshop/model/verdict.h"

namespace ravnoves {

using namespace v8_plugs;

/// The weights of the parts, and which set goes to which cylinder, under the same columns.
double PlugsCardPainter::weighIn(double y) {
    if (!input_.weigh_in || input_.weigh_in->is_empty()) {
        return y - 2.2;  // no section, no gap
    }
    sheet_.heading(
        left, y, full,
        words_.translate("JobCard", "Weights of the parts by cylinder, %1").arg(unitGram()));
    constexpr double nameWidth = 34.0;
    constexpr double numberWidth = 13.0;
    std::vector<CardTable::Column> columns{{nameWidth, Qt::AlignLeft}, {numberWidth}};
    for (int i = 0; i < cylinder_count; ++i) {
        columns.push_back({(full - nameWidth - 3 * numberWidth) / cylinder_count});
    }
    columns.insert(columns.end(), 2, {numberWidth});
    constexpr double rowHeight = 3.2;
    CardTable table(columns, 7.2, rowHeight);
    QStringList head{words_.translate("JobCard", "Cylinder"),
                     words_.translate("JobCard", "nominal")};
    for (int i = 1; i <= cylinder_count; ++i) {
        head << QString::number(i);
    }
    head << words_.translate("JobCard", "mean") << words_.translate("JobCard", "spread");
    table.head(head);
    for (const Part part : all_parts) {
        const PartColumn& column = (*input_.weigh_in)[part];
        const auto found = statistics(column);
        if (!found) {
            continue;
        }
        QStringList row{v8_names::partName(words_, part),
                        column.nominal ? grams(*column.nominal) : missing};
        for (const auto& mass : column.mass) {
            row << (mass ? grams(*mass) : missing);
        }
        row << grams(found->mean)
            << grams(found->spread) + (found->within_permitted ? QString() : QStringLiteral(" !"));
        table.add({row});
        if (!found->within_permitted) {
            QStringList less{words_.translate("JobCard", "take off"), QString()};
            less << matching_text::takeOff(words_, masses_of(*input_.weigh_in), part).texts();
            table.add({less, false, true});
        }
    }
    const QString again = v8_text::weighAgain(words_, input_);
    const auto* assignment =
        solution_.assignment && again.isEmpty() ? &*solution_.assignment : nullptr;
    if (assignment != nullptr || input_.weigh_in->is_moved()) {
        for (ResultRow& row : matching_text::setsOfCylinders(words_, input_.weigh_in->piston_sets,
                                                             input_.weigh_in->rod_sets,
                                                             cylinder_count, assignment)) {
            row.insert(1, QString());  // under the nominal masses
            table.add({row.texts(), true, true});
        }
    }
    double height = 5.0 + table.draw(sheet_, left, y + 5.0);
    const auto say = [&](const QString& text, const QColor& colour) {
        if (!text.isEmpty()) {
            height +=
                0.3 + sheet_.paragraph(left, y + height + 0.3, full, text, 7.5, false, colour);
        }
    };
    say(again, CardPage::amber);
    if (const auto shown = v8_text::matchingShown(input_, solution_)) {
        const QString summary =
            (shown->matched.moved > 0
                 ? words_.translate("JobCard", "Sets as suggested, not applied yet.") +
                       QLatin1Char(' ')
                 : QString()) +
            matching_text::summary(words_, *shown);
        const bool isFelt = shown->matched.goal == shop::MatchingGoal::least_shaking;
        const QString felt = isFelt ? matching_text::felt(words_, *shown) : QString();
        const QString both = (summary + QLatin1Char(' ') + felt).trimmed();
        const bool fits = sheet_.textWidth(both, 7.5) < full;
        say(fits ? both : summary, CardPage::ink);
        say(fits ? QString() : felt, CardPage::ink);
    }
    const QString notCounted = v8_text::notCounted(words_, input_).join(QLatin1Char(' '));
    if (sheet_.textWidth(notCounted, 7.5) < 0.6 * full) {
        // Beside the heading: a full card has no line to spare.
        sheet_.text(left + 0.4 * full, y + 0.6, 0.6 * full, notCounted, 7.5, Qt::AlignRight, false,
                    CardPage::amber);
    } else {
        say(notCounted, CardPage::amber);
    }
    return y + height;
}

/// What the technician should not overlook, and what the method neglects.
std::array<QString, 2> PlugsCardPainter::remarkTexts() const {
    Input shown = input_;
    shown.weigh_in.reset();  // its table above marks what is too far apart or missing
    shown.changes_from_weigh_in = false;
    QStringList doubts;
    if (!solution_.advice || !v8_text::doubtsWeights(input_)) {  // else the answer says them
        doubts = v8_text::massTroubles(words_, input_);
    }
    QStringList troubles = v8_text::troubles(words_, shown, solution_);
    for (const QString& each : v8_text::massTroubles(words_, shown)) {
        troubles.removeAll(each);
    }
    // The answer itself says these.
    const QString warning = v8_text::shiftWarning(words_, input_, solution_);
    for (const QString& said : {warning, v8_text::otherReadings(words_, solution_)}) {
        troubles.removeAll(said);
    }
    QString rest;
    if (warning.isEmpty()) {
        rest = v8_text::shiftText(words_, input_, solution_);
    }
    if (!otherRefused_.isEmpty()) {
        troubles << otherRefused_;
    }
    return {(doubts + troubles).join(QLatin1Char(' ')), rest};
}

double PlugsCardPainter::heightOfRemarks(double points) const {
    const auto [doubts, rest] = remarkTexts();
    return sheet_.heightOf(doubts, points, full) + sheet_.heightOf(rest, points, full);
}

double PlugsCardPainter::remarks(double y, double points) {
    const auto [doubts, rest] = remarkTexts();
    return sheet_.flow(sheet_.flow(y, doubts, points, CardPage::amber), rest, points);
}

double PlugsCardPainter::machine(double y) {
    sheet_.heading(left, y, full, words_.translate("JobCard", "Balancing machine"));
    QString limits;
    if (solution_.balancing && input_.balancing) {
        const BalancingCheck check = input_.balancing->check().value();
        limits = words_.translate("JobCard", "ISO 21940-11, G %1, %2 at %3: Uₚₑᵣ = %4 in all.")
                     .arg(words_.plain(check.grade / units::mm_per_s, 2),
                          words_.plainWithUnit(check.rotor_mass, shop::field::rotor_mass, 2),
                          words_.plainWithUnit(check.service_speed, units::rpm, 0),
                          v8_text::gramMillimetres(words_, solution_.balancing->permissible));
    } else {
        limits = words_.translate("JobCard", "ISO 21940-11: no grade, mass and speed given.");
    }
    y += 5.0;
    y += sheet_.paragraph(left, y, full, limits, 7.5);
    y += sheet_.paragraph(left, y, full, v8_text::machineLimits(words_, input_, solution_), 6.5,
                          false, CardPage::grey);
    CardTable table({{44, Qt::AlignLeft},
                     {38},
                     {38, Qt::AlignHCenter},
                     {31, Qt::AlignHCenter},
                     {31, Qt::AlignHCenter}},
                    8, 4.8);
    table.head({words_.translate("JobCard", "Correction plane"),
                words_.translate("JobCard", "permissible, %1").arg(unitUnbalance()),
                words_.translate("JobCard", "reading, %1").arg(unitUnbalance()),
                words_.translate("JobCard", "angle, °"), words_.translate("JobCard", "verdict")});
    const auto row = [&](const QString& name, const PlaneVerdict& plane) {
        table.add(
            {{name, words_.digits(plane.permissible, units::gram_mm, 1),
              plane.reading ? words_.digits(*plane.reading, units::gram_mm, 1) : byHand, byHand,
              plane.passes ? verdictText(words_, readWord(solution_, plane.passes)) : byHand}});
    };
    row(words_.translate("JobCard", "Front (pulley)"), solution_.planes[0]);
    row(words_.translate("JobCard", "Rear (flywheel)"), solution_.planes[1]);
    return y + table.draw(sheet_, left, y);
}

}  // namespace ravnoves
