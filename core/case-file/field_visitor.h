#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "case-file/field.h"
#include "case-file/json_fwd.h"

namespace ravnoves {

/// Goes through the fields of a scene's input in the order of its case file.
///
/// A scene lists its fields once, in a function found by argument-dependent lookup
///
///     void visit_fields(FieldVisitor& visitor, Input& input);
///
/// with one call for each field: `visitor.number(field::crank_radius, input.crank_radius)`. Structs
/// inside the input have a visit_fields of their own. What is read, written, checked, shown in a
/// form or varied in a study is a visitor over that list. Numbers are SI values in the struct and
/// in the field's unit elsewhere.
class FieldVisitor {
  public:
    /// What a case file does with a value that has a default.
    enum class Written { always, if_changed };

    virtual ~FieldVisitor() = default;

    /// True for the reader: the input is being filled in, and the file decides what there is.
    virtual bool is_reading() const { return false; }

    /// True where an object that is visited although it is absent is to come into being.
    virtual bool creates_objects() const { return false; }

    // ------------------------------------------------------------------------------- scalars

    /// A number that the case must give.
    void number(const Field& field, double& si) { visit_number(field, si, nullptr, true); }
    /// A number that keeps its default where the case does not give it.
    void number(const Field& field, double& si, double fallback,
                Written written = Written::if_changed) {
        visit_number(field, si, &fallback, written == Written::always);
    }
    /// A number that may be left out.
    void number(const Field& field, std::optional<double>& si) { visit_optional(field, si, false); }
    /// A number that the case must give, though a form that is not finished may lack it.
    void required(const Field& field, std::optional<double>& si) {
        visit_optional(field, si, true);
    }
    /// A number, or a word that stands for "by formula": then it is empty, as where it is left out.
    virtual void number_or_word(const Field& field, std::optional<double>& si,
                                std::string_view word) = 0;

    void integer(const Field& field, int& value) { visit_integer(field, value, nullptr, true); }
    void integer(const Field& field, int& value, int fallback,
                 Written written = Written::if_changed) {
        visit_integer(field, value, &fallback, written == Written::always);
    }
    void flag(const Field& field, bool& value, bool fallback,
              Written written = Written::if_changed) {
        visit_flag(field, value, &fallback, written == Written::always);
    }
    void text(const Field& field, std::string& value) { visit_text(field, value, true); }
    /// A text that is empty where the case does not give it.
    void optional_text(const Field& field, std::string& value) { visit_text(field, value, false); }

    /// One of field.words; the enumeration's values are 0, 1, … in their order.
    template <typename Enum>
    void choice(const Field& field, Enum& value) {
        auto index = static_cast<int>(value);
        visit_choice(field, index, nullptr, true);
        value = static_cast<Enum>(index);
    }
    template <typename Enum>
    void choice(const Field& field, Enum& value, std::type_identity_t<Enum> fallback,
                Written written = Written::if_changed) {
        auto index = static_cast<int>(value);
        const auto usual = static_cast<int>(fallback);
        visit_choice(field, index, &usual, written == Written::always);
        value = static_cast<Enum>(index);
    }

    // ----------------------------------------------------------------------------- structure

