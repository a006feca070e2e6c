#include "case-file/result_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

Json json_of(double si, const Unit& unit) {
    const double shown = si / unit;
    if (!std::isfinite(shown)) {
        return nullptr;
    }
    return shown == 0.0 ? 0.0 : shown;  // no minus before zero
}

Json json_of(std::monostate /*nothing*/, const Unit& /*unit*/) {
    return nullptr;
}
/// Of counts, words, yes and no.
template <typename Value>
Json json_of(Value value, const Unit& /*unit*/) {
    return value;
}
Json json_of(const Message& text, const Unit& /*unit*/) {
    return text.english();
}
Json json_of(const Message* text, const Unit& /*unit*/) {
    return text->english();
}

template <typename Element>
Json json_of(std::span<const Element> elements, const Unit& unit) {
    Json::array_t list;
    list.reserve(elements.size());
    for (const Element& element : elements) {
        list.push_back(json_of(element, unit));
    }
    return list;
}

Json json_of(const NumberRows& rows, const Unit& unit) {
    Json list = Json::array();
    for (std::size_t at = 0; at + rows.columns <= rows.si.size(); at += rows.columns) {
        list.push_back(json_of(rows.si.subspan(at, rows.columns), unit));
    }
    return list;
}

class ResultJson final : public ResultVisitor {
  public:
    explicit ResultJson(const Wanted& wanted) : wanted_(wanted) {}

    bool wants(std::string_view key) const override { return wanted_.wants(place(key)); }
    Json take() { return std::move(result_); }

  private:
    void leaf(const ResultField& field, const ResultValue& value) override {
        if (wants(field.key)) {
            const auto json = [&](const auto& it) { return json_of(it, field.unit); };
            (*filled_.back())[std::string(field.key)] = std::visit(json, value);
        }
    }
    bool begin_object(const ResultField& field) override {
        return wants(field.key) && fill((*filled_.back())[std::string(field.key)] = object());
    }
    bool begin_list(const ResultField& field) override {
        return wants(field.key) && fill((*filled_.back())[std::string(field.key)] = Json::array());
    }
    bool begin_element(std::size_t /*index*/) override {
        // All of them: an element keeps its place in the list.
        return fill(filled_.back()->emplace_back(object()));
    }
    void end() override { filled_.pop_back(); }

    static Json object() { return object_with_room(16); }
    bool fill(Json& container) {
        filled_.push_back(&container);
        return true;
    }

    const Wanted& wanted_;
    Json result_ = object_with_room(32);
    /// The result first, then each the last of what is in the one before: none of them moves.
    std::vector<Json*> filled_{&result_};
};

class ResultIndex final : public ResultVisitor {
  public:
    std::vector<ResultEntry> take() { return std::move(entries_); }

    bool wants(std::string_view /*key*/) const override { return true; }

  private:
    void leaf(const ResultField& field, const ResultValue& value) override {
        const auto si = single_number(value);
        if (si || std::holds_alternative<std::monostate>(value)) {
            Level level = inside(field.label, field.unit);
            entries_.push_back({place(field.key), std::move(level.name), level.unit, field.decimals,
                                period_of(field), si});
        }
    }
    bool begin_object(const ResultField& field) override {
        levels_.push_back(inside(field.label, field.unit));
        return true;
    }
    bool begin_element(std::size_t index) override {
        levels_.push_back(inside(Number{.value = static_cast<double>(index + 1)}, units::none));
        return true;
    }
    void end() override { levels_.pop_back(); }

    struct Level {
        Message name;
        Unit unit = units::none;  ///< of what has none of its own
    };
    Level inside(const Message& label, const Unit& unit) const {
        const Level& around = levels_.back();
        return {around.name.empty() ? label
                : label.empty()     ? around.name
                                    : joined(around.name, label),
                unit == units::none ? around.unit : unit};
    }

    std::vector<Level> levels_{1};
    std::vector<ResultEntry> entries_;
};

/// A pointer as a message shows it: one line of text, whatever its bytes are.
std::string shown(const std::string& pointer) {
    const std::string quoted = Json(pointer).dump(-1, ' ', false, Json::error_handler_t::replace);
    return printable(std::string_view(quoted).substr(1, quoted.size() - 2));
}

}  // namespace

Json result_json(const Wanted& wanted, const VisitResults& visit) {
    ResultJson json(wanted);
    visit(json);
    return json.take();
}

std::vector<ResultEntry> list_results(const VisitResults& visit) {
    ResultIndex index;
    visit(index);
    return index.take();
}

Wanted::Wanted(std::vector<std::string> pointers) : pointers_(std::move(pointers)) {
    const auto wrong = std::ranges::find_if_not(pointers_, is_inner_pointer);
    if (wrong != pointers_.end()) {
        throw InputError("",
                         Text::tr("must be a JSON pointer below the result, such as "
                                  "/optimum/range"),
                         show(Json(*wrong)));
    }
}

bool Wanted::wants(std::string_view pointer) const {
    return pointers_.empty() ||
           std::any_of(pointers_.begin(), pointers_.end(), [&](const std::string& each) {
               return behind(each, pointer) || behind(pointer, each);
           });
}

Json Wanted::pick(Json result) const {
    if (pointers_.empty()) {
        return result;
    }
    Json picked = Json::object();
    for (const std::string& text : pointers_) {
        const Json::json_pointer pointer(text);
        if (!result.contains(pointer)) {
            throw InputError("/result" + shown(text),
                             Text::tr("must be a value that the result has"));
        }
        // What lies in another comes with it.
        if (std::any_of(pointers_.begin(), pointers_.end(), [&](const std::string& other) {
                return other.size() < text.size() && behind(text, other);
            })) {
            continue;
        }
        Json* place = &picked;
        for (const std::string& key : keys_of(text)) {
            place = &(*place)[key];
        }
        *place = result.at(pointer);
    }
    return picked;
}

}  // namespace ravnoves
