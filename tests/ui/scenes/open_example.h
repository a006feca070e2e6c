#pragma once

#include <QDir>

#include "case-file/case_file.h"
#include "model/case_document.h"
#include "model/scene_model.h"

namespace ravnoves::test {

/// Opens the first example of the model's scene.
inline void openExample(SceneModel& model) {
    const QDir examples(QString::fromUtf8(RAVNOVES_EXAMPLES));
    for (const QString& name : examples.entryList({QStringLiteral("*.case.json")})) {
        const QString path = examples.filePath(name);
        const CaseFile file = CaseDocument::read(path);
        if (QString::fromStdString(file.scene) == model.sceneName()) {
            CaseDocument(&model).open(file, path);
            return;
        }
    }
}

}  // namespace ravnoves::test
