#include <algorithm>
#include <array>
#include <map>

#include "case-file/field_index.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

class Writer final : public FieldVisitor {
  public:
    Writer() : FieldVisitor("") {}
    Json take() { return std::move(json_); }

  protected:
    void leaf(const Field& field, const Leaf& leaf) override {
        Json json = std::visit(
            ByKind{[&](const double* si) { return or_usual(*si, leaf, from_si(field, *si)); },
                   [&](const int* value) {
                       return or_usual(
                           *value, leaf,
                           leaf.is_choice ? Json(field.words[index(*value)].word) : Json(*value));
                   },
                   [&](const bool* value) { return or_usual(*value, leaf, *value); },
                   [&](const std::optional<double>* si) {
                       return *si                 ? Json(from_si(field, **si))
                              : leaf.word.empty() ? Json()
                                                  : Json(leaf.word);
                   },
                   [&](const std::string* text) {
                       return leaf.required || !text->empty() ? Json(*text) : Json();
                   },
                   [](CustomValue* value) { return value->write(); },
                   [](const auto* list) { return Json(*list); }},
            leaf.at);
        if (!json.is_null()) {
            put(field.key, std::move(json));
        }
    }
    bool begin_object(const Field& field, bool /*required*/, bool is_there) override {
        if (is_there) {
            put(field.key, object_with_room(16));
        }
        return is_there;
    }
    bool begin_list(const Field& field, std::size_t& /*count*/) override {
        put(field.key, Json::array());
        return true;
    }
    void begin_element(const Field& /*list*/, std::size_t index) override {
        put(std::to_string(index), object_with_room(16));
    }

  private:
    static std::size_t index(int place) { return static_cast<std::size_t>(place); }
    /// What is as usual is left out.
    template <typename Value>
    static Json or_usual(Value value, const Leaf& leaf, Json json) {
        return leaf.always || leaf.usual != Leaf::Usual(value) ? std::move(json) : Json();
    }
    /// In the object or list that is visited now.
    void put(std::string_view key, Json value) {
        json_[Json::json_pointer(pointer_to(key))] = std::move(value);
    }

    Json json_ = object_with_room(32);
};

class Checker final : public FieldVisitor {
  public:
    using FieldVisitor::FieldVisitor;

  protected:
    void leaf(const Field& field, const Leaf& leaf) override {
        const auto number = [&](double value, const auto& place) {
            if (field.left_by(value) != nullptr) {
                check_range(field, value, place());
            }
        };
        const auto whole = [&](int value, const auto& place) {
            if (!field.allows_whole(value)) {
                throw InputError(place(), field.whole_number_rule(), Number{1.0 * value});
            }
        };
        const auto here = [&] { return pointer_to(field.key); };
        const auto each = [&](const auto& list, const auto& check) {
            for (std::size_t i = 0; i < list.size(); ++i) {
                check(list[i], [&] { return here() + "/" + std::to_string(i); });
            }
        };
        std::visit(
            ByKind{[&](const double* si) { number(from_si(field, *si), here); },
                   [&](const std::optional<double>* si) {
                       if (*si) {
                           number(from_si(field, **si), here);
                       }
                   },
                   [&](const int* value) {
                       if (!leaf.is_choice) {
                           whole(*value, here);
                       }
                   },
                   [&](const std::vector<double>* list) { each(*list, number); },
                   [&](const std::vector<int>* list) { each(*list, whole); },
                   [&](CustomValue* value) { value->check(here()); }, [](const auto* /*free*/) {}},
            leaf.at);
    }
};

/// Lists the fields, or sets one.
class Index final : public FieldVisitor {
  public:
    /// @param given  the value that `only` is set to; null where the fields are listed
    Index(bool all, std::string_view only, const FieldValue* given = nullptr)
        : FieldVisitor(""), all_(all), only_(only), given_(given) {
        constexpr std::size_t usual = 48;  // most scenes have fewer fields
        entries_.reserve(only.empty() ? usual : 1);
    }

