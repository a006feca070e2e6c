#include "case-file/field_walker.h"

#include "case-file/object_reader.h"

namespace ravnoves {

std::string FieldWalker::pointer_to(std::string_view key) const {
    return pointer_ + "/" + escape_segment(key);
}

bool FieldWalker::begin_object(const Field& field, bool /*required*/, bool is_there) {
    if (is_there) {
        enter(field.key);
    }
    return is_there;
}

bool FieldWalker::begin_list(const Field& field, std::size_t& /*count*/) {
    enter(field.key);
    return true;
}

void FieldWalker::enter(std::string_view key) {
    lengths_.push_back(pointer_.size());
    pointer_ += '/';
    pointer_ += escape_segment(key);
}

void FieldWalker::leave() {
    pointer_.resize(lengths_.back());
    lengths_.pop_back();
}

}  // namespace ravnoves
