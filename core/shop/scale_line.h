#pragma once

#include <string>
#include <string_view>

#include "numerics/units.h"

namespace ravnoves::shop {

// The lines that weighing scales send, without the port that they come from.

/// What one line says.
struct ScaleLine {
    enum class Kind {
        stable,    ///< a weight
        moving,    ///< a weight that has not settled
        overload,  ///< too much on the pan
        underload,
        other,   ///< known, but no weight: a tare, a count, "busy"
        garbled  ///< not understood, or not whole
    };
    /// How much a line says of itself; of one scale all lines have the same form.
    enum class Form { number, number_and_unit, marked };

    Kind kind = Kind::garbled;
    Form form = Form::number;
    double number = 0.0;  ///< as the scale shows it; 0 without one
    int decimals = 0;     ///< that it shows
    Unit unit = units::gram;

    bool has_weight() const { return kind == Kind::stable || kind == Kind::moving; }
    double mass() const { return number * unit; }  ///< kg
    double last_digit() const;                     ///< one in the last place shown, kg
};

/// Reads a line, in any of the common forms:
///
///     S S      123.45 g      MT-SICS: S D while it moves, S I busy, S + and S - over and under
///     ST,+00123.4  g         A&D, CAS, Dini and others: US while it moves, OL too much; with or
///     ST,GS,+  123.4 g       without a word for gross and net
///     N     +  123.45 g      Sartorius: without a unit while it moves
///       123.45 g ?           Ohaus: a question mark while it moves
///     123.45                 a number, with or without a unit
///
/// Decimal point or comma; g, kg, mg, oz and lb, and "г" and "кг" in UTF-8, CP1251 and CP866. A
/// line marked stable has a unit, or it is not whole. Any other line is garbled: half a line never
/// gives another weight than the whole one, but for a bare number.
///
/// @param usual  unit of a number without one
ScaleLine parse_scale_line(std::string_view line, const Unit& usual = units::gram);

/// Cuts what comes from a port into lines, however it comes in pieces: they end in CR, LF or both.
class ScaleLines {
  public:
    void add(std::string_view bytes) { rest_ += bytes; }
    /// Reads the next whole line.
    /// @return false before it is whole
    bool next(std::string& line);
    /// True where a line has begun and has not ended.
    bool is_half() const { return !rest_.empty(); }
    /// Gives up what has begun: the rest of a line that came much too late, or never.
    std::string drop();

    /// No scale's line is as long: what has no end by then is noise, and a line of its own.
    static constexpr std::size_t longest = 120;

  private:
    std::string rest_;
};

/// For a scale that sends all the time: takes each part once, when it is at rest, and the next one
/// after the pan was empty.
class PartByPart {
  public:
    /// True where the line is the weight of a part that was not taken yet.
    bool takes(const ScaleLine& line);

    static constexpr int still = 3;  ///< equal lines that are a weight at rest

  private:
    int equal_ = 0;
    double last_ = 0.0;   // kg
    double taken_ = 0.0;  // kg
    bool loaded_ = false;
};

}  // namespace ravnoves::shop
