// What holds for the case of every scene, on every example of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "balance-shaft/input.h"
#include "case-file/field_index.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "elastic-hinge/input.h"
#include "examples.h"
#include "inertia-moments/input.h"
#include "scenes/scenes.h"
#include "workshop/input.h"
#include "workshop/older_formats.h"

namespace ravnoves {
namespace {

/// A scene without the type of its input.
struct Scene {
    std::string_view name;
    /// Reads the input of a case and writes it again; `same` tells whether that reads back equal.
    std::function<Json(const Json& input, bool& same)> rewrite;
    std::function<std::vector<FieldEntry>()> describe;
    std::function<std::vector<FieldEntry>(const Json& input)> list;
    /// Sets a field of the input by its pointer and lists the fields again; nothing where rejected.
    std::function<std::vector<FieldEntry>(const Json& input, const FieldEntry& entry)> set;
};

/// @param read  the scene's input from the "input" object of a case
template <typename Read>
Scene scene(std::string_view name, Read read) {
    using Input = decltype(read(Json()));
    return {name,
            [=](const Json& json, bool& same) {
                const Input input = read(json);
                const Json written = write_input(input);
                same = read(written) == input;
                return written;
            },
            [] { return describe_fields<Input>(); },
            [=](const Json& json) { return list_fields(read(json)); },
            [=](const Json& json, const FieldEntry& entry) {
                Input input = read(json);
                return set_field(input, entry.pointer, entry.value) ? list_fields(input)
                                                                    : std::vector<FieldEntry>{};
            }};
}

/// One line per scene.
const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{
        scene("balance-shaft",
              [](const Json& json) { return balance_shaft::read_input(json, {}); }),
        scene("elastic-hinge", elastic_hinge::read_input),
        scene("workshop", [](const Json& json) { return workshop::read_input(json); }),
        scene("v8-plugs", [](const Json& json) { return workshop::read_plugs_case(json); }),
        scene("bob-weights",
              [](const Json& json) { return workshop::read_bob_weights_case(json); }),
        scene("inertia-moments", inertia_moments::read_input)};
    return all;
}

/// Every object inside a value, by its pointer.
void for_each_object(const Json& value, const std::string& pointer,
                     const std::function<void(const Json& object, const std::string&)>& visit) {
    if (value.is_object()) {
        visit(value, pointer);
    }
    if (value.is_structured()) {
        for (const auto& item : value.items()) {
            for_each_object(item.value(), pointer + "/" + item.key(), visit);
        }
    }
}

class EveryScene : public testing::TestWithParam<std::filesystem::path> {
  protected:
    const Scene& scene() const {
        return *std::find_if(scenes().begin(), scenes().end(),
                             [&](const Scene& each) { return each.name == file.scene; });
    }
    std::optional<InputError> rejection(const Json& input) const {
        try {
            bool same = false;
            scene().rewrite(input, same);
        } catch (const InputError& error) {
            return error;
        }
        return std::nullopt;
    }

