#pragma once

#include "case-file/case_file.h"
#include "model/case_model.h"
#include "model/run_beside.h"
#include "text/field_names.h"

/// What of CaseModel sees JSON or threads: for the file that holds a model's other functions alone.
/// It says `template class CaseModel<…Scene>;`, the model's header the same with `extern`.
namespace ravnoves {

template <typename Scene>
Json CaseModel<Scene>::inputJson() const {
    return scene_.write(input_);
}

template <typename Scene>
Json CaseModel<Scene>::latestInputJson() const {
    return scene_.write(isSolving() ? awaited_.back().input : input_);
}

template <typename Scene>
Json CaseModel<Scene>::inputAfter(const std::function<void(Input&)>& mutate) const {
    Input next = isSolving() ? awaited_.back().input : input_;
    mutate(next);
    try {
        if (!isLarge(next)) {
            solveIn(scene_, next);
        } else if constexpr (requires { Scene::check(next); }) {
            Scene::check(next);
        }
    } catch (const InputError&) {
        return nullptr;
    }
    return scene_.write(next);
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
auto CaseModel<Scene>::readInput(const Json& json, const Json& kept, const CaseContext& context)
    -> Input {
    const auto read = [&](const Scene& scene) {
        Input input = scene.read(json, context);
        if constexpr (requires { scene.keep(input, kept, context); }) {
            scene.keep(input, kept, context);
        }
        return input;
    };
    if constexpr (requires { Scene::isLong(json, context); }) {
        if (Scene::isLong(json, context)) {
            const Waiting waiting(this);
            Input input;
            runBeside([&, scene = Scene(scene_)] { input = read(scene); });
            return input;
        }
    }
    return read(scene_);
}

/// What is loaded is refused with the places by their labels.
template <typename Scene>
template <typename Loading>
void CaseModel<Scene>::loadWith(Loading loading) {
    try {
        loading();
    } catch (const InputError& error) {
        throw RefusedInput(error, explain(error));
    }
}

template <typename Scene>
void CaseModel<Scene>::loadFile(const CaseFile& file, const CaseContext& context,
                                const Json* named) {
    loadWith([&] {
        Input input = withinMemory([&] { return readInput(file.input, file.kept, context); });
        const QString title = QString::fromStdString(file.title);
        // A preset's title, which its file has as the user's own would be.
        std::shared_ptr<const Named> kept;
        if (named != nullptr) {
            const Input engine = *named == file.input ? input : scene_.read(*named, context);
            kept = isEngine(input, engine) ? nameOf(title, engine) : nullptr;
        } else if (title == scene_.defaultTitle() && isEngine(input, scene_.defaultInput())) {
            kept = defaultName();
        }
        load(openName(),
             {input, title, QString::fromStdString(file.notes), kept, context.directory,
              variantsOf(file), file.study.is_null() ? std::string() : file.study.dump()});
    });
}

template <typename Scene>
void CaseModel<Scene>::loadInput(const Json& json, const CaseContext& context) {
    loadWith([&] {
        State next = state();
        next.input = withinMemory([&] { return readInput(json, keptJson(), context); });
        next.directory = context.directory;
        retitle(next);
        load(openName(), std::move(next));
    });
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
    if (isSolving()) {
        Q_EMIT notSolved(solvingText());
        return solvingText();
    }
    keepTyped();
    leaveEditing();
    State after = state();
    after.variants = next;
    try {
        if (input) {
            withinMemory([&] {
                after.input = readInput(parse_json(*input), keptJson(), context());
                retitle(after);
                prepared_ = solve(after.input);
            });
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
        withinMemory([&] {
            const Input read = scene_.read(parse_json(input), context());
            isLarge(read) ? solveBeside(scene_, read) : solveIn(scene_, read);
        });
    } catch (const InputError& error) {
        return explain(error);
    }
    return {};
}

template <typename Scene>
auto CaseModel<Scene>::solveBeside(const Scene& scene, const Input& input) -> Solved {
    std::optional<Solved> solved;
    runBeside([&solved, &input, own = Scene(scene)] { solved = solveIn(own, input); });
    return *std::move(solved);
}

template <typename Scene>
QString CaseModel<Scene>::await(const QString& name, const Input& input, const QString& title,
                                bool merges) {
    if constexpr (requires { Scene::check(input); }) {
        Scene::check(input);  // what is refused is so at once, as elsewhere
    }
    if (!merges) {
        finishDrag();
    }
    Awaited next{name, input, title.isEmpty() ? std::nullopt : std::optional(title),
                 merges ? stepOf(name) : -1, editingNumber()};
    if (!awaited_.empty()) {
        const Awaited& last = awaited_.back();
        if (last.name == name && ((merges && last.step == next.step) ||
                                  (next.editing != 0 && last.editing == next.editing))) {
            awaited_.pop_back();  // it goes on
        }
    }
    const bool isBack = input == (awaited_.empty() ? input_ : awaited_.back().input);
    const bool sameTitle = !next.title || *next.title == this->title();
    if (!isBack || !sameTitle) {
        awaited_.push_back(std::move(next));
    }
    sayRefused({});
    solveAwaited();
    return {};
}

/// The latest; where nothing is awaited any more, that is over.
template <typename Scene>
void CaseModel<Scene>::solveAwaited() {
    if (awaited_.empty()) {
        if (job_) {
            job_->cancel();
        }
        tellSolving();
        return;
    }
    if (!job_) {
        job_ = std::make_unique<BackgroundJob>(this);
    }
    job_->start([this, scene = std::make_shared<const Scene>(scene_),
                 input = std::make_shared<const Input>(awaited_.back().input)](
                    const BackgroundJob::Progress&) -> std::function<void()> {
        try {
            auto solved = std::make_shared<Solved>(solveIn(*scene, *input));
            return [this, solved] { takeAwaited(std::move(*solved)); };
        } catch (const InputError& error) {
            return [this, error] { refuseAwaited(error); };
        }
    });
    tellSolving();
}

template <typename Scene>
void CaseModel<Scene>::takeAwaited(Solved&& solved) {
    const std::vector<Awaited> chain = std::exchange(awaited_, {});
    try {
        withinMemory([&] {
            State before = state();
            for (std::size_t i = 0; i < chain.size(); ++i) {
                const Awaited& step = chain[i];
                State next = before;
                next.input = step.input;
                if (step.title) {
                    next.title = *step.title;
                    next.named = nameOf(next.title, next.input);
                } else if (next.named && before.title == namedTitle(before.input)) {
                    next.title = namedTitle(next.input);
                }
                const bool isLast = i + 1 == chain.size();
                if (isLast) {
                    // NOLINTNEXTLINE(bugprone-use-after-move): once, for the last
                    prepared_ = std::move(solved);
                } else {
                    isApplied_ = true;  // the history alone has it
                }
                if (chain.size() == 1 && step.editing != 0 && step.editing == editingNumber() &&
                    joinEditing(step.name)) {
                    take(next);
                    settle();
                } else {
                    push(step.name, before, next, step.step);
                }
                before = std::move(next);
            }
        });
    } catch (const InputError& error) {
        prepared_.reset();
        isApplied_ = false;
        Q_EMIT notSolved(explain(error));
    }
    tellSolving();
}

template <typename Scene>
void CaseModel<Scene>::refuseAwaited(const InputError& error) {
    const QString why = explain(error);
    dropAwaited();
    sayRefused(why);
    Q_EMIT notSolved(why);
}

template <typename Scene>
bool CaseModel<Scene>::dropAwaited() {
    if (awaited_.empty()) {
        return false;
    }
    awaited_.pop_back();
    solveAwaited();
    // What shows the input shows what holds.
    Q_EMIT changed();
    Q_EMIT broughtIn();
    return true;
}

template <typename Scene>
void CaseModel<Scene>::stopSolving() {
    if (isSolving()) {
        forgetAwaited();
        Q_EMIT changed();
        Q_EMIT broughtIn();
    }
}

template <typename Scene>
void CaseModel<Scene>::forgetAwaited() {
    if (isSolving()) {
        awaited_.clear();
        solveAwaited();
    }
}

template <typename Scene>
bool CaseModel<Scene>::prepareStep(const QUndoCommand* command, bool isUndo) {
    const auto* step = dynamic_cast<const InputCommand<State>*>(command);
    if (step == nullptr) {
        return true;
    }
    const Input& input = isUndo ? step->before().input : step->after().input;
    try {
        if (!(input == input_)) {
            prepared_ = solve(input);
        }
        return true;
    } catch (const InputError& error) {
        const QString why = explain(error);
        sayRefused(why);
        Q_EMIT notSolved(why);
        return false;
    }
}

}  // namespace ravnoves
