#include "balance-shaft/input.h"

#include <array>
#include <map>
#include <optional>
#include <string>

#include "balance-shaft/fields.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves::balance_shaft {

namespace {

using Pointer = Json::json_pointer;

/// Below "input".
struct Size {
    const char* place;
    std::array<const char*, 3> older;
};

constexpr Size sizes[] = {
    {"/cylinder/bore_mm",
     {"/torque/pressure/bore_mm", "/torque/cycle/bore_mm", "/envelope/cylinder_bore_mm"}},
    {"/cylinder/rod_length_mm",
     {"/torque/pressure/rod_length_mm", "/torque/cycle/rod_length_mm", "/rod_length_mm"}},
    {"/cylinder/offset_mm",
     {"/torque/pressure/offset_mm", "/torque/cycle/offset_mm", "/offset_mm"}},
};

/// What there was at a place, which goes.
std::optional<Json> take(Json& input, const char* place) {
    const Pointer pointer(place);
    if (!input.contains(pointer)) {
        return std::nullopt;
    }
    Json value = input.at(pointer);
    input.at(pointer.parent_pointer()).erase(pointer.back());
    return value;
}

void demand_same(const Json& first, const std::string& place, const Json& other,
                 const std::string& other_place) {
    if (other != first) {
        throw InputError(other_place,
                         {Text::tr("must be %1 as in %2, or be left out"), show(first), place},
                         show(other));
    }
}

void gather(Json& input, const std::string& root) {
    const std::string key(field::cylinder.key);
    if (input.contains(key) && !input.at(key).is_object()) {
        return;  // the reader says so
    }
    for (const Size& size : sizes) {
        const Pointer place(size.place);
        const char* given_at = size.place;
        for (const char* older : size.older) {
            const std::optional<Json> value = take(input, older);
            if (!value) {
                continue;
            }
            if (!input.contains(place)) {
                input[key][place.back()] = *value;
                given_at = older;
            } else {
                demand_same(input.at(place), root + given_at, *value, root + older);
            }
        }
    }
}

void move_varied(Json& vary) {
    Json moved = Json::object();
    std::map<std::string, std::string> given_at;
    const auto place_of = [](const std::string& pointer) {
        return "/study/vary/" + escape_segment(pointer);
    };
    for (const auto& [pointer, spread] : vary.items()) {
        std::string place = pointer;
        for (const Size& size : sizes) {
            for (const char* older : size.older) {
                place = place == older ? size.place : place;
            }
        }
        if (const auto [first, is_new] = given_at.emplace(place, pointer); is_new) {
            moved[place] = spread;
        } else {
            demand_same(moved[place], place_of(first->second), spread, place_of(pointer));
        }
    }
    vary = std::move(moved);
}

}  // namespace

void gather_cylinder(CaseFile& file) {
    gather(file.input, "/input");
    for (std::size_t i = 0; i < file.variants.size(); ++i) {
        gather(file.variants[i].input, "/variants/" + std::to_string(i) + "/input");
    }
    if (file.study.contains("vary") && file.study["vary"].is_object()) {
        move_varied(file.study["vary"]);
    }
    // What is kept is of the same cylinder; its rod length was filled in.
    const auto number = [&](const char* place) {
        const Pointer pointer(place);
        return file.input.contains(pointer) && file.input.at(pointer).is_number()
                   ? file.input.at(pointer).get<double>()
                   : 0.0;
    };
    const double given = number(sizes[0].place);
    const Json bore = given > 0.0 ? given : 2.0 * number("/crank_radius_mm");
    for (const Size& size : sizes) {
        for (const char* older : size.older) {
            const std::optional<Json> value = take(file.kept, older);
            if (&size == &sizes[0] && value && !value->is_null() && *value != bore) {
                file.changes.push_back(
                    {Text::tr("An unused torque source had the bore %1: enter it at the "
                              "cylinder, for all sources, if it is correct."),
                     show(*value)});
            }
        }
    }
}

}  // namespace ravnoves::balance_shaft
