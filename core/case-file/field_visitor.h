#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "case-file/field.h"
#include "case-file/json_fwd.h"
#include "case-file/object_reader.h"

namespace ravnoves {

/// A value that no other field describes. `read` fills the input from the value in the file,
/// `write` gives the value for the file; null is not written.
struct CustomValue {
    virtual ~CustomValue() = default;
    virtual void read(const Json& value, const std::string& pointer) = 0;
    virtual Json write() = 0;
    /// Throws where the present value is not allowed.
    virtual void check(const std::string& /*pointer*/) {}
};

/// A value that is visited.
struct Leaf {
    /// Its place in the input: numbers in SI units, numbers of a list in the field's unit, for a
    /// choice the place of its word.
    std::variant<double*, std::optional<double>*, int*, bool*, std::string*, std::vector<double>*,
                 std::vector<int>*, CustomValue*>
        at{};
    using Usual = std::variant<std::monostate, double, int, bool>;
    Usual usual{};            ///< default where the case gives none
    bool required = false;    ///< the case must give it, though a form not finished may lack it
    bool always = false;      ///< written even where it is the usual one
    bool is_choice = false;   ///< one of field.words
    std::string_view word{};  ///< that represents an empty number

    bool is_list() const {
        return std::holds_alternative<std::vector<double>*>(at) ||
               std::holds_alternative<std::vector<int>*>(at);
    }
};

/// Calls for each kind of Leaf::at what takes it.
template <typename... Calls>
struct ByKind : Calls... {
    using Calls::operator()...;
};
template <typename... Calls>
ByKind(Calls...) -> ByKind<Calls...>;

/// Visits the fields of a scene's input in the order of its case file.
///
/// A scene lists its fields once, in a function found by argument-dependent lookup
///
///     void visit_fields(FieldVisitor& visitor, Input& input);
///
/// with one call for each field: `visitor.number(field::crank_radius, input.crank_radius)`. Structs
/// inside the input have a visit_fields of their own. Reading, writing, checking, forms and studies
/// are visitors over that list. Numbers are SI values in the struct and in the field's unit
/// elsewhere.
class FieldVisitor {
  public:
    /// What a case file does with a value that has a default.
    enum class Written { always, if_changed };
    using Custom = CustomValue;

    /// @param root  JSON pointer of the input
    explicit FieldVisitor(std::string root = "/input") : pointer_(std::move(root)) {}
    virtual ~FieldVisitor() = default;

    /// True for the reader: it fills the input in, by the file.
    virtual bool is_reading() const { return false; }

    /// True where an object that is visited although it is absent is to come into being.
    virtual bool creates_objects() const { return false; }

    // ------------------------------------------------------------------------------- scalars

    /// A number that the case must give.
    void number(const Field& field, double& si) { leaf(field, {.at = &si, .required = true}); }
    /// A number that keeps its default where the case does not give it.
    void number(const Field& field, double& si, double fallback,
                Written written = Written::if_changed) {
        leaf(field, {.at = &si, .usual = fallback, .always = written == Written::always});
    }
    /// A number that may be left out.
    void number(const Field& field, std::optional<double>& si) { leaf(field, {.at = &si}); }
    /// A number that the case must give, though a form that is not finished may lack it.
    void required(const Field& field, std::optional<double>& si) {
        leaf(field, {.at = &si, .required = true});
    }
    /// A number, or a word that represents "by formula": then it is empty, as where it is left out.
    void number_or_word(const Field& field, std::optional<double>& si, std::string_view word) {
        leaf(field, {.at = &si, .word = word});
    }

    void integer(const Field& field, int& value) { leaf(field, {.at = &value, .required = true}); }
    void integer(const Field& field, int& value, int fallback,
                 Written written = Written::if_changed) {
        leaf(field, {.at = &value, .usual = fallback, .always = written == Written::always});
    }
    void flag(const Field& field, bool& value, bool fallback,
              Written written = Written::if_changed) {
        leaf(field, {.at = &value, .usual = fallback, .always = written == Written::always});
    }
    void text(const Field& field, std::string& value) {
        leaf(field, {.at = &value, .required = true});
    }
    /// A text that is empty where the case does not give it.
    void optional_text(const Field& field, std::string& value) { leaf(field, {.at = &value}); }

