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
    std::shared_ptr<const Named> named = isExample ? nameOf(title, input) : nullptr;
    if (!named && title == scene_.defaultTitle()) {
        // The preset's, which its file has as the user's own would be.
        bool isPreset = input == scene_.defaultInput();
        if constexpr (requires { scene_.isSameEngine(input, input); }) {
            isPreset = isPreset || scene_.isSameEngine(input, scene_.defaultInput());
        }
        named = isPreset ? defaultName() : nullptr;
    }
    load(openName(), {input, title, QString::fromStdString(file.notes), named, context.directory,
                      variantsOf(file), file.study.is_null() ? std::string() : file.study.dump()});
}

template <typename Scene>
void CaseModel<Scene>::loadInput(const Json& json, const CaseContext& context) {
    State next = state();
    next.input = readInput(json, keptJson(), context);
    next.directory = context.directory;
    retitle(next);
    load(openName(), std::move(next));
}

template <typename Scene>
SceneModel::SolveApart CaseModel<Scene>::solvesApart() {
    return [this, scene = std::make_shared<Scene>(scene_), kept = keptJson(),
            context = context()](const Json& json) -> std::function<void()> {
        Input input = scene->read(json, context);
        if constexpr (requires { scene->keep(input, kept, context); }) {
            scene->keep(input, kept, context);
        }
        clear_vector_state();
        auto solved = std::make_shared<Solved>(scene->solve(input));
        return [this, input = std::move(input), solved] {
            State next = state();
            next.input = input;
            prepared_ = std::move(*solved);
            take(next);
        };
    };
}

template <typename Scene>
QString CaseModel<Scene>::changeVariants(const QString& name, const Variants& next,
                                         const std::optional<std::string>& input) {
    keepTyped();
    leaveEditing();
    State after = state();
    after.variants = next;
    try {
        if (input) {
            after.input = readInput(parse_json(*input), keptJson(), context());
            retitle(after);
            prepared_ = solve(after.input);
        }
    } catch (const InputError& error) {
        return explain(error);
    }
    if (after == state()) {
        prepared_.reset();
        return {};
    }
    if (input) {
        push(name, state(), std::move(after), -1);
    } else {
        const State before = state();
        setVariants(next);
        isApplied_ = true;  // nothing is to be solved
        push(name, before, std::move(after), -1);
    }
    return {};
}

template <typename Scene>
QString CaseModel<Scene>::inputTrouble(const std::string& input) const {
    try {
        solve(scene_.read(parse_json(input), context()));
    } catch (const InputError& error) {
        return explain(error);
    }
    return {};
}

}  // namespace ravnoves
