#pragma once

#include "case-file/json.h"
#include "model/case_model.h"

/// What of CaseModel sees JSON: for the file that holds a model's other functions alone. It says
/// `template class CaseModel<…Scene>;`, the model's header the same with `extern`.
namespace ravnoves {

template <typename Scene>
Json CaseModel<Scene>::inputJson() const {
    return scene_.write(input_);
}

template <typename Scene>
void CaseModel<Scene>::loadCase(const Json& json, const CaseContext& context,
                                const QString& title) {
    load(openName(), {scene_.read(json, context), title, context.directory});
}

}  // namespace ravnoves