    const CaseFile file = parse_case(read_text_file(GetParam()));
};

TEST_P(EveryScene, ReadsWhatItWrites) {
    bool same = false;
    const Json written = scene().rewrite(file.input, same);
    EXPECT_TRUE(same);
    // Nothing that was given is lost, nor a number changed.
    const Json given = file.input.flatten();
    for (const auto& item : given.items()) {
        const Json::json_pointer at(item.key());
        if (item.value().is_number() && written.contains(at)) {
            EXPECT_EQ(written.at(at).get<double>(), item.value().get<double>()) << item.key();
        }
    }
}

TEST_P(EveryScene, DescribesEveryKeyThatItWrites) {
    const auto bare = [](const std::string& pointer) {
        return std::regex_replace(pointer, std::regex("/[0-9]+(?=/|$)"), "/0");
    };
    std::set<std::string> described;
    for (const FieldEntry& entry : scene().describe()) {
        if (entry.kind != FieldKind::object) {
            described.insert(bare(entry.pointer));
        }
    }
    bool same = false;
    const Json written = scene().rewrite(file.input, same).flatten();
    for (const auto& item : written.items()) {
        // A list, and a value of a form of its own, are described as a whole.
        std::string pointer = bare(item.key());
        bool found = false;
        for (; !found && !pointer.empty(); pointer.resize(pointer.rfind('/'))) {
            found = described.contains(pointer);
        }
        EXPECT_TRUE(found) << item.key();
    }
}

TEST_P(EveryScene, SetsEveryScalarByItsPointer) {
    const std::vector<FieldEntry> entries = scene().list(file.input);
    EXPECT_GT(entries.size(), 3U);
    for (FieldEntry entry : entries) {
        if (const double* number = std::get_if<double>(&entry.value)) {
            entry.value = *number + 1.0;
        } else if (const bool* flag = std::get_if<bool>(&entry.value)) {
            entry.value = !*flag;
        } else if (std::holds_alternative<std::string>(entry.value)) {
            entry.value = std::string("ж\"1");
        } else if (entry.kind == FieldKind::list || entry.kind == FieldKind::object ||
                   entry.kind == FieldKind::custom ||
                   std::holds_alternative<std::monostate>(entry.value)) {
            continue;
        }
        const std::vector<FieldEntry> now = scene().set(file.input, entry);
        const auto found = std::find_if(now.begin(), now.end(), [&](const FieldEntry& each) {
            return each.pointer == entry.pointer;
        });
        ASSERT_NE(found, now.end()) << entry.pointer;
        if (const double* number = std::get_if<double>(&entry.value)) {
            EXPECT_NEAR(std::get<double>(found->value), *number, 1e-12 + 1e-9 * std::abs(*number))
                << entry.pointer;
        } else {
            EXPECT_EQ(found->value, entry.value) << entry.pointer;
        }
    }
}

TEST_P(EveryScene, OffersTheNearestForAMisspeltKey) {
    int tried = 0;
    for_each_object(file.input, "", [&](const Json& object, const std::string& pointer) {
        if (pointer == "/reciprocating_masses_kg") {
            return;  // names are free there
        }
        for (const auto& item : object.items()) {
            const std::string misspelt = item.key() + "x";
            Json input = file.input;
            input[Json::json_pointer(pointer)][misspelt] = item.value();
            const auto error = rejection(input);
            ASSERT_TRUE(error) << pointer << "/" << misspelt;
            EXPECT_EQ(error->where(), "/input" + pointer + "/" + misspelt);
            EXPECT_NE(error->allowed().find("the nearest is \"" + item.key() + "\""),
                      std::string::npos)
                << error->what();
            ++tried;
        }
    });
    EXPECT_GT(tried, 3);
}

TEST_P(EveryScene, NamesWhatIsMissing) {
    int missing = 0;
    for_each_object(file.input, "", [&](const Json& object, const std::string& pointer) {
        for (const auto& item : object.items()) {
            Json input = file.input;
            input[Json::json_pointer(pointer)].erase(item.key());
            if (const auto error = rejection(input)) {
                // At the key, or at one that may stand in its place.
                EXPECT_TRUE(error->where().starts_with("/input" + pointer)) << error->what();
                missing += error->allowed().find("is required") != std::string::npos ? 1 : 0;
            }
        }
    });
    EXPECT_GT(missing, 0);
}

TEST_P(EveryScene, RejectsAValueOfAnotherKind) {
    for (const auto& item : file.input.items()) {
        Json input = file.input;
        input[item.key()] = item.value().is_array() ? Json(true) : Json::array({Json::array()});
        const auto error = rejection(input);
        ASSERT_TRUE(error) << item.key();
        EXPECT_TRUE(error->where().starts_with("/input/" + item.key())) << error->what();
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, EveryScene, testing::ValuesIn(test::example_files()),
                         [](const auto& example) {
                             std::string name = example.param.stem().string();
                             std::replace_if(
                                 name.begin(), name.end(),
                                 [](char c) { return std::isalnum(c) == 0; }, '_');
                             return name;
                         });

TEST(Scenes, HaveAnExampleAndALineHere) {
    std::set<std::string> shown;
    for (const auto& path : test::example_files()) {
        shown.insert(parse_case(read_text_file(path)).scene);
    }
    std::set<std::string> listed;
    for (const Scene& each : scenes()) {
        listed.insert(std::string(each.name));
    }
    std::set<std::string> solved;
    for (const SceneSolver& each : scene_solvers()) {
        solved.insert(std::string(each.name));
    }
    EXPECT_EQ(shown, solved);
    EXPECT_EQ(listed, solved);
}

TEST(Scenes, HavePresetsThatReadBack) {
    for (const SceneSolver& each : scene_solvers()) {
        const auto presets = each.presets();
        // Nobody begins in a format that the workshop reads.
        EXPECT_EQ(presets.empty(), each.title.empty()) << each.name;
        std::set<std::string> titles;
        for (const auto& [title, input] : presets) {
            EXPECT_TRUE(titles.insert(title.english()).second) << title.english();
            EXPECT_FALSE(each.formulas(input).empty()) << title.english();
        }
    }
}

TEST(Scenes, SayApartFromAHintWhatAnEmptyFieldStandsFor) {
    static const std::regex empty("\\bempty\\b", std::regex::icase);
    for (const Scene& each : scenes()) {
        for (const FieldEntry& entry : each.describe()) {
            const std::string_view hint = entry.field.hint.english;
            const std::string_view if_empty = entry.field.if_empty.english;
            EXPECT_FALSE(std::regex_search(hint.begin(), hint.end(), empty))
                << each.name << ": " << entry.pointer;
            // "A sentence. Empty: what it stands for."
            EXPECT_TRUE(if_empty.empty() || hint.empty() || hint.ends_with('.'))
                << each.name << ": " << entry.pointer;
            EXPECT_FALSE(if_empty.ends_with('.')) << each.name << ": " << entry.pointer;
        }
    }
}

}  // namespace
}  // namespace ravnoves
