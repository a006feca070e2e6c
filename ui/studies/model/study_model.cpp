#include "studies/model/study_model.h"

#include <QCoreApplication>
#include <algorithm>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "model/input_differences.h"
#include "model/scene_model.h"
#include "scenes/scenes.h"
#include "studies/model/solved_once.h"
#include "studies/study_run.h"
#include "text/capital.h"
#include "text/key_words.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using studies::Study;
using studies::Varied;
using studies::Watched;

namespace {

constexpr int restMs = 250;
constexpr int everyCore = 0;  ///< number of threads of a study: as many as there are cores

/// A study of the window begins small: it answers while one looks.
Study freshStudy() {
    Study study;
    study.samples = 4096;
    return study;
}

/// Of what no description names.
ResultName nameByKeys(const std::string& pointer) {
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

/// An input that no form names.
StudyModel::Input unnamedInput(const std::string& pointer, double value) {
    const ResultName name = nameByKeys(pointer);
    return {InputNumber{pointer, capitalised(name.text), name.unit, value, false, name.shown()}};
}

void collectNumbers(const Json& json, const std::string& pointer, std::vector<std::string>& found) {
    if (json.is_number()) {
        found.push_back(pointer);
    } else if (json.is_object()) {
        for (const auto& [key, child] : json.items()) {
            collectNumbers(child, pointer + (Json::json_pointer() / key).to_string(), found);
        }
    }
}

}  // namespace

StudyModel::StudyModel(SceneModel* scene, QObject* parent)
    : QObject(parent), scene_(scene), job_(new BackgroundJob(this)) {
    later_.setSingleShot(true);
    later_.setInterval(restMs);
    connect(&later_, &QTimer::timeout, this, &StudyModel::start);
    connect(scene_, &SceneModel::changed, this, &StudyModel::follow);
    connect(scene_, &SceneModel::studyChanged, this, &StudyModel::follow);
    connect(scene_, &SceneModel::historyChanged, this, &StudyModel::move);
    connect(job_, &BackgroundJob::failed, this,
            [this](const QString& why) { show(std::nullopt, why); });
    follow();
}

void StudyModel::follow() {
    refresh();
    if (watched_) {
        outdate();
    }
}

void StudyModel::move() {
    if (watched_ && isBehind()) {
        const bool isFirst = !stale_;
        outdate();
        if (isFirst) {
            Q_EMIT changed();  // sweeps are of the past, too
        }
    }
}

void StudyModel::outdate() {
    job_->cancel();  // what is under way is of the values before
    later_.start();
    stale_ = answers_.has_value();
    Q_EMIT answered();
}

void StudyModel::refresh() {
    solutions_ = scene_->solutions();
    readStudy();
    inputs_.clear();
    for (const InputNumber& number : inputNumbers(*scene_)) {
        inputs_.push_back(number.hasLabel ? Input{number}
                                          : unnamedInput(number.pointer, number.value));
    }
    const Json input = scene_->inputJson();
    for (const Varied& varied : study_.vary) {
        auto found = std::ranges::find(inputs_, varied.pointer, &Input::pointer);
        if (found == inputs_.end()) {  // an element of a long list, which is not offered, or gone
            const Json::json_pointer place(varied.pointer);
            const bool isThere = input.contains(place) && input.at(place).is_number();
            inputs_.push_back(
                unnamedInput(varied.pointer, isThere ? input.at(place).get<double>() : 0.0));
            found = inputs_.end() - 1;
            found->isMissing = !isThere;
        }
        found->varied = varied;
    }
    Q_EMIT changed();
}

const StudyModel::Input* StudyModel::known(const std::string& pointer) const {
    const auto found = std::ranges::find(inputs_, pointer, &Input::pointer);
    return found != inputs_.end() ? &*found : nullptr;
}

const StudyModel::Input* StudyModel::input(const std::string& pointer) const {
    const Input* found = known(pointer);
    return found != nullptr && !found->isMissing ? found : nullptr;
}

Range StudyModel::rangeOf(const std::string& pointer) const {
    const std::vector<FieldEntry> fields = scene_->fields(pointer);
    return fields.empty() ? Range() : fields.front().field.range;
}

void StudyModel::readStudy() {
    trouble_.clear();
    removedMethod_.clear();
    isRejected_ = false;
    study_ = freshStudy();
    if (scene_->study().empty()) {
        return;
    }
    try {
        study_ = readStudyText(scene_->study(), &removedMethod_);
        if (study_.method == studies::Method::grid) {
            trouble_ =
                tr("This case lists values of its inputs. The command line computes the "
                   "table: ravnoves-cli study.");
        }
    } catch (const InputError& error) {
        trouble_ = scene_->explain(error);
    }
    isRejected_ = !trouble_.isEmpty();
    if (isRejected_) {
        study_ = freshStudy();
        trouble_ += QLatin1Char('\n') + tr("To use tolerances here, undo or clear the study by "
                                           "“Typical tolerances”, “Remove all”.");
    }
}

std::vector<std::string> StudyModel::results() const {
    std::vector<std::string> found;
    collectNumbers(scene_->resultJson(), {}, found);
    // What an answer leads with is first.
    auto next = found.begin();
    for (const std::string_view leading : scene_solver(scene_->sceneName().toStdString()).leading) {
        if (const auto at = std::find(next, found.end(), leading); at != found.end()) {
            next = std::rotate(next, at, at + 1);
        }
    }
    return found;
}

ResultName StudyModel::resultName(const std::string& pointer) const {
    if (!names_.contains(pointer) &&
        std::exchange(namedOf_, scene_->solutions()) != scene_->solutions()) {
        try {
            for (const ResultEntry& entry : scene_solver(scene_->sceneName().toStdString())
                                                .results(scene_->inputJson(), scene_->context())) {
                names_.insert_or_assign(
                    entry.pointer,
                    ResultName{messageText(entry.name), unitText(entry.unit.name), entry.period});
            }
        } catch (const InputError&) {
            // A case that is rejected has no results.
        }
    }
    const auto known = names_.find(pointer);
    return known != names_.end() ? known->second : nameByKeys(pointer);
}

QString StudyModel::inputName(const std::string& pointer) const {
    const Input* found = known(pointer);
    return found != nullptr ? found->name : capitalised(resultName(pointer).text);
}

ShownTitle StudyModel::inputTitle(const std::string& pointer) const {
    const Input* found = known(pointer);
    return found == nullptr
               ? ShownTitle{inputName(pointer)}
               : ShownTitle{titleWithUnit(found->name, found->shown.name), found->shown.factor};
}

QString StudyModel::named(const Message& message) const {
    return messageText(message, {.word = [this](const std::string& word) {
                           const std::string root = "/input";
                           const bool isInput = word.starts_with(root + '/');
                           const std::string pointer = isInput ? word.substr(root.size()) : word;
                           const bool isPlace =
                               isInput || known(pointer) != nullptr ||
                               std::ranges::find(study_.watch, pointer, &Watched::pointer) !=
                                   study_.watch.end();
                           return isPlace ? tr("“%1”").arg(inputName(pointer))
                                          : QCoreApplication::translate(core_texts, word.c_str());
                       }});
}

bool StudyModel::isBusy() const {
    return later_.isActive() || job_->isRunning();
}

void StudyModel::setWatched(bool watched) {
    watched_ = watched;
    if (watched) {
        start();
    } else {
        later_.stop();
        job_->cancel();
    }
}

void StudyModel::start() {
    later_.stop();
    if (isBehind()) {
        refresh();
    }
    if (!watched_) {
        return;
    }
    Study study = study_;
    std::erase_if(study.vary,
                  [this](const Varied& varied) { return input(varied.pointer) == nullptr; });
    if (study.vary.empty() || study.watch.empty() || isRejected_) {
        job_->cancel();
        show(std::nullopt, trouble_);
        return;
    }
    const std::size_t watched = study.watch.size();
    watchFeasible(study, *scene_);
    CaseFile file = scene_->caseFile();
    file.study = studies::write_study(study);
    job_->start([this, file = std::move(file), context = scene_->context(),
                 watched](const BackgroundJob::Progress& progress) -> std::function<void()> {
        const studies::Problem problem = studies::problem_of(file, context);
        const auto answers =
            solvedOnce<StudyAnswers>(problem, watched, [&]() -> std::optional<StudyAnswers> {
                const auto part = studies::run_study(problem, 1, 1, everyCore, progress);
                return part ? std::optional(answersOf(*part, watched)) : std::nullopt;
            });
        if (!answers) {
            return {};
        }
        return [this, answers] { show(answers, {}); };
    });
}

void StudyModel::show(std::optional<StudyAnswers> answers, const QString& trouble) {
    answers_ = std::move(answers);
    stale_ = false;
    if (trouble != trouble_) {
        trouble_ = trouble;
        Q_EMIT changed();
    }
    Q_EMIT answered();
}

void watchFeasible(Study& study, const SceneModel& scene) {
    const std::string built(scene_solver(scene.sceneName().toStdString()).buildable);
    if (!built.empty() && studies::is_sampled(study.method) &&
        std::ranges::find(study.watch, built, &Watched::pointer) == study.watch.end()) {
        study.watch.push_back({.pointer = built});
    }
}

studies::Study readStudyText(const std::string& text, QString* gone) {
    Json json = parse_json(text);
    if (json.is_object() && json.contains("method")) {
        for (const char* method : {"second-order", "latin-hypercube"}) {
            if (json["method"] == method) {
                json["method"] = "sobol";
                if (gone != nullptr) {
                    *gone = QString::fromLatin1(method);
                }
            }
        }
    }
    return studies::read_study(json, true);
}

}  // namespace ravnoves
