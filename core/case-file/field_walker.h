#pragma once

#include "case-file/field_visitor.h"
#include "case-file/object_reader.h"

namespace ravnoves {

/// Common to visitors of a present input: they follow the input, and keep the JSON pointer of the
/// place.
class FieldWalker : public FieldVisitor {
  public:
    explicit FieldWalker(std::string root = "/input") : pointer_(std::move(root)) {}

    int one_of(std::initializer_list<std::string_view> /*keys*/, int present) override {
        return present;
    }
    bool has(std::string_view /*key*/, bool present) override { return present; }
    std::string pointer() const override { return pointer_; }
    std::string pointer_to(std::string_view key) const {
        return pointer_ + "/" + escape_segment(key);
    }
    /// The field at this key is what the pointer points to.
    bool is_at(std::string_view key, std::string_view target) const {
        return pointer_to(key) == target;
    }
    /// What the pointer points to is within the object or list at this key.
    bool is_within(std::string_view key, std::string_view target) const {
        return target.starts_with(pointer_to(key) + "/");
    }

  protected:
    bool begin_object(const Field& field, bool /*required*/, bool is_there) override {
        if (is_there) {
            enter(field.key);
        }
        return is_there;
    }
    void end_object() override { leave(); }
    bool begin_list(const Field& field, std::size_t& /*count*/) override {
        enter(field.key);
        return true;
    }
    void end_list() override { leave(); }
    void begin_element(std::size_t index) override { enter(std::to_string(index)); }
    void end_element() override { leave(); }

  private:
    void enter(std::string_view key) { pointer_ = pointer_to(key); }
    void leave() { pointer_.resize(pointer_.rfind('/')); }

    std::string pointer_;
};

}  // namespace ravnoves
