#include "model/variant_files.h"

#include <QStringList>

#include "case-file/json.h"
#include "model/scene_model.h"
#include "scenes/case_sources.h"

namespace ravnoves {

QString changedFilesText(const SceneModel& model, int variant) {
    QStringList names;
    for (const std::string& name :
         changed_files(parse_json(model.variants().at(variant).input), model.context())) {
        names << QString::fromStdString(name);
    }
    return names.isEmpty() ? QString()
                           : SceneModel::tr(
                                 "%1 has changed since this variant was kept: its results use the "
                                 "present file.")
                                 .arg(names.join(QStringLiteral(", ")));
}

}  // namespace ravnoves
