#include "case-file/field_reader.h"

#include <cmath>
#include <deque>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

class FieldReader final : public FieldVisitor {
  public:
    FieldReader(const Json& json, Completeness completeness)
        : is_lenient_(completeness == Completeness::as_is) {
        readers_.emplace_back(json, "/input");
    }

    /// Rejects what no field has asked for.
    void finish() const { readers_.back().finish(); }

    bool is_reading() const override { return true; }
    int one_of(std::initializer_list<std::string_view> keys, int present) override;
    bool has(std::string_view key, bool /*present*/) override { return reader().has(key); }
    std::vector<std::string> names(std::vector<std::string> /*present*/) override {
        return reader().keys();
    }

  protected:
    void leaf(const Field& field, const Leaf& leaf) override {
        if (!reader().has(field.key)) {
            if (leaf.required && (!is_lenient_ || leaf.is_list())) {
                reader().raw(field.key);  // rejects it
            }
            take_usual(leaf);
            return;
        }
        const Json& json = reader().raw(field.key);
        std::visit(ByKind{[&](double* si) { *si = reader().si(field); },
                          [&](std::optional<double>* si) {
                              if (!leaf.word.empty() && json.is_string()) {
                                  check_word(field, leaf.word, json);
                                  si->reset();
                              } else {
                                  *si = reader().si(field);
                              }
                          },
                          [&](int* value) {
                              *value = leaf.is_choice ? reader().choice(field.key, field.words)
                                                      : whole(field, json, place_of(field));
                          },
                          [&](bool* value) {
                              if (!json.is_boolean()) {
                                  throw InputError(place_of(field),
                                                   Text::tr("must be true or false"), show(json));
                              }
                              *value = json.get<bool>();
                          },
                          [&](std::string* value) { *value = reader().text(field.key); },
                          [&](std::vector<double>* values) {
                              *values = reader().numbers(field.key, field.range);
                          },
                          [&](std::vector<int>* values) {
                              values->clear();
                              for (const Json& each : reader().list(field.key)) {
                                  values->push_back(whole(
                                      field, each,
                                      place_of(field) + "/" + std::to_string(values->size())));
                              }
                          },
                          [&](CustomValue* value) { value->read(json, place_of(field)); }},
                   leaf.at);
    }
    bool begin_object(const Field& field, bool required, bool /*is_there*/) override {
        if (!reader().has(field.key) && !(required && !is_lenient_)) {
            return false;
        }
        readers_.push_back(reader().object(field.key));
        return true;
    }
    void end_object() override {
        readers_.back().finish();
        readers_.pop_back();
    }
    bool begin_list(const Field& field, std::size_t& count) override {
        count = reader().list(field.key).size();
        return true;
    }
    void begin_element(const Field& list, std::size_t index) override {
        readers_.emplace_back(reader().list(list.key).at(index),
                              place_of(list) + "/" + std::to_string(index));
    }

  private:
    ObjectReader& reader() { return readers_.back(); }
    std::string place_of(const Field& field) { return reader().pointer_to(field.key); }
    static int whole(const Field& field, const Json& json, const std::string& place) {
        const double number = json.is_number() ? json.get<double>() : std::nan("");
        if (!field.allows_whole(number)) {
            throw InputError(place, field.whole_number_rule(), show(json));
        }
        return static_cast<int>(number);
    }
    void check_word(const Field& field, std::string_view word, const Json& json) {
        if (json != word) {
            throw InputError(place_of(field),
                             {Text::tr("must be a number or %1"), quoted_list({std::string(word)})},
                             show(json));
        }
    }
    static void take_usual(const Leaf& leaf) {
        std::visit(ByKind{[](double* value, double usual) { *value = usual; },
                          [](int* value, int usual) { *value = usual; },
                          [](bool* value, bool usual) { *value = usual; },
                          [](auto* /*value*/, auto /*usual*/) {}},
                   leaf.at, leaf.usual);
    }

    std::deque<ObjectReader> readers_;
    bool is_lenient_;
};

int FieldReader::one_of(std::initializer_list<std::string_view> keys, int present) {
    int found = -1;
    int index = 0;
    std::string_view first;
    for (const std::string_view key : keys) {
        if (reader().has(key)) {
            if (found >= 0) {
                throw InputError(reader().pointer_to(key),
                                 {Text::tr("must be left out if %1 is given"), first});
            }
            found = index;
            first = key;
        }
        ++index;
    }
    if (found < 0 && !is_lenient_) {
        for (const std::string_view key : keys) {
            reader().reject_mistyped(key);
        }
        throw InputError(
            reader().pointer_to(*keys.begin()),
            {Text::tr("is required and missing (or %1)"), *(keys.begin() + keys.size() - 1)});
    }
    return found < 0 ? present : found;
}

}  // namespace

void read_fields(const Json& json, Completeness completeness, const VisitFields& visit) {
    FieldReader reader(json, completeness);
    visit(reader);
    reader.finish();
}

}  // namespace ravnoves
