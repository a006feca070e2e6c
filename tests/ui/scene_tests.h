#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "page/scene_page.h"
#include "shell/scene_list.h"

namespace ravnoves::test {

/// The scenes by their words in case files, for tests of every page.
inline std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const SceneInfo& info : sceneList()) {
        names.push_back(info.name.toStdString());
    }
    return names;
}

/// Without Methods, which has no case.
inline std::vector<std::string> sceneNamesWithCases() {
    std::vector<std::string> names = sceneNames();
    std::erase(names, "methods");
    return names;
}

/// A page without a window; null for a word that is no scene.
inline std::unique_ptr<ScenePage> makePage(const std::string& scene) {
    for (const SceneInfo& info : sceneList()) {
        if (info.name.toStdString() == scene) {
            return std::unique_ptr<ScenePage>(info.make(nullptr, nullptr));
        }
    }
    return nullptr;
}

/// A word as a test may be named.
inline std::string testName(std::string word) {
    std::replace(word.begin(), word.end(), '-', '_');
    return word;
}

/// Names the tests of a suite over scenes.
template <typename Scene>
std::string sceneOf(const Scene& scene) {
    return testName(scene.param);
}

}  // namespace ravnoves::test
