#include "case-file/wanted.h"

#include <algorithm>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

/// Whether a pointer leads to the value of another or into it.
bool is_within(std::string_view pointer, std::string_view around) {
    return pointer.starts_with(around) &&
           (pointer.size() == around.size() || pointer[around.size()] == '/');
}

/// A pointer as a message shows it: one line of text, whatever its bytes are.
std::string shown(const std::string& pointer) {
    const std::string quoted = Json(pointer).dump(-1, ' ', false, Json::error_handler_t::replace);
    return printable(std::string_view(quoted).substr(1, quoted.size() - 2));
}

}  // namespace

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
               return is_within(each, pointer) || is_within(pointer, each);
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
                return other.size() < text.size() && is_within(text, other);
            })) {
            continue;
        }
        Json* place = &picked;
        Json::json_pointer rest = pointer;
        std::vector<std::string> keys;
        for (; !rest.empty(); rest.pop_back()) {
            keys.push_back(rest.back());
        }
        for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
            place = &(*place)[*key];
        }
        *place = result.at(pointer);
    }
    return picked;
}

}  // namespace ravnoves