    /// An object that the case must give.
    template <typename Struct>
    void object(const Field& field, Struct& value) {
        if (begin_object(field, true, true)) {
            visit_fields(*this, value);
            end_object();
        }
    }
    /// An object whose fields all have defaults: written where one of them is changed.
    template <typename Struct>
    void object_with_defaults(const Field& field, Struct& value) {
        if (begin_object(field, false, !(value == Struct{}))) {
            visit_fields(*this, value);
            end_object();
        }
    }
    /// An object that may be left out.
    template <typename Struct>
    void object(const Field& field, std::optional<Struct>& value) {
        object(field, value, [this](Struct& it) { visit_fields(*this, it); });
    }
    /// The same where the function visits its fields.
    template <typename Struct, typename Visit>
    void object(const Field& field, std::optional<Struct>& value, Visit&& visit) {
        if (begin_object(field, false, value.has_value())) {
            if (!value && (is_reading() || creates_objects())) {
                value.emplace();
            }
            Struct absent;
            std::forward<Visit>(visit)(value ? *value : absent);
            end_object();
        }
    }
    /// An object whose fields the function visits.
    /// @param is_there  for the writer and the check
    template <typename Visit>
    void object_of(const Field& field, bool required, bool is_there, Visit&& visit) {
        if (begin_object(field, required, is_there)) {
            std::forward<Visit>(visit)();
            end_object();
        }
    }
    /// A list of objects; the check that there are not too many or too few is the scene's.
    template <typename Struct>
    void list(const Field& field, std::vector<Struct>& values) {
        list(field, values, [this](Struct& it) { visit_fields(*this, it); });
    }
    /// The same where the function visits the fields of each.
    template <typename Struct, typename Visit>
    void list(const Field& field, std::vector<Struct>& values, const Visit& visit) {
        std::size_t count = values.size();
        if (begin_list(field, count)) {
            values.resize(count);
            for (std::size_t i = 0; i < count; ++i) {
                begin_element(i);
                visit(values[i]);
                end_element();
            }
            end_list();
        }
    }
    /// A list of numbers in the field's unit; the struct holds them in that unit too.
    virtual void numbers(const Field& field, std::vector<double>& values) = 0;
    virtual void integers(const Field& field, std::vector<int>& values) = 0;

    /// Which of several keys (or objects) the case gives: exactly one of them must be there.
    /// @param present  the one that the input has now; the reader ignores it
    /// @return the one to visit; negative where all are to be visited (a table of all fields)
    virtual int one_of(std::initializer_list<std::string_view> keys, int present) = 0;
    /// True where the case has the key, or for other visitors than the reader `present`.
    virtual bool has(std::string_view key, bool present) = 0;
    /// Names in the object that is visited now, where they are free ({name: kg}): those of the
    /// file, for other visitors than the reader `present`; one that is to be set is among them.
    virtual std::vector<std::string> names(std::vector<std::string> present) { return present; }

    /// A value that no other call describes. `read` fills the input from the value in the file,
    /// `write` gives the value for the file; null is not written.
    struct Custom {
        virtual ~Custom() = default;
        virtual void read(const Json& value, const std::string& pointer) = 0;
        virtual Json write() = 0;
        /// Throws where the present value is not allowed.
        virtual void check(const std::string& /*pointer*/) {}
    };
    virtual void custom(const Field& field, bool required, Custom& value) = 0;

    /// JSON pointer of the object that is visited now, for example "/input/torque".
    virtual std::string pointer() const = 0;

  protected:
    virtual void visit_number(const Field& field, double& si, const double* fallback,
                              bool always) = 0;
    virtual void visit_optional(const Field& field, std::optional<double>& si, bool required) = 0;
    virtual void visit_integer(const Field& field, int& value, const int* fallback,
                               bool always) = 0;
    virtual void visit_flag(const Field& field, bool& value, const bool* fallback, bool always) = 0;
    virtual void visit_text(const Field& field, std::string& value, bool required) = 0;
    virtual void visit_choice(const Field& field, int& index, const int* fallback, bool always) = 0;
    /// @return whether the object is there and its fields are to be visited
    virtual bool begin_object(const Field& field, bool required, bool is_there) = 0;
    virtual void end_object() = 0;
    /// The reader sets the count.
    virtual bool begin_list(const Field& field, std::size_t& count) = 0;
    virtual void end_list() = 0;
    virtual void begin_element(std::size_t index) = 0;
    virtual void end_element() = 0;
};

/// For visitors that do not change what they visit.
template <typename Input>
void visit_constant(FieldVisitor& visitor, const Input& input) {
    visit_fields(visitor, const_cast<Input&>(input));
}

}  // namespace ravnoves
