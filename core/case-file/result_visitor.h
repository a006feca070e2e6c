#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "case-file/key_units.h"
#include "case-file/message.h"
#include "numerics/units.h"

namespace ravnoves {

/// After what an angle is the same again.
enum class Period { turn, cycle, none };

/// One value of a result, described once, where it is visited: the file, `--only`, what a study
/// watches, the names in tables, their tips and the help follow. Its key gives the unit, unless
/// another is given.
struct ResultField {
    consteval ResultField(std::string_view its_key, Text its_label = {}, int its_decimals = 3,
                          Text its_hint = {})
        : ResultField(its_key, its_label, its_decimals, its_hint, unit_of_key(its_key).unit) {}
    constexpr ResultField(std::string_view its_key, Text its_label, int its_decimals, Text its_hint,
                          Unit its_unit)
        : key(its_key), unit(its_unit), decimals(its_decimals), label(its_label), hint(its_hint) {}
    constexpr ResultField with(Period its_period) const {
        ResultField field = *this;
        field.period = its_period;
        return field;
    }

    std::string_view key;  ///< in the file, with its unit: "relief_mm"
    Unit unit;
    int decimals;                  ///< in a table, in the unit
    Text label;                    ///< "Relief of the guide"
    Text hint;                     ///< a sentence with its formula
    Period period = Period::turn;  ///< of a value in degrees
};

/// Numbers of a list whose elements are lists of `columns`.
struct NumberRows {
    std::span<const double> si;
    std::size_t columns;
};

/// A value: none, a number in SI units, a count, yes or no, one of the file's words, a sentence or
/// several, a list.
using ResultValue = std::variant<std::monostate, double, long long, bool, std::string_view,
                                 const Message*, std::span<const Message>, std::span<const double>,
                                 std::span<const int>, NumberRows>;
/// Of a number in SI units or a count; yes and no are 1 and 0. Nothing of other values.
inline std::optional<double> single_number(const ResultValue& value) {
    const auto* number = std::get_if<double>(&value);
    const auto* count = std::get_if<long long>(&value);
    const auto* flag = std::get_if<bool>(&value);
    return number != nullptr  ? std::optional(*number)
           : count != nullptr ? std::optional(static_cast<double>(*count))
           : flag != nullptr  ? std::optional(*flag ? 1.0 : 0.0)
                              : std::nullopt;
}

/// The rest of a JSON pointer behind one around it, or behind itself; nothing where it leads
/// elsewhere.
inline std::optional<std::string_view> behind(std::string_view pointer, std::string_view around) {
    const bool leads_on = pointer.starts_with(around) &&
                          (pointer.size() == around.size() || pointer[around.size()] == '/');
    return leads_on ? std::optional(pointer.substr(around.size())) : std::nullopt;
}

/// Visits the values of a scene's result in the order of its file.
///
/// A scene lists them once, in a function found by argument-dependent lookup
///
///     void visit_results(ResultVisitor& visitor, const Input& input);
///
/// with one call for each value: `visitor.number({"relief_mm", Text::tr(…), 4}, guide.relief)`.
/// Numbers are SI values here and in the field's unit elsewhere; one that is not finite, or is
/// empty, is null. Unwanted values are neither visited nor computed: a call with a function calls
/// it for a wanted value alone.
class ResultVisitor {
  public:
    virtual ~ResultVisitor() = default;

    /// Whether the value under this key, or a value in it, is asked for.
    /// @param key  or several: "metrics/M_ups/rms_Nm"
    virtual bool wants(std::string_view key) const = 0;

    /// Of the crank; one where the scene says nothing.
    void set_turns_of_cycle(int turns) { turns_of_cycle_ = turns; }

    // --------------------------------------------------------------------------------- values