    std::vector<FieldEntry> take() { return std::move(entries_); }
    bool has_set() const { return has_set_; }

    bool creates_objects() const override { return given_ != nullptr; }
    std::vector<std::string> names(std::vector<std::string> present) override {
        const std::string here = pointer() + "/";
        if (given_ != nullptr && only_.starts_with(here)) {
            std::string name(only_.substr(here.size()));
            if (std::find(present.begin(), present.end(), name) == present.end()) {
                present.push_back(std::move(name));
            }
        }
        return present;
    }
    int one_of(std::initializer_list<std::string_view> keys, int present) override {
        if (all_) {
            for (const std::string_view key : keys) {
                choices_[pointer_to(key)] = {keys.begin(), keys.end()};
            }
        }
        return all_ ? -1 : present;
    }
    bool has(std::string_view /*key*/, bool present) override { return all_ || present; }

  protected:
    void leaf(const Field& field, const Leaf& leaf) override {
        if (!wants(field)) {
            if (auto* const* list = std::get_if<std::vector<double>*>(&leaf.at);
                list != nullptr && leads_on(field)) {
                add_element(field, **list);
            }
            return;
        }
        if (given_ != nullptr) {
            has_set_ = has_set_ || set(field, leaf, *given_);
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
        if (wants(field) && (all_ || !field.label.empty() || !field.hint.empty())) {
            add(field, FieldKind::object).required = required;
        }
        return leads_on(field);
    }
    bool begin_list(const Field& field, std::size_t& count) override {
        if (wants(field)) {
            add(field, FieldKind::list);
        }
        count = all_ ? 1 : count;
        return leads_on(field);
    }

  private:
    /// @return false where the value is of another kind
    static bool set(const Field& field, const Leaf& leaf, const FieldValue& given) {
        bool is_set = true;
        std::visit(
            ByKind{[&](double* si, double number) { *si = number * field.unit; },
                   [&](std::optional<double>* si, double number) { *si = number * field.unit; },
                   [](std::optional<double>* si, std::monostate) { si->reset(); },
                   [&](double* si, std::monostate) {
                       const double* usual = std::get_if<double>(&leaf.usual);
                       is_set = usual != nullptr;
                       *si = is_set ? *usual : *si;
                   },
                   [](int* value, int number) { *value = number; },
                   [](bool* value, bool yes) { *value = yes; },
                   [](std::string* value, const std::string& text) { *value = text; },
                   [&](auto* /*other*/, const auto& /*kind*/) { is_set = false; }},
            leaf.at, given);
        return is_set;
    }
    /// What is asked for may be within this object or list.
    bool leads_on(const Field& field) const {
        return only_.empty() || only_.starts_with(pointer_to(field.key) + "/");
    }
    bool wants(const Field& field) const { return only_.empty() || pointer_to(field.key) == only_; }
    FieldEntry& add(const Field& field, FieldKind kind) {
        FieldEntry entry{.pointer = pointer_to(field.key), .field = field, .kind = kind};
        if (all_) {
            entry.alternatives = choices_[entry.pointer];
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

    bool all_;
    std::string_view only_;
    const FieldValue* given_;
    bool has_set_ = false;
    std::map<std::string, std::vector<std::string>> choices_;  ///< by pointer
    std::vector<FieldEntry> entries_;
};

}  // namespace

Json write_fields(const VisitFields& visit) {
    Writer writer;
    visit(writer);
    return writer.take();
}

void check_fields(const VisitFields& visit, const std::string& root) {
    Checker checker(root);
    visit(checker);
}

std::vector<FieldEntry> list_fields(const VisitFields& visit, bool all, std::string_view only) {
    Index index(all, only);
    visit(index);
    return index.take();
}

bool set_field(const VisitFields& visit, std::string_view pointer, const FieldValue& value) {
    Index setter(false, pointer, &value);
    visit(setter);
    return setter.has_set();
}

}  // namespace ravnoves