    /// One of field.words; the enumeration's values are 0, 1, … in their order.
    template <typename Enum>
    void choice(const Field& field, Enum& value) {
        choose(field, value, {.required = true});
    }
    template <typename Enum>
    void choice(const Field& field, Enum& value, std::type_identity_t<Enum> fallback,
                Written written = Written::if_changed) {
        choose(field, value,
               {.usual = static_cast<int>(fallback), .always = written == Written::always});
    }
    /// A list of numbers in the field's unit, in the struct too.
    void numbers(const Field& field, std::vector<double>& values) {
        leaf(field, {.at = &values, .required = true});
    }
    void integers(const Field& field, std::vector<int>& values) {
        leaf(field, {.at = &values, .required = true});
    }
    void custom(const Field& field, bool required, Custom& value) {
        leaf(field, {.at = &value, .required = required});
    }

    // ----------------------------------------------------------------------------- structure

    /// An object that the case must give.
    template <typename Struct>
    void object(const Field& field, Struct& value) {
        object_of(field, true, true, [&] { visit_fields(*this, value); });
    }
    /// An object whose fields all have defaults: written where one of them is changed.
    template <typename Struct>
    void object_with_defaults(const Field& field, Struct& value) {
        object_of(field, false, !(value == Struct{}), [&] { visit_fields(*this, value); });
    }
    /// An object that may be left out.
    template <typename Struct>
    void object(const Field& field, std::optional<Struct>& value) {
        object(field, value, [this](Struct& it) { visit_fields(*this, it); });
    }
    /// The same where the function visits its fields.
    template <typename Struct, typename Visit>
    void object(const Field& field, std::optional<Struct>& value, Visit&& visit) {
        object_of(field, false, value.has_value(), [&] {
            if (!value && (is_reading() || creates_objects())) {
                value.emplace();
            }
            Struct absent;
            std::forward<Visit>(visit)(value ? *value : absent);
        });
    }
    /// An object whose fields the function visits.
    /// @param is_there  for the writer and the check
    template <typename Visit>
    void object_of(const Field& field, bool required, bool is_there, Visit&& visit) {
        if (begin_object(field, required, is_there)) {
            visit_inside(field.key, std::forward<Visit>(visit));
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
            visit_inside(field.key, [&] {
                for (std::size_t i = 0; i < count; ++i) {
                    begin_element(field, i);
                    visit_inside(std::to_string(i), [&] { visit(values[i]); });
                    end_object();
                }
            });
        }
    }
    /// Which of several keys (or objects) the case gives: exactly one of them must be there.
    /// @param present  the one that the input has now; the reader ignores it
    /// @return the one to visit; negative where all are to be visited (a table of all fields)
    virtual int one_of(std::initializer_list<std::string_view> /*keys*/, int present) {
        return present;
    }
    /// True where the case has the key, or for other visitors than the reader `present`.
    virtual bool has(std::string_view /*key*/, bool present) { return present; }
    /// Names in the visited object, where they are free ({name: kg}): the file's, or for other
    /// visitors than the reader `present`; a name to be set is among them.
    virtual std::vector<std::string> names(std::vector<std::string> present) { return present; }

    /// JSON pointer of the object that is visited now, for example "/input/torque".
    const std::string& pointer() const { return pointer_; }
    std::string pointer_to(std::string_view key) const {
        return pointer_ + "/" + escape_segment(key);
    }

  protected:
    virtual void leaf(const Field& field, const Leaf& leaf) = 0;
    /// @return whether the object is there and its fields are to be visited
    virtual bool begin_object(const Field& /*field*/, bool /*required*/, bool is_there) {
        return is_there;
    }
    /// The reader sets the count.
    virtual bool begin_list(const Field& /*field*/, std::size_t& /*count*/) { return true; }
    virtual void begin_element(const Field& /*list*/, std::size_t /*index*/) {}
    /// Of an element, too.
    virtual void end_object() {}

  private:
    template <typename Visit>
    void visit_inside(std::string_view key, Visit&& visit) {
        const std::size_t around = pointer_.size();
        pointer_ = pointer_to(key);
        std::forward<Visit>(visit)();
        pointer_.resize(around);
    }
    template <typename Enum>
    void choose(const Field& field, Enum& value, Leaf how) {
        auto index = static_cast<int>(value);
        how.at = &index;
        how.is_choice = true;
        leaf(field, how);
        value = static_cast<Enum>(index);
    }

    std::string pointer_;
};

/// Visits the fields of some input.
using VisitFields = std::function<void(FieldVisitor& visitor)>;
/// @param input  must outlive this; of one that is constant for visitors that change nothing
template <typename Input>
VisitFields fields_of(const Input& input) {
    return [&input](FieldVisitor& visitor) { visit_fields(visitor, const_cast<Input&>(input)); };
}

}  // namespace ravnoves
