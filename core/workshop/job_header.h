#pragma once

#include <string>

#include "case-file/field.h"

namespace ravnoves {
class FieldVisitor;
}

namespace ravnoves::workshop {

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

namespace field {

inline constexpr Field job{.key = "job", .hint = CORE_TEXT("V8", "Head of the job card.")};
inline constexpr Field engine_number{.key = "engine_number",
                                     .label = CORE_TEXT("V8", "Engine &number"),
                                     .hint = CORE_TEXT("V8", "The journal finds the job by it.")};
inline constexpr Field crankshaft_number{.key = "crankshaft_number",
                                         .label = CORE_TEXT("V8", "Crankshaft num&ber"),
                                         .hint = CORE_TEXT("V8", "As stamped on the crankshaft.")};
inline constexpr Field customer{
    .key = "customer",
    .label = CORE_TEXT("V8", "C&ustomer"),
    .hint = CORE_TEXT("V8", "Who brought the engine; the journal finds the job by it.")};
inline constexpr Field date{.key = "date",
                            .label = CORE_TEXT("V8", "&Date"),
                            .hint = CORE_TEXT("V8", "Year-month-day or day.month.year.")};
inline constexpr Field technician{.key = "technician",
                                  .label = CORE_TEXT("V8", "&Technician"),
                                  .hint = CORE_TEXT("V8", "Who does the work.")};
inline constexpr Field notes{.key = "notes",
                             .label = CORE_TEXT("V8", "&Notes"),
                             .hint = CORE_TEXT("V8", "Printed on the job card.")};

}  // namespace field
}  // namespace ravnoves::workshop
