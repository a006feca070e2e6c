#include "page/scene_names.h"

#include <QCoreApplication>

#include "scenes/scenes.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("ravnoves::SceneList", text);
}

}  // namespace

std::vector<SceneName> sceneNames() {
    std::vector<SceneName> names;
    for (const SceneSolver& scene : scene_solvers()) {
        if (!scene.title.empty()) {
            names.push_back({QString::fromUtf8(scene.name.data(), qsizetype(scene.name.size())),
                             shownText(scene.title), shownText(scene.summary)});
        }
    }
    names.push_back(
        {QStringLiteral("methods"), translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Methods")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Numerical methods: speed, accuracy, limits"))});
    return names;
}

QString sceneTitle(const QString& name) {
    for (const SceneName& each : sceneNames()) {
        if (each.name == name) {
            return each.title;
        }
    }
    return name;
}

}  // namespace ravnoves
