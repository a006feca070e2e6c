#include "case-file/field_index.h"

#include <algorithm>
#include <array>

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

  protected:
    void leaf(const Field& field, const Leaf& leaf) override {
        if (!wants(field)) {
            if (auto* const* list = std::get_if<std::vector<double>*>(&leaf.at);
                list != nullptr && !only_.empty() && is_within(field.key, only_)) {
                add_element(field, **list);
            }
            return;
        }
        FieldEntry& entry = add(field, kind_of(leaf));
        entry.required = leaf.required && !leaf.is_list();
        entry.word = leaf.word;
        const auto shown = ByKind{[&](double si) { return FieldValue(from_si(field, si)); },
                                  [](std::monostate nothing) { return FieldValue(nothing); },
                                  [](auto value) { return FieldValue(value); }};
        entry.usual = std::visit(shown, leaf.usual);
        entry.may_be_empty = std::holds_alternative<double>(leaf.usual);
        std::visit(
            ByKind{[&](double* si) {
                       entry.value = shown(*si);
                       entry.place = si;
                   },
                   [&](std::optional<double>* si) {
                       entry.may_be_empty = true;
                       if (*si) {
                           entry.value = shown(**si);
                           entry.place = &**si;
                       }
                   },
                   [](const auto* /*more*/) {}, [&](const int* value) { entry.value = *value; },
                   [&](const bool* value) { entry.value = *value; },
                   [&](const std::string* value) { entry.value = *value; }},
            leaf.at);
        entry.place_unit = field.unit;
    }
    bool begin_object(const Field& field, bool required, bool /*is_there*/) override {
        if (all_ || !field.label.empty() || !field.hint.empty()) {
            add(field, FieldKind::object).required = required;
        }
        return leads_on(field) && FieldWalker::begin_object(field, required, true);
    }
    bool begin_list(const Field& field, std::size_t& count) override {
        add(field, FieldKind::list);
        if (all_) {
            count = 1;
        }
        return leads_on(field) && FieldWalker::begin_list(field, count);
    }

  private:
    /// What is asked for may be within this object or list.
    bool leads_on(const Field& field) const { return only_.empty() || is_within(field.key, only_); }
    bool wants(const Field& field) const { return only_.empty() || is_at(field.key, only_); }
    FieldEntry& add(const Field& field, FieldKind kind) {
        if (!wants(field)) {
            return passed_;
        }
        FieldEntry entry{.pointer = pointer_to(field.key), .field = field, .kind = kind};
        for (const Choice& choice : choices_) {
            if (choice.pointer == entry.pointer) {
                entry.alternatives = choice.keys;
            }
        }
        return entries_.emplace_back(std::move(entry));
    }
    void add_element(const Field& field, std::vector<double>& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (only_ == pointer_to(field.key) + "/" + std::to_string(i)) {
                entries_.push_back({.pointer = std::string(only_),
                                    .field = field,
                                    .value = list[i],
                                    .required = true,
                                    .place = &list[i]});
            }
        }
    }
    static FieldKind kind_of(const Leaf& leaf) {
        constexpr std::array kinds{FieldKind::number, FieldKind::number, FieldKind::integer,
                                   FieldKind::flag,   FieldKind::text,   FieldKind::list,
                                   FieldKind::list,   FieldKind::custom};  // as Leaf::at
        return leaf.is_choice ? FieldKind::choice : kinds.at(leaf.at.index());
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
    void leaf(const Field& field, const Leaf& leaf) override {
        if (done_ || !is_at(field.key, target_)) {
            return;
        }
        done_ = true;
        std::visit(
            ByKind{[&](double* si, double number) { *si = number * field.unit; },
                   [&](std::optional<double>* si, double number) { *si = number * field.unit; },
                   [](std::optional<double>* si, std::monostate) { si->reset(); },
                   [&](double* si, std::monostate) {
                       const double* usual = std::get_if<double>(&leaf.usual);
                       done_ = usual != nullptr;
                       *si = done_ ? *usual : *si;
                   },
                   [](int* value, int given) { *value = given; },
                   [](bool* value, bool given) { *value = given; },
                   [](std::string* value, const std::string& given) { *value = given; },
                   [&](auto* /*other*/, const auto& /*kind*/) { done_ = false; }},
            leaf.at, value_);
    }
    bool begin_object(const Field& field, bool required, bool /*is_there*/) override {
        return is_within(field.key, target_) && FieldWalker::begin_object(field, required, true);
    }

  private:
    std::string_view target_;
    const FieldValue& value_;
    bool done_ = false;
};

}  // namespace

std::vector<FieldEntry> list_fields(const VisitFields& visit, bool all, std::string_view only) {
    Index index(all, only);
    visit(index);
    return index.take();
}

bool set_field(const VisitFields& visit, std::string_view pointer, const FieldValue& value) {
    Setter setter(pointer, value);
    visit(setter);
    return setter.done();
}

}  // namespace ravnoves
