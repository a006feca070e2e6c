#include "model/scene_model.h"

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

bool SceneModel::setViewOption(const QString& /*key*/, const QString& /*value*/) {
    return false;
}

void SceneModel::setTitle(const QString& title) {
    if (title_ != title) {
        title_ = title;
        Q_EMIT titleChanged(title);
    }
}

void SceneModel::setByKey(const QString& key, const QString& value) {
    if (setViewOption(key, value)) {
        return;
    }
    const std::string path = (QLatin1Char('/') + key).toStdString();
    Json input = inputJson();
    Json parsed;
    try {
        parsed = parse_json(value.toStdString());
    } catch (const InputError&) {
        parsed = value.toStdString();  // a bare word
    }
    try {
        input[Json::json_pointer(path)] = parsed;
    } catch (const Json::exception&) {
        throw InputError("/input" + path, "is not a known key");
    }
    loadInput(input, context_);
}

}  // namespace ravnoves
