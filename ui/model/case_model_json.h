#pragma once

#include "case-file/case_file.h"
#include "model/case_model.h"

/// What of CaseModel sees JSON: for the file that holds a model's other functions alone. It says
/// `template class CaseModel<…Scene>;`, the model's header the same with `extern`.
namespace ravnoves {

template <typename Scene>
Json CaseModel<Scene>::inputJson() const {
    return scene_.write(input_);
}

template <typename Scene>
Json CaseModel<Scene>::keptJson() const {
    if constexpr (requires { scene_.kept(input_); }) {
        return scene_.kept(input_);
    } else {
        return nullptr;
    }
}

template <typename Scene>
auto CaseModel<Scene>::readInput(const Json& json, const Json& kept,
                                 const CaseContext& context) const -> Input {
    Input input = scene_.read(json, context);
    if constexpr (requires { scene_.keep(input, kept, context); }) {
        scene_.keep(input, kept, context);
    }
    return input;
}

template <typename Scene>
void CaseModel<Scene>::loadFile(const CaseFile& file, const CaseContext& context, bool isExample) {
    Input input = readInput(file.input, file.kept, context);
    const QString title = QString::fromStdString(file.title);
    const bool isNamed =
        isExample || (title == scene_.defaultTitle() && input == scene_.defaultInput());
    load(openName(), {input, title, QString::fromStdString(file.notes),
                      isNamed ? nameOf(title, input) : nullptr, context.directory});
}

template <typename Scene>
void CaseModel<Scene>::loadInput(const Json& json, const CaseContext& context) {
    State next = state();
    next.input = readInput(json, keptJson(), context);
    next.directory = context.directory;
    retitle(next);
    load(openName(), std::move(next));
}

}  // namespace ravnoves
