#include "shop/job_header.h"

#include "case-file/field_visitor.h"

namespace ravnoves::shop {

void visit_fields(FieldVisitor& visitor, JobHeader& job) {
    visitor.optional_text(field::engine_number, job.engine_number);
    visitor.optional_text(field::crankshaft_number, job.crankshaft_number);
    visitor.optional_text(field::customer, job.customer);
    visitor.optional_text(field::date, job.date);
    visitor.optional_text(field::technician, job.technician);
    visitor.optional_text(field::notes, job.notes);
}

void ReadShaft::note(const JobHeader& before, const JobHeader& now) {
    if (engine_number.empty() && before.engine_number != now.engine_number) {
        engine_number = before.engine_number;
    }
    if (crankshaft_number.empty() && before.crankshaft_number != now.crankshaft_number) {
        crankshaft_number = before.crankshaft_number;
    }
}

void visit_fields(FieldVisitor& visitor, ReadShaft& shaft) {
    visitor.optional_text(field::engine_then, shaft.engine_number);
    visitor.optional_text(field::crankshaft_then, shaft.crankshaft_number);
}

std::optional<OtherShaft> other_shaft(const ReadShaft& read, const JobHeader& now) {
    if (!read.crankshaft_number.empty() && !now.crankshaft_number.empty()) {
        return read.crankshaft_number == now.crankshaft_number
                   ? std::nullopt
                   : std::optional(OtherShaft{read.crankshaft_number, now.crankshaft_number});
    }
    return read.engine_number.empty() || now.engine_number.empty() ||
                   read.engine_number == now.engine_number
               ? std::nullopt
               : std::optional(OtherShaft{read.engine_number, now.engine_number});
}

}  // namespace ravnoves::shop
