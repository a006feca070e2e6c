#include "case-file/field_index.h"

#include <algorithm>

#include "case-file/field_walker.h"

namespace ravnoves {

namespace {

class Index final : public FieldWalker {
  public:
    Index(bool all, std::string_view only) : FieldWalker(""), all_(all), only_(only) {
        constexpr std::size_t usual = 48;  // most scenes have fewer fields
        entries_.reserve(only.empty() ? usual : 1);
    }

    std::vector<FieldEntry> take() { return std::move(entries_); }

    int one_of(std::initializer_list<std::string_view> keys, int present) override {
        if (all_) {
            for (const std::string_view key : keys) {
                choices_.push_back({pointer_to(key), {keys.begin(), keys.end()}});
            }
        }
        return all_ ? -1 : present;
    }
    bool has(std::string_view /*key*/, bool present) override { return all_ || present; }
    void number_or_word(const Field& field, std::optional<double>& si,
                        std::string_view word) override {
        if (wants(field)) {
            visit_optional(field, si, false);
            entries_.back().word = word;
        }
    }
    void numbers(const Field& field, std::vector<double>& /*values*/) override {
        add(field, FieldKind::list, {});
    }
    void integers(const Field& field, std::vector<int>& /*values*/) override {
        add(field, FieldKind::list, {});
    }
    void custom(const Field& field, bool required, Custom& /*value*/) override {
        add(field, FieldKind::custom, {}).required = required;
    }

  protected:
    void visit_number(const Field& field, double& si, const double* fallback,
                      bool /*always*/) override {
        if (!wants(field)) {
            return;
        }
        FieldEntry& entry = add(field, FieldKind::number, from_si(field, si));
        entry.may_be_empty = fallback != nullptr;
        entry.required = fallback == nullptr;
        if (fallback != nullptr) {
            entry.usual = from_si(field, *fallback);
        }
    }
    void visit_optional(const Field& field, std::optional<double>& si, bool required) override {
        if (!wants(field)) {
            return;
        }
        FieldEntry& entry =
            add(field, FieldKind::number, si ? FieldValue(from_si(field, *si)) : FieldValue());
        entry.may_be_empty = true;
        entry.required = required;
    }
    void visit_integer(const Field& field, int& value, const int* fallback,
                       bool /*always*/) override {
        set_usual(add(field, FieldKind::integer, value), fallback);
    }
    void visit_flag(const Field& field, bool& value, const bool* fallback,
                    bool /*always*/) override {
        set_usual(add(field, FieldKind::flag, value), fallback);
    }
    void visit_text(const Field& field, std::string& value, bool required) override {
        add(field, FieldKind::text, value).required = required;
    }
    void visit_choice(const Field& field, int& index, const int* fallback,
                      bool /*always*/) override {
        set_usual(add(field, FieldKind::choice, index), fallback);
    }
    bool begin_object(const Field& field, bool required, bool /*is_there*/) override {
        if (all_ || !field.label.empty() || !field.hint.empty()) {
            add(field, FieldKind::object, {}).required = required;
        }
        return leads_on(field) && FieldWalker::begin_object(field, required, true);
    }
    bool begin_list(const Field& field, std::size_t& count) override {
        add(field, FieldKind::list, {});
        if (all_) {
            count = 1;
        }
        return leads_on(field) && FieldWalker::begin_list(field, count);
    }

  private:
    /// What is asked for may be within this object or list.
    bool leads_on(const Field& field) const {
        return only_.empty() || is_within(field.key, only_);
    }
    bool wants(const Field& field) const { return only_.empty() || is_at(field.key, only_); }
    FieldEntry& add(const Field& field, FieldKind kind, FieldValue value) {
        if (!wants(field)) {
            return passed_;
        }
        FieldEntry entry{pointer_to(field.key), field, kind, false, std::move(value)};
        for (const Choice& choice : choices_) {
            if (choice.pointer == entry.pointer) {
                entry.alternatives = choice.keys;
            }
        }
        return entries_.emplace_back(std::move(entry));
    }
    template <typename Value>
    static void set_usual(FieldEntry& entry, const Value* fallback) {
        entry.required = fallback == nullptr;
        if (fallback != nullptr) {
            entry.usual = *fallback;
        }
    }

    struct Choice {
        std::string pointer;
        std::vector<std::string> keys;
    };
    bool all_;
    std::string_view only_;
    std::vector<Choice> choices_;
    std::vector<FieldEntry> entries_;
    FieldEntry passed_;  ///< one that is not wanted
};

class Setter final : public FieldWalker {
  public:
    Setter(std::string_view target, const FieldValue& value)
        : FieldWalker(""), target_(target), value_(value) {}

    bool done() const { return done_; }
    bool creates_objects() const override { return true; }
    std::vector<std::string> names(std::vector<std::string> present) override {
        const std::string here = pointer() + "/";
        if (target_.starts_with(here)) {
            std::string name(target_.substr(here.size()));
            if (std::find(present.begin(), present.end(), name) == present.end()) {
                present.push_back(std::move(name));
            }
        }
        return present;
    }

  protected:
    void visit_number(const Field& field, double& si, const double* fallback,
                      bool /*always*/) override {
        if (const double* number = wanted<double>(field)) {
            si = *number * field.unit;
        } else if (fallback != nullptr && wanted<std::monostate>(field) != nullptr) {
            si = *fallback;
        }
    }
    void visit_optional(const Field& field, std::optional<double>& si, bool /*required*/) override {
        if (const double* number = wanted<double>(field)) {
            si = *number * field.unit;
        } else if (wanted<std::monostate>(field) != nullptr) {
            si.reset();
        }
    }
    void visit_integer(const Field& field, int& value, const int* /*fallback*/,
                       bool /*always*/) override {
        take(field, value);
    }
    void visit_flag(const Field& field, bool& value, const bool* /*fallback*/,
                    bool /*always*/) override {
        take(field, value);
    }
    void visit_text(const Field& field, std::string& value, bool /*required*/) override {
        take(field, value);
    }
    void visit_choice(const Field& field, int& index, const int* /*fallback*/,
                      bool /*always*/) override {
        take(field, index);
    }
    bool begin_object(const Field& field, bool required, bool /*is_there*/) override {
        return is_within(field.key, target_) && FieldWalker::begin_object(field, required, true);
    }

  private:
    /// The value where it is of this type and meant for this field.
    template <typename Value>
    const Value* wanted(const Field& field) {
        const Value* value = std::get_if<Value>(&value_);
        if (done_ || value == nullptr || !is_at(field.key, target_)) {
            return nullptr;
        }
        done_ = true;
        return value;
    }
    template <typename Value>
    void take(const Field& field, Value& target) {
        if (const Value* value = wanted<Value>(field)) {
            target = *value;
        }
    }

    std::string_view target_;
    const FieldValue& value_;
    bool done_ = false;
};

}  // namespace

namespace detail {

std::vector<FieldEntry> index_with(VisitInput visit, void* input, bool all, std::string_view only) {
    Index index(all, only);
    visit(index, input);
    return index.take();
}

bool set_with(VisitInput visit, void* input, std::string_view pointer, const FieldValue& value) {
    Setter setter(pointer, value);
    visit(setter, input);
    return setter.done();
}

}  // namespace detail

}  // namespace ravnoves
