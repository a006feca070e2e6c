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
        {QStringLiteral("workshop"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Workshop")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "From the scale to the drilled crankshaft, plugs of a V-8 "
                                      "included"))},
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
