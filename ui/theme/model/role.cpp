#include "theme/model/role.h"

#include <array>

namespace ravnoves {

namespace {

constexpr std::array looks{
    RoleLook{Role::Engine, "engine", 0, Qt::DashLine, Marker::Square},
    RoleLook{Role::Shaft, "shaft", 1, Qt::DashDotLine, Marker::Triangle},
    RoleLook{Role::Sum, "sum", 2},
    RoleLook{Role::Reciprocating, "reciprocating", 3, Qt::DashDotLine},
    RoleLook{Role::Rotating, "rotating", 5},
    RoleLook{Role::RotatingMoment, "rotating-moment", 7, Qt::DashLine},
    RoleLook{Role::CrankWeight, "crank-weight", 4},
    RoleLook{Role::RearWeight, "rear-weight", 6, Qt::DashLine},
    RoleLook{Role::ShaftWeight, "shaft-weight", 1, Qt::DashDotLine, Marker::Triangle},
    RoleLook{Role::Gas, "gas", 7},
    RoleLook{Role::Offset, "offset", 5, Qt::DotLine},
    RoleLook{Role::FirstOrder, "first-order", 2},
    RoleLook{Role::SecondOrder, "second-order", 1, Qt::DashLine},
    RoleLook{Role::AllOrders, "all-orders", 4, Qt::DotLine},
    RoleLook{Role::Residual, "residual", 3, Qt::DashDotLine},
    RoleLook{Role::Exact, "exact", 2},
    RoleLook{Role::TwoTerm, "two-term", 1, Qt::DashLine},
    RoleLook{Role::Vertical, "vertical", 2},
    RoleLook{Role::Horizontal, "horizontal", 1, Qt::DashLine},
    // Dashes over the exact ones: where both agree each is seen.
    RoleLook{Role::TwoTermVertical, "two-term-vertical", 6, Qt::DashLine},
    RoleLook{Role::TwoTermHorizontal, "two-term-horizontal", 7, Qt::DotLine},
    RoleLook{Role::ResidualVertical, "residual-vertical", 3, Qt::DashDotLine},
    RoleLook{Role::ResidualHorizontal, "residual-horizontal", 4, Qt::DashDotDotLine},
    RoleLook{Role::Roll, "roll", 0},
    RoleLook{Role::ResidualRoll, "residual-roll", 5, Qt::DotLine},
    RoleLook{Role::Hinge, "hinge", 4},
    RoleLook{Role::Compressed, "compressed", 2},
    RoleLook{Role::Stretched, "stretched", 1, Qt::DashLine},
    RoleLook{Role::Profile, "profile", 3, Qt::DashDotLine},
    RoleLook{Role::Value, "value", 2},
    RoleLook{Role::Range, "range", 2, Qt::SolidLine, Marker::Diamond},
    RoleLook{Role::Rms, "rms", 3, Qt::DashLine},
    RoleLook{Role::OtherQuantity, "other-quantity", 4, Qt::DashDotLine},
    RoleLook{Role::Part, "part", 1, Qt::DashDotLine},
    RoleLook{Role::Comparison, "comparison", 7, Qt::DashLine},
    RoleLook{Role::Case, "case", 7},
    RoleLook{Role::Best, "best", 7, Qt::SolidLine, Marker::Triangle},
    RoleLook{Role::Neutral, "neutral", 0},
    RoleLook{Role::Present, "present", RoleLook::Accent, Qt::DashLine, Marker::Diamond},
    RoleLook{Role::Limit, "limit", RoleLook::Muted, Qt::DotLine},
    RoleLook{Role::Forbidden, "forbidden", RoleLook::Error},
    RoleLook{Role::Series, "series", 2},
};

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < looks.size(); ++i) {
        if (looks[i].role != static_cast<Role>(i)) {
            return false;
        }
    }
    return true;
}
static_assert(isInOrder() && looks.back().role == Role::Series);

}  // namespace

std::span<const RoleLook> roleLooks() {
    return looks;
}

RoleLook lookOf(Role role) {
    const auto i = static_cast<std::size_t>(role);
    if (i < looks.size()) {
        return looks[i];
    }
    constexpr std::array inks{2, 1, 3, 4, 0, 6, 5, 7};
    constexpr std::array pens{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DotLine,
                              Qt::DashDotDotLine};
    constexpr std::array markers{Marker::Disc, Marker::Square, Marker::Diamond, Marker::Triangle};
    const std::size_t next = i + 1 - looks.size();
    return {role, looks.back().word, inks[next % inks.size()], pens[next % pens.size()],
            markers[next % markers.size()]};
}

}  // namespace ravnoves
