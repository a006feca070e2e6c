#pragma once

#include <optional>

#include "case-file/field_visitor.h"

namespace ravnoves {

/// What visitors of an input that is there share: they go where the input goes, and keep the JSON
/// pointer of the place. By default they pass over every value.
class FieldWalker : public FieldVisitor {
  public:
    explicit FieldWalker(std::string root = "/input") : pointer_(std::move(root)) {}

    void number_or_word(const Field& field, std::optional<double>& si,
                        std::string_view /*word*/) override {
        visit_optional(field, si, true);
    }
    void numbers(const Field& /*field*/, std::vector<double>& /*values*/) override {}
    void integers(const Field& /*field*/, std::vector<int>& /*values*/) override {}
    int one_of(std::initializer_list<std::string_view> /*keys*/, int present) override {
        return present;
    }
    bool has(std::string_view /*key*/, bool present) override { return present; }
    void custom(const Field& /*field*/, bool /*required*/, Custom& /*value*/) override {}
    std::string pointer() const override { return pointer_; }
    std::string pointer_to(std::string_view key) const;
    /// The field at this key is what the pointer points to.
    bool is_at(std::string_view key, std::string_view target) const {
        return beyond(key, target) == "";
    }
    /// What the pointer points to is within the object or list at this key.
    bool is_within(std::string_view key, std::string_view target) const {
        const auto rest = beyond(key, target);
        return rest && rest->starts_with('/');
    }

  protected:
    void visit_number(const Field& /*field*/, double& /*si*/, const double* /*fallback*/,
                      bool /*always*/) override {}
    void visit_optional(const Field& /*field*/, std::optional<double>& /*si*/,
                        bool /*required*/) override {}
    void visit_integer(const Field& /*field*/, int& /*value*/, const int* /*fallback*/,
                       bool /*always*/) override {}
    void visit_flag(const Field& /*field*/, bool& /*value*/, const bool* /*fallback*/,
                    bool /*always*/) override {}
    void visit_text(const Field& /*field*/, std::string& /*value*/, bool /*required*/) override {}
    void visit_choice(const Field& /*field*/, int& /*index*/, const int* /*fallback*/,
                      bool /*always*/) override {}
    bool begin_object(const Field& field, bool required, bool is_there) override;
    void end_object() override { leave(); }
    bool begin_list(const Field& field, std::size_t& count) override;
    void end_list() override { leave(); }
    void begin_element(std::size_t index) override { enter(std::to_string(index)); }
    void end_element() override { leave(); }

  private:
    /// What is left of a pointer that begins with that to this key; nothing where it does not.
    std::optional<std::string_view> beyond(std::string_view key, std::string_view target) const;
    void enter(std::string_view key);
    void leave();

    std::string pointer_;
    std::vector<std::size_t> lengths_;  ///< of the pointer before each step in
};

}  // namespace ravnoves
