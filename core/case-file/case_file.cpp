#include "case-file/case_file.h"

#include <algorithm>
#include <charconv>
#include <unordered_set>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

constexpr Text no_nul = Text::tr("must not contain the character NUL");

Message line_and_column(std::string_view text, std::size_t byte) {
    byte = std::min(byte, text.size());
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(byte);
    const auto line = std::count(text.begin(), end, '\n') + 1;
    const std::size_t newline = byte == 0 ? std::string_view::npos : text.rfind('\n', byte - 1);
    const std::size_t column = newline == std::string_view::npos ? byte : byte - newline - 1;
    return table_place(static_cast<std::size_t>(line), std::max(static_cast<int>(column), 1));
}

// The JSON library parses any depth, but writing a value out again takes stack for each level.
constexpr std::size_t deepest = 100;
// More than the longest tables of a case and its variants take; each costs ten times its text in
// memory.
constexpr std::size_t max_values = 5'000'000;
constexpr std::size_t max_names = 1000;  // of an object: each is compared with those before it

/// Builds the document as the library's own parser does, but rejects what that takes in silence: a
/// key given twice, whose last value would count, and NUL, which cuts the name of a file short.
class DocumentBuilder final : public nlohmann::json_sax<Json> {
  public:
    explicit DocumentBuilder(std::string_view text) : text_(text) {}

    Json take() { return std::move(root_); }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t& /*text*/) override {
        return put(value);
    }
    bool string(string_t& value) override {
        check_text(value, value);
        return put(std::move(value));
    }
    bool binary(binary_t& /*value*/) override { return false; }  // not of JSON
    bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
    bool key(string_t& key) override {
        Level& level = levels_.back();
        level.key = std::move(key);
        check_text(level.key, {});
        if (level.value.contains(level.key)) {
            throw InputError(pointer(), Text::tr("is given twice"));
        }
        if (level.value.size() >= max_names) {
            levels_.pop_back();
            throw InputError(pointer(), {Text::tr("must have at most %1 names"), max_names});
        }
        return true;
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const Json::exception& error) override {
        constexpr int number_overflow = 406;
        if (error.id == number_overflow) {
            throw InputError(pointer(),
                             Text::tr("contains a number that is too large for this program"));
        }
        throw InputError(line_and_column(text_, position), Text::tr("is not valid JSON"));
    }

  private:
    struct Level {
        Json value;  ///< object or list, as far as it is read
        std::string key{};
    };

    /// JSON pointer of what is being read.
    std::string pointer() const {
        std::string text;
        for (const Level& level : levels_) {
            text += '/';
            text += level.value.is_object() ? printable(escape_segment(level.key))
                                            : std::to_string(level.value.size());
        }
        return text;
    }
    void check_text(const std::string& text, const Json& found) const {
        if (text.find('\0') != std::string::npos) {
            throw InputError(pointer(), no_nul, found.is_null() ? Message() : show(found));
        }
    }
    template <typename Value>
    bool put(Value&& value) {
        if (++values_ > max_values) {
            throw InputError("", {Text::tr("must have at most %1 values"), max_values});
        }
        if (levels_.empty()) {
            root_ = std::forward<Value>(value);
            return true;
        }
        Level& level = levels_.back();
        if (level.value.is_array()) {
            level.value.emplace_back(std::forward<Value>(value));
        } else {
            level.value.emplace(std::move(level.key), std::forward<Value>(value));
        }
        return true;
    }
    bool open(Json empty) {
        if (levels_.size() >= deepest) {
            throw InputError("", {Text::tr("is nested more than %1 levels deep"), deepest});
        }
        levels_.push_back({std::move(empty)});
        return true;
    }
    bool close() {
        Json value = std::move(levels_.back().value);
        levels_.pop_back();
        return put(std::move(value));
    }

    std::string_view text_;
    Json root_;
    std::vector<Level> levels_;
    std::size_t values_ = 0;
};

}  // namespace

Json parse_json(std::string_view text) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        throw InputError("", Text::tr("is empty"));
    }
    DocumentBuilder builder(text);
    Json::sax_parse(text, &builder);
    // The parser takes NUL for the end of the text.
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
        throw InputError(line_and_column(text, nul + 1), no_nul);
    }
    return builder.take();
}

