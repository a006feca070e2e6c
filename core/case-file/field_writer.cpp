#include "case-file/field_writer.h"

#include "case-file/field_walker.h"
#include "case-file/input_error.h"

namespace ravnoves {

namespace {

class Writer final : public FieldWalker {
  public:
    Writer() : FieldWalker("") {}
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
    bool begin_object(const Field& field, bool required, bool is_there) override {
        if (is_there) {
            put(field.key, object_with_room(16));
        }
        return FieldWalker::begin_object(field, required, is_there);
    }
    bool begin_list(const Field& field, std::size_t& count) override {
        put(field.key, Json::array());
        return FieldWalker::begin_list(field, count);
    }
    void begin_element(std::size_t index) override {
        put(std::to_string(index), object_with_room(16));
        FieldWalker::begin_element(index);
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

class Checker final : public FieldWalker {
  public:
    using FieldWalker::FieldWalker;

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

}  // namespace ravnoves
