#include "case-file/case_file.h"

#include <algorithm>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

Message line_and_column(std::string_view text, std::size_t byte) {
    byte = std::min(byte, text.size());
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(byte);
    const auto line = std::count(text.begin(), end, '\n') + 1;
    const std::size_t newline = byte == 0 ? std::string_view::npos : text.rfind('\n', byte - 1);
    const std::size_t column = newline == std::string_view::npos ? byte : byte - newline - 1;
    return table_place(static_cast<std::size_t>(line), std::max(static_cast<int>(column), 1));
}

// The JSON library parses any depth, but writing a value out again takes stack for each level.
void check_depth(std::string_view text) {
    constexpr int deepest = 100;
    int depth = 0;
    bool in_string = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (in_string) {
            at += c == '\\' ? 1 : 0;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest) {
                throw InputError(
                    line_and_column(text, at + 1),
                    {CORE_TEXT("core", "is nested more than %1 levels deep"), deepest});
            }
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
}

}  // namespace

Json parse_json(std::string_view text) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        throw InputError("", CORE_TEXT("core", "is empty"));
    }
    check_depth(text);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(line_and_column(text, error.byte), CORE_TEXT("core", "is not valid JSON"));
    } catch (const Json::out_of_range&) {
        throw InputError("",
                         CORE_TEXT("core", "holds a number that is too large for this program"));
    }
}

CaseFile read_case(const Json& document, const std::vector<std::string>& scenes) {
    ObjectReader reader(document, "");
    reader.choice("format", {case_format});
    const int version = reader.integer("version", 1, 1'000'000);
    if (version > case_version) {
        throw InputError(
            "/version",
            {CORE_TEXT("core",
                       "must be at most %1 (a newer program wrote this case; update to open it)"),
             case_version},
            Number{1.0 * version});
    }
    CaseFile file;
    file.scene = reader.text("scene");
    if (std::find(scenes.begin(), scenes.end(), file.scene) == scenes.end()) {
        const auto near = nearest_word(file.scene, scenes);
        throw InputError("/scene",
                         near
                             ? Message(CORE_TEXT("core", "must be one of %1 (the nearest is %2)"),
                                       quoted_list(scenes), quoted_list({*near}))
                             : Message(CORE_TEXT("core", "must be one of %1"), quoted_list(scenes)),
                         show(document.at("scene")));
    }
    file.title = reader.text("title", "");
    const Json& input = reader.raw("input");
    if (!input.is_object()) {
        throw InputError("/input", CORE_TEXT("core", "must be an object"), show(input));
    }
    reader.finish();
    file.input = input;
    return file;
}

Json write_case(const CaseFile& file) {
    return {{"format", case_format},
            {"version", case_version},
            {"scene", file.scene},
            {"title", file.title},
            {"input", file.input}};
}

}  // namespace ravnoves
