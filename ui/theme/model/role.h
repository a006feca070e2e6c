#pragma once

#include <Qt>
#include <span>

namespace ravnoves {

/// What a curve, a force or a part of a picture is of. It looks the same wherever it is seen:
/// plots, pictures of mechanisms, figures of the help, report.
enum class Role {
    Engine,  ///< without what balances it
    Shaft,
    Sum,  ///< with what balances it
    Reciprocating,
    Rotating,
    RotatingMoment,
    CrankWeight,
    RearWeight,  ///< a second weight beside the first
    ShaftWeight,
    Gas,
    Offset,
    FirstOrder,
    SecondOrder,
    AllOrders,
    Residual,
    Exact,
    TwoTerm,
    Vertical,
    Horizontal,
    TwoTermVertical,
    TwoTermHorizontal,
    ResidualVertical,
    ResidualHorizontal,
    Roll,
    ResidualRoll,
    Hinge,
    Compressed,
    Stretched,
    Profile,
    Value,  ///< the one curve of a plot
    Range,
    Rms,
    OtherQuantity,  ///< on the right axis
    Part,           ///< of another curve
    Comparison,
    Case,  ///< among curves of other inputs
    Best,
    Neutral,
    Present,
    Limit,
    Forbidden,
    Series,  ///< the first of several of one kind
};

/// The next ones of several of one kind, from 0.
constexpr Role series(int i) {
    return static_cast<Role>(static_cast<int>(Role::Series) + i);
}

enum class Marker { Disc, Square, Diamond, Triangle };

struct RoleLook {
    enum Ink { Muted = -1, Error = -2, Accent = -3 };

    Role role;
    const char* word;  ///< in SVG, as var(--word)
    int ink;           ///< number of Theme::curve(), or an Ink
    Qt::PenStyle pen = Qt::SolidLine;
    Marker marker = Marker::Disc;
};

/// The table: all but those after the first of several.
std::span<const RoleLook> roleLooks();
RoleLook lookOf(Role role);

}  // namespace ravnoves