namespace {

const Json& object_at(ObjectReader& reader, std::string_view key) {
    reader.object(key);  // else it rejects it
    return reader.raw(key);
}

std::vector<CaseVariant> read_variants(const Json& list) {
    std::vector<CaseVariant> variants;
    std::unordered_set<std::string> names;
    for (const Json& element : list) {
        ObjectReader reader(element, "/variants/" + std::to_string(variants.size()));
        CaseVariant variant{reader.text("name"), Json()};
        if (variant.name.empty()) {
            throw InputError(reader.pointer_to("name"), Text::tr("must not be empty"));
        }
        if (!names.insert(variant.name).second) {
            throw InputError(reader.pointer_to("name"),
                             Text::tr("must differ from the names of the other variants"),
                             show(variant.name));
        }
        variant.input = object_at(reader, "input");
        reader.finish();
        variants.push_back(std::move(variant));
    }
    return variants;
}

}  // namespace

CaseFile read_case(Json document, const std::vector<std::string>& scenes) {
    constexpr Word formats[]{{case_format}};
    ObjectReader reader(document, "");
    reader.choice("format", formats);
    CaseFile file;
    if (const auto version = reader.whole("version", 1, 1'000'000); version > case_version) {
        throw InputError("/version",
                         {Text::tr("must be at most %1 (a newer program wrote this case; update "
                                   "to open it)"),
                          case_version},
                         Number{static_cast<double>(version)});
    }
    file.scene = reader.text("scene");
    if (std::find(scenes.begin(), scenes.end(), file.scene) == scenes.end()) {
        const auto near = nearest_word(file.scene, scenes);
        throw InputError("/scene",
                         near ? Message(Text::tr("must be one of %1 (the nearest is %2)"),
                                        quoted_list(scenes), quoted_list({*near}))
                              : Message(Text::tr("must be one of %1"), quoted_list(scenes)),
                         show(document.at("scene")));
    }
    file.title = reader.text("title", "");
    file.notes = reader.text("notes", "");
    reader.object("input");
    if (reader.has("variants")) {
        file.variants = read_variants(reader.list("variants"));
    }
    file.reference = reader.text("reference", "");
    if (!file.reference.empty() &&
        std::none_of(file.variants.begin(), file.variants.end(),
                     [&](const CaseVariant& variant) { return variant.name == file.reference; })) {
        throw InputError("/reference", Text::tr("must be the name of a variant"),
                         show(Json(file.reference)));
    }
    if (reader.has("study")) {
        file.study = object_at(reader, "study");
    }
    if (reader.has("kept")) {
        file.kept = object_at(reader, "kept");
    }
    reader.finish(
        Text::tr("is not a known key (a newer program may have written this case; "
                 "update to open it)"));
    file.input = std::move(document.at("input"));
    return file;
}

Json write_case(const CaseFile& file) {
    Json document = {{"format", case_format},
                     {"version", case_version},
                     {"scene", file.scene},
                     {"title", file.title}};
    if (!file.notes.empty()) {
        document["notes"] = file.notes;
    }
    document["input"] = file.input;
    for (const CaseVariant& variant : file.variants) {
        document["variants"].push_back({{"name", variant.name}, {"input", variant.input}});
    }
    if (!file.reference.empty()) {
        document["reference"] = file.reference;
    }
    for (const auto& [key, value] :
         {std::pair("study", &file.study), std::pair("kept", &file.kept)}) {
        if (!value->is_null()) {
            document[key] = *value;
        }
    }
    return document;
}

void set_input_value(Json& input, const std::string& pointer, Json value) {
    Json* place = &input;
    for (const std::string& key : keys_of(pointer)) {
        if (place->is_null()) {
            *place = Json::object();
        }
        if (place->is_array()) {
            // The library fills a list up to the place that is asked for, whatever memory it takes.
            std::size_t index = place->size();
            const char* const last = key.data() + key.size();
            const auto [stopped, fault] = std::from_chars(key.data(), last, index);
            if (key != "-" && (fault != std::errc{} || stopped != last || index > place->size())) {
                throw InputError(
                    "/input" + printable(pointer),
                    {Text::tr("is not in the list, which has %1 elements"), place->size()});
            }
            if (index == place->size()) {
                place->push_back(nullptr);
            }
            place = &place->at(index);
        } else if (place->is_object()) {
            place = &(*place)[key];
        } else {
            throw InputError::unknown_key("/input" + printable(pointer));
        }
    }
    *place = std::move(value);
}

}  // namespace ravnoves
