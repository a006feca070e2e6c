#pragma once

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "model/case_model.h"
#include "text/field_names.h"

/// The parts of CaseModel that see JSON: only for the file with a model's other functions. That
/// file has `template class CaseModel<…Scene>;`, the model's header the same with `extern`.
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
    return withinMemory([&] {
        Input input = scene_.read(json, context);
        if constexpr (requires { scene_.keep(input, kept, context); }) {
            scene_.keep(input, kept, context);
        }
        return input;
    });
}

/// Loaded inputs are rejected with the places by their labels.
template <typename Scene>
void CaseModel<Scene>::loadFile(const CaseFile& file, const CaseContext& context, bool isNamed) {
    try {
        const Input input = readInput(file.input, file.kept, context);
        CaseTexts texts = textsOf(file);
        auto named = isNamed ? nameOf(texts.title, input) : nullptr;
        load(openName(), {input, std::move(texts), std::move(named), context.directory});
    } catch (const InputError& error) {
        throw RejectedInput(error, explain(error));
    }
}

template <typename Scene>
void CaseModel<Scene>::loadInput(const Json& json, const CaseContext& context,
                                 const QString& name) {
    try {
        State next = state();
        next.input = readInput(json, keptJson(), context);
        next.directory = context.directory;
        retitle(next);
        load(name, std::move(next));
    } catch (const InputError& error) {
        throw RejectedInput(error, explain(error));
    }
}

template <typename Scene>
void CaseModel<Scene>::showInput(const Json& json) {
    State next = state();
    next.input = readInput(json, keptJson(), context());
    take(next, {});
}

template <typename Scene>
QString CaseModel<Scene>::takeVariant(int place) {
    const Variant& variant = variants().at(place);
    try {
        State next = state();
        next.input = readInput(parse_json(variant.input), keptJson(), context());
        retitle(next);
        make(SceneModel::tr("Use variant %1").arg(variant.name), std::move(next));
    } catch (const InputError& error) {
        return explain(error);
    }
    Q_EMIT broughtIn();
    return {};
}

template <typename Scene>
Json CaseModel<Scene>::variantInput(int place) const {
    try {
        return scene_.write(readInput(SceneModel::variantInput(place), keptJson(), context()));
    } catch (const InputError&) {
        return SceneModel::variantInput(place);
    }
}

}  // namespace ravnoves
