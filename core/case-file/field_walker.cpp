#include "case-file/field_walker.h"

#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

bool is_plain(std::string_view key) {
    return key.find_first_of("~/") == std::string_view::npos;
}

void add_segment(std::string& pointer, std::string_view key) {
    pointer += '/';
    if (is_plain(key)) {
        pointer += key;
    } else {
        pointer += escape_segment(key);
    }
}

}  // namespace

std::string FieldWalker::pointer_to(std::string_view key) const {
    std::string pointer;
    pointer.reserve(pointer_.size() + 1 + key.size());
    pointer += pointer_;
    add_segment(pointer, key);
    return pointer;
}

std::optional<std::string_view> FieldWalker::beyond(std::string_view key,
                                                    std::string_view target) const {
    if (!is_plain(key)) {
        const std::string place = pointer_to(key);
        return target.starts_with(place) ? std::optional(target.substr(place.size()))
                                         : std::nullopt;
    }
    const std::size_t begin = pointer_.size() + 1;
    if (target.size() < begin + key.size() || target[begin - 1] != '/' ||
        target.substr(begin, key.size()) != key || !target.starts_with(pointer_)) {
        return std::nullopt;
    }
    return target.substr(begin + key.size());
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
    add_segment(pointer_, key);
}

void FieldWalker::leave() {
    pointer_.resize(lengths_.back());
    lengths_.pop_back();
}

}  // namespace ravnoves
