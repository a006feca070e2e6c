#include "workshop/job_header.h"

#include "case-file/field_visitor.h"

namespace ravnoves::workshop {

void visit_fields(FieldVisitor& visitor, JobHeader& job) {
    visitor.optional_text(field::engine_number, job.engine_number);
    visitor.optional_text(field::crankshaft_number, job.crankshaft_number);
    visitor.optional_text(field::customer, job.customer);
    visitor.optional_text(field::date, job.date);
    visitor.optional_text(field::technician, job.technician);
    visitor.optional_text(field::notes, job.notes);
}

}  // namespace ravnoves::workshop
