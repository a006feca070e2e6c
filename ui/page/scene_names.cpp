#include "page/scene_names.h"

#include <QCoreApplication>

namespace ravnoves {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("ravnoves::SceneList", text);
}

}  // namespace

std::vector<SceneName> sceneNames() {
    return {
        {QStringLiteral("balance-shaft"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Balance shaft")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Where the balance shaft of a single-cylinder engine goes"))},
        {QStringLiteral("elastic-hinge"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Elastic hinges")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Spring guides that hold the crank speed constant"))},
        {QStringLiteral("v8-plugs"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "V-8 workshop")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Crankpin plugs and bob weights of a V-8 under repair"))},
        {QStringLiteral("bob-weights"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Bob weights")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Bob weights and the drilled crankshaft of any engine"))},
        {QStringLiteral("inertia-moments"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Inertia moments")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Forces and moments of VR5 and any other cylinder layout"))},
        {QStringLiteral("methods"), translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Methods")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Speed against accuracy, and where methods fail"))},
    };
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
