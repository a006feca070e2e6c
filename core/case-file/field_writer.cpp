#include "case-file/field_writer.h"

#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/field_walker.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/whole_number.h"

namespace ravnoves {

namespace {

class Writer final : public FieldWalker {
  public:
    Json take() { return std::move(stack_.front()); }

    void number_or_word(const Field& field, std::optional<double>& si,
                        std::string_view word) override {
        put(field, si ? Json(from_si(field, *si)) : Json(std::string(word)));
    }
    void numbers(const Field& field, std::vector<double>& values) override { put(field, values); }
    void integers(const Field& field, std::vector<int>& values) override { put(field, values); }
    void custom(const Field& field, bool /*required*/, Custom& value) override {
        Json json = value.write();
        if (!json.is_null()) {
            put(field, std::move(json));
        }
    }

  protected:
    void visit_number(const Field& field, double& si, const double* fallback,
                      bool always) override {
        if (always || si != *fallback) {
            put(field, from_si(field, si));
        }
    }
    void visit_optional(const Field& field, std::optional<double>& si, bool /*required*/) override {
        if (si) {
            put(field, from_si(field, *si));
        }
    }
    void visit_integer(const Field& field, int& value, const int* fallback, bool always) override {
        if (always || value != *fallback) {
            put(field, value);
        }
    }
    void visit_flag(const Field& field, bool& value, const bool* fallback, bool always) override {
        if (always || value != *fallback) {
            put(field, value);
        }
    }
    void visit_text(const Field& field, std::string& value, bool required) override {
        if (required || !value.empty()) {
            put(field, value);
        }
    }
    void visit_choice(const Field& field, int& index, const int* fallback, bool always) override {
        if (always || index != *fallback) {
            put(field, std::string(field.words[static_cast<std::size_t>(index)].word));
        }
    }
    bool begin_object(const Field& field, bool required, bool is_there) override {
        if (FieldWalker::begin_object(field, required, is_there)) {
            open(field.key, Json::object());
        }
        return is_there;
    }
    void end_object() override {
        close();
        FieldWalker::end_object();
    }
    bool begin_list(const Field& field, std::size_t& count) override {
        open(field.key, Json::array());
        return FieldWalker::begin_list(field, count);
    }
    void end_list() override {
        close();
        FieldWalker::end_list();
    }
    void begin_element(std::size_t index) override {
        open({}, Json::object());
        FieldWalker::begin_element(index);
    }
    void end_element() override {
        close();
        FieldWalker::end_element();
    }

  private:
    template <typename Value>
    void put(const Field& field, Value&& value) {
        stack_.back()[std::string(field.key)] = std::forward<Value>(value);
    }
    void open(std::string_view key, Json empty) {
        keys_.emplace_back(key);
        stack_.push_back(std::move(empty));
    }
    void close() {
        Json done = std::move(stack_.back());
        stack_.pop_back();
        if (stack_.back().is_array()) {
            stack_.back().push_back(std::move(done));
        } else {
            stack_.back()[keys_.back()] = std::move(done);
        }
        keys_.pop_back();
    }

    std::vector<Json> stack_{Json::object()};
    std::vector<std::string> keys_;
};

class Checker final : public FieldWalker {
  public:
    using FieldWalker::FieldWalker;

    void numbers(const Field& field, std::vector<double>& values) override {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (field.left_by(values[i]) != nullptr) {
                check_range(field, values[i], pointer_to(field.key) + "/" + std::to_string(i));
            }
        }
    }
    void integers(const Field& field, std::vector<int>& values) override {
        for (std::size_t i = 0; i < values.size(); ++i) {
            check_whole(field, values[i], pointer_to(field.key) + "/" + std::to_string(i));
        }
    }
    void custom(const Field& field, bool /*required*/, Custom& value) override {
        value.check(pointer_to(field.key));
    }

  protected:
    void visit_number(const Field& field, double& si, const double* /*fallback*/,
                      bool /*always*/) override {
        check_range(field, from_si(field, si), pointer_to(field.key));
    }
    void visit_optional(const Field& field, std::optional<double>& si, bool /*required*/) override {
        if (si) {
            check_range(field, from_si(field, *si), pointer_to(field.key));
        }
    }
    void visit_integer(const Field& field, int& value, const int* /*fallback*/,
                       bool /*always*/) override {
        check_whole(field, value, pointer_to(field.key));
    }

  private:
    static void check_whole(const Field& field, int value, const std::string& where) {
        if (!allows_whole(field, value)) {
            throw InputError(where, whole_number_rule(field), Number{1.0 * value});
        }
    }
};

}  // namespace

namespace detail {

Json write_with(void (*visit)(FieldVisitor& visitor, const void* input), const void* input) {
    Writer writer;
    visit(writer, input);
    return writer.take();
}

void check_with(void (*visit)(FieldVisitor& visitor, const void* input), const void* input,
                const char* root) {
    Checker checker(root);
    visit(checker, input);
}

}  // namespace detail

void check_range(const Field& field, double value, const Message& where, const Unit& shown) {
    if (const Range* range = field.left_by(value)) {
        throw InputError(where, range->message(shown), Number{value, shown});
    }
}

double from_si(const Field& field, double si) {
    const double value = si / field.unit;
    // The digits that nearly every field has: no text is needed to round to them.
    constexpr double millionth = 1e6;
    constexpr double most = 1e12;  // so many digits in all
    const double whole = std::nearbyint(value * millionth);
    if (std::abs(whole) < most && whole / millionth * field.unit == si) {
        return whole / millionth;
    }
    for (const int digits : {12, 15, 16}) {
        const double shorter = rounded_to_digits(value, digits);
        if (shorter * field.unit == si) {
            return shorter;
        }
    }
    return value;
}

double rounded(double si, const Field& field, int digits) {
    return std::isfinite(si) ? rounded_to_digits(si / field.unit, digits) * field.unit : si;
}

}  // namespace ravnoves