    void number(const ResultField& field, const std::optional<double>& si) { put(field, si); }
    template <typename Compute>
    requires std::is_invocable_v<Compute>
    void number(const ResultField& field, Compute&& compute) {
        if (wants(field.key)) {
            number(field, std::forward<Compute>(compute)());
        }
    }
    /// A count: written without decimals.
    void integer(const ResultField& field, const std::optional<long long>& value) {
        put(field, value);
    }
    void flag(const ResultField& field, const std::optional<bool>& value) { put(field, value); }
    /// One of the file's words, the same in every language; an empty one is null.
    void word(const ResultField& field, std::string_view word) {
        leaf(field, word.empty() ? ResultValue() : word);
    }
    /// A sentence. Under the keys "reason" and "note" it says why numbers beside it are null.
    void text(const ResultField& field, const Message& text) { leaf(field, &text); }
    void texts(const ResultField& field, const std::vector<Message>& texts) {
        leaf(field, std::span(texts));
    }
    template <typename Compute>
    requires std::is_invocable_v<Compute>
    void texts(const ResultField& field, Compute&& compute) {
        if (wants(field.key)) {
            texts(field, std::forward<Compute>(compute)());
        }
    }
    /// A list of numbers; of an empty one null.
    void numbers(const ResultField& field, const std::vector<double>& si) {
        leaf(field, si.empty() ? ResultValue() : std::span(si));
    }
    void integers(const ResultField& field, const std::vector<int>& values) {
        leaf(field, std::span(values));
    }
    /// A list of lists of `columns` numbers each.
    void rows(const ResultField& field, const std::vector<double>& si, std::size_t columns) {
        leaf(field, NumberRows{si, columns});
    }
    /// What the result has no value for.
    void nothing(const ResultField& field) { leaf(field, {}); }

    // ------------------------------------------------------------------------------ structure

    /// An object, whose values `visit` visits.
    template <typename Visit>
    void object(const ResultField& field, Visit&& visit) {
        if (begin_object(field)) {
            visit_inside(field.key, std::forward<Visit>(visit));
        }
    }
    /// The same where it is there, else null.
    template <typename Visit>
    void object_or_null(const ResultField& field, bool is_there, Visit&& visit) {
        if (is_there) {
            object(field, std::forward<Visit>(visit));
        } else {
            nothing(field);
        }
    }
    /// A list of objects; `visit(i)` visits the values of one.
    template <typename Visit>
    void list(const ResultField& field, std::size_t count, const Visit& visit) {
        if (begin_list(field)) {
            visit_inside(field.key, [&] {
                for (std::size_t i = 0; i < count; ++i) {
                    if (begin_element(i)) {
                        visit_inside(std::to_string(i), [&] { visit(i); });
                    }
                }
            });
        }
    }

  protected:
    virtual void leaf(const ResultField& field, const ResultValue& value) = 0;
    /// @return whether its values are to be visited; end() follows then
    virtual bool begin_object(const ResultField& field) = 0;
    virtual bool begin_list(const ResultField& field) { return begin_object(field); }
    virtual bool begin_element(std::size_t index) = 0;
    virtual void end() {}

    /// JSON pointer, below "result", of the object or list that is visited now.
    const std::string& here() const { return here_; }
    std::string place(std::string_view key) const { return (here_ + '/').append(key); }
    /// The next visit begins at the result, wherever one was broken off.
    void start() { here_.clear(); }

    /// Of a value, in the field's unit: 360 or 720 of an angle; 0 of what has none.
    double period_of(const ResultField& field) const {
        const int turns = field.period == Period::cycle ? turns_of_cycle_ : 1;
        const bool has_none = field.unit != units::degree || field.period == Period::none;
        return has_none ? 0.0 : turns * turn_deg;
    }

  private:
    template <typename Visit>
    void visit_inside(std::string_view key, Visit&& visit) {
        const std::size_t around = here_.size();
        here_.append(1, '/').append(key);
        std::forward<Visit>(visit)();
        here_.resize(around);
        end();
    }
    template <typename Value>
    void put(const ResultField& field, const std::optional<Value>& value) {
        leaf(field, value ? ResultValue(*value) : ResultValue());
    }

    int turns_of_cycle_ = 1;
    std::string here_;
};

}  // namespace ravnoves
