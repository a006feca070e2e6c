#include "shop/matching_rules.h"

#include "case-file/field_visitor.h"

namespace ravnoves::shop {

void visit_matching(FieldVisitor& visitor, MatchingRules& rules, bool asks_radius) {
    const MatchingRules usual;
    visitor.object_of(field::matching, false, !(rules == usual), [&] {
        visitor.choice(field::goal, rules.goal, usual.goal);
        visitor.choice(field::piston_moves, rules.pistons, usual.pistons);
        visitor.choice(field::pin_moves, rules.pins, usual.pins);
        visitor.choice(field::ring_moves, rules.rings, usual.rings);
        visitor.choice(field::rod_moves, rules.rods, usual.rods);
        visitor.choice(field::shell_moves, rules.shells, usual.shells);
        visitor.number(field::permitted_crankpin_spread, rules.permitted_spread);
        if (visitor.has(field::crankpin_angles.key, !rules.crankpin_angles_deg.empty())) {
            visitor.numbers(field::crankpin_angles, rules.crankpin_angles_deg);
        }
        visitor.number(field::cylinder_spacing, rules.cylinder_spacing);
        visitor.number(field::bank_offset, rules.bank_offset);
        if (asks_radius) {
            visitor.number(field::matching_crank_radius, rules.crank_radius);
        }
    });
}

}  // namespace ravnoves::shop
