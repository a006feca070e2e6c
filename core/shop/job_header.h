#pragma once

#include <optional>
#include <string>

#include "case-file/field.h"

namespace ravnoves {
class FieldVisitor;
}

namespace ravnoves::shop {

/// The head of the job card.
struct JobHeader {
    std::string engine_number;
    std::string crankshaft_number;
    std::string customer;
    std::string date;  ///< ISO 8601, "2024-05-31"
    std::string technician;
    std::string notes;

    friend bool operator==(const JobHeader&, const JobHeader&) = default;
};

void visit_fields(FieldVisitor& visitor, JobHeader& job);

/// The crankshaft of the balancing machine's readings; empty for the crankshaft of the card's head.
/// It is noted when the head becomes another crankshaft's.
struct ReadShaft {
    std::string engine_number;
    std::string crankshaft_number;

    /// The head has changed: readings that do not say it yet are of the one before, if that had
    /// another number.
    void note(const JobHeader& before, const JobHeader& now);

    friend bool operator==(const ReadShaft&, const ReadShaft&) = default;
};

void visit_fields(FieldVisitor& visitor, ReadShaft& shaft);

/// What the readings are of and what the card is of, by their numbers.
struct OtherShaft {
    std::string then;
    std::string now;
};
/// Nothing where both may be the same crankshaft: a number that is not known is no other, and one
/// crankshaft may come into another engine.
std::optional<OtherShaft> other_shaft(const ReadShaft& read, const JobHeader& now);

namespace field {

inline constexpr Field job{.key = "job", .hint = Text::tr("Head of the job card.")};
inline constexpr Field engine_number{.key = "engine_number",
                                     .label = Text::tr("Engine &number"),
                                     .hint = Text::tr("The journal finds the job by this number.")};
inline constexpr Field crankshaft_number{.key = "crankshaft_number",
                                         .label = Text::tr("Crankshaft num&ber"),
                                         .hint = Text::tr("Number stamped on the crankshaft.")};
inline constexpr Field read_shaft{
    .key = "read_of",
    .hint = Text::tr("Engine and crankshaft of the readings, if the job now names others.")};
inline constexpr Field engine_then{.key = "engine_number",
                                   .label = Text::tr("Engine number of the reading"),
                                   .hint = Text::tr("Number of the engine during the reading.")};
inline constexpr Field crankshaft_then{
    .key = "crankshaft_number",
    .label = Text::tr("Crankshaft number of the reading"),
    .hint = Text::tr("Number of the crankshaft during the reading.")};
inline constexpr Field customer{
    .key = "customer",
    .label = Text::tr("C&ustomer"),
    .hint = Text::tr("Owner of the engine; the journal finds the job by this name.")};
inline constexpr Field date{.key = "date",
                            .label = Text::tr("&Date"),
                            .hint = Text::tr("Year-month-day or day.month.year.")};
inline constexpr Field technician{.key = "technician",
                                  .label = Text::tr("&Technician"),
                                  .hint = Text::tr("Name of the technician.")};
inline constexpr Field notes{
    .key = "notes", .label = Text::tr("&Notes"), .hint = Text::tr("Notes on the job card.")};

}  // namespace field
}  // namespace ravnoves::shop
