// What a report says of the theory: formulas with their sources, and what a model leaves out.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <string_view>

#include "bibliography/bibliography.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "examples.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

/// Calls `look` with the solver, the file's name and the input of every example.
template <typename Look>
void for_every_example(Look&& look) {
    for (const auto& path : ravnoves::test::example_files()) {
        const CaseFile file = parse_case(read_text_file(path));
        const SceneSolver& scene = scene_solver(file.scene);
        look(scene, path, scene.formulas(file.input));
    }
}

TEST(Formulas, CiteSourcesThatTheBibliographyHolds) {
    std::set<std::string_view> scenes;
    for_every_example([&](const SceneSolver& scene, const auto& path, const auto& formulas) {
        scenes.insert(scene.name);
        EXPECT_GE(formulas.size(), 5u) << path;
        bool cites = false;
        for (const Formula& formula : formulas) {
            SCOPED_TRACE(path.string() + ": " + formula.name.english);
            EXPECT_FALSE(formula.name.empty());
            EXPECT_FALSE(formula.html.empty());
            if (!formula.source.empty()) {
                cites = true;
                EXPECT_NO_THROW(static_cast<void>(source(formula.source)));
            } else {
                EXPECT_TRUE(formula.equation.empty()) << "an equation of no paper";
            }
        }
        EXPECT_TRUE(cites) << path;
    });
    EXPECT_EQ(scenes.size(), scene_solvers().size());
}

TEST(Formulas, AreWellFormed) {
    for_every_example([&](const SceneSolver&, const auto& path, const auto& formulas) {
        for (const Formula& formula : formulas) {
            const std::string html(formula.html);
            for (const std::string tag : {"sub", "sup", "i"}) {
                const auto count = [&](const std::string& what) {
                    std::size_t found = 0;
                    for (std::size_t at = html.find(what); at != std::string::npos;
                         at = html.find(what, at + 1)) {
                        ++found;
                    }
                    return found;
                };
                EXPECT_EQ(count("<" + tag + ">"), count("</" + tag + ">")) << path << html;
            }
            EXPECT_EQ(html.find('&'), std::string::npos) << html;
            // Combining dots, U+0307 and U+0308: a page of text sets them over the line above.
            for (const std::string_view dots : {"\u0307", "\u0308"}) {
                EXPECT_EQ(html.find(dots), std::string::npos) << html;
                EXPECT_EQ(std::string_view(formula.where.english).find(dots),
                          std::string_view::npos)
                    << html;
            }
            // Words stand where they are translated.
            std::smatch word;
            static const std::regex words("[a-z]{4,}");
            const std::string plain =
                std::regex_replace(html, std::regex("<[^>]*>|arcsin|const"), " ");
            EXPECT_FALSE(std::regex_search(plain, word, words)) << word.str();
        }
    });
}

TEST(Formulas, FollowTheCase) {
    const auto has = [](const Json& input, const char* name) {
        const auto formulas = scene_solver("elastic-hinge").formulas(input);
        return std::any_of(formulas.begin(), formulas.end(), [&](const Formula& formula) {
            return std::string_view(formula.name.english) == name;
        });
    };
    const auto input_of = [](const char* name) { return test::example(name).input; };
    EXPECT_TRUE(has(input_of("zotov-counterweight"), "Part of the counterweight in M₁₂"));
    EXPECT_FALSE(has(input_of("zotov-energy"), "Part of the counterweight in M₁₂"));
    EXPECT_TRUE(has(input_of("zotov-energy"), "Minimum preload"));
    EXPECT_FALSE(has(input_of("zotov-as-printed"), "Minimum preload"));
}

TEST(Formulas, OfAComputedCycleAreAllThere) {
    const CaseFile file = test::example("tmz-650d");
    Json input = file.input;
    input["cylinder"] = {{"bore_mm", 92}, {"rod_length_mm", 160}};
    const std::size_t given = scene_solver(file.scene).formulas(input).size();
    for (const int strokes : {2, 4}) {
        input["strokes"] = strokes;
        input["torque"] = {
            {"cycle",
             {{"heat_J", 1000}, {"combustion_start_deg", 352}, {"combustion_duration_deg", 60}}}};
        EXPECT_EQ(scene_solver(file.scene).formulas(input).size(), given + 7) << strokes;
    }
}

TEST(Formulas, EveryModelSaysWhatItLeavesOut) {
    for (const SceneSolver& scene : scene_solvers()) {
        EXPECT_GE(scene.left_out().size(), 3u) << scene.name;
        for (const Text& text : scene.left_out()) {
            EXPECT_TRUE(std::string_view(text.english).ends_with('.')) << text.english;
        }
    }
}

}  // namespace
}  // namespace ravnoves
