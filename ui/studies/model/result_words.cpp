#include "studies/model/result_words.h"

#include <QStringList>
#include <algorithm>
#include <map>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "scenes/scenes.h"
#include "text/key_words.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

namespace {

struct Described {
    Message name;
    Unit unit;
};
using Names = std::map<std::string, Described>;

void learn(Names& names, const std::string& scene, const Json& input, const CaseContext& context) {
    try {
        for (ResultEntry& entry : scene_solver(scene).results(input, context)) {
            names.insert_or_assign(std::move(entry.pointer),
                                   Described{std::move(entry.name), entry.unit});
        }
    } catch (const InputError&) {
        // A case that is rejected has no results.
    }
}

Names& namesOf(const std::string& scene) {
    static std::map<std::string, Names> all;
    const auto known = all.find(scene);
    if (known != all.end()) {
        return known->second;
    }
    Names& names = all[scene];
    for (const SceneSolver& solver : scene_solvers()) {
        if (solver.name == scene) {
            for (const Preset<Json>& preset : solver.presets()) {
                learn(names, scene, preset.input, {});
            }
        }
    }
    return names;
}

}  // namespace

ResultName resultName(const QString& scene, const std::string& pointer) {
    const Names& names = namesOf(scene.toStdString());
    if (const auto found = names.find(pointer); found != names.end()) {
        return {messageText(found->second.name), unitText(found->second.unit.name)};
    }
    // Of a result that no case of today has: by its keys.
    ResultName name;
    QStringList parts;
    for (QString key :
         QString::fromStdString(pointer).split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        if (const Unit unit = takeUnit(key); unit != units::none) {
            name.unit = unitText(unit.name);
        }
        parts << keyInWords(key.toStdString());
    }
    name.text = parts.join(QStringLiteral(", "));
    return name;
}

bool isNamed(const QString& scene, const std::string& pointer) {
    return namesOf(scene.toStdString()).count(pointer) > 0;
}

void learnResultNames(const QString& scene, const Json& input, const CaseContext& context) {
    learn(namesOf(scene.toStdString()), scene.toStdString(), input, context);
}

}  // namespace ravnoves
