#include "studies/model/study_model.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <boost/math/statistics/bivariate_statistics.hpp>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "model/input_differences.h"
#include "model/scene_model.h"
#include "studies/model/result_words.h"
#include "studies/study_run.h"
#include "text/capital.h"
#include "text/message_text.h"

namespace ravnoves {

using studies::Study;
using studies::Varied;
using studies::Watched;

namespace {

constexpr std::uint64_t mostNumbers = 4'000'000;  ///< watched ones, kept for other limits
constexpr int restMs = 250;

/// A study of the window begins small: it answers while one looks.
Study freshStudy() {
    Study study;
    study.samples = 4096;
    return study;
}

/// Why something does not exist, in the language of the program. Of what a result says in English,
/// what holds no values is known.
QString whyText(const Message& why, const QString& scene) {
    if (why.verbatim().empty()) {
        return messageText(why);
    }
    QString english = QString::fromStdString(why.verbatim());
    for (const QByteArray& context : {QByteArray("core"), scene.toUtf8(), QByteArray("studies")}) {
        QString text = QCoreApplication::translate(context.constData(), why.verbatim().c_str());
        if (text != english) {
            return text;
        }
    }
    return english;
}

void collectNumbers(const Json& json, const std::string& pointer,
                    std::vector<StudyModel::Value>& found) {
    if (json.is_number()) {
        found.push_back({pointer, json.get<double>()});
    } else if (json.is_object()) {
        for (const auto& [key, child] : json.items()) {
            collectNumbers(child, pointer + (Json::json_pointer() / key).to_string(), found);
        }
    }
}

}  // namespace

/// One answering of a study.
struct StudyModel::Run {
    std::string key;
    // By the worker alone, one piece of work after the other:
    studies::Part part;
    // By both:
    std::mutex guard;
    std::vector<Watched> watch;  ///< with the limits that count now
    // By the model alone:
    bool isDone = false;

    std::vector<Watched> limits() {
        const std::lock_guard lock(guard);
        return watch;
    }
    void setLimits(const std::vector<Watched>& newest) {
        const std::lock_guard lock(guard);
        watch = newest;
    }
};

double StudyModel::correlation(const std::vector<double>& x, const std::vector<double>& y) {
    const auto stands = [](const std::vector<double>& list) {
        return std::adjacent_find(list.begin(), list.end(), std::not_equal_to<>()) == list.end();
    };
    return stands(x) || stands(y) ? 0.0 : boost::math::statistics::correlation_coefficient(x, y);
}

StudyModel::StudyModel(SceneModel* scene, QObject* parent)
    : QObject(parent), scene_(scene), job_(new BackgroundJob(this)) {
    later_.setSingleShot(true);
    later_.setInterval(restMs);
    connect(&later_, &QTimer::timeout, this, &StudyModel::start);
    connect(scene_, &SceneModel::changed, this, &StudyModel::follow);
    connect(scene_, &SceneModel::studyChanged, this, &StudyModel::follow);
    connect(scene_, &SceneModel::historyChanged, this, &StudyModel::move);
    connect(job_, &BackgroundJob::failed, this,
            [this](const QString& why) { show(std::nullopt, named(why)); });
    follow();
}

void StudyModel::follow() {
    refresh();
    if (watched_ && !changeLimits()) {
        outdate();
    }
}

std::string StudyModel::runKey() const {
    Study study = study_;
    for (Watched& each : study.watch) {
        each.min.reset();
        each.max.reset();
    }
    return scene_->inputJson().dump() + scene_->keptJson().dump() +
           scene_->context().directory.string() + studies::write_study(study).dump();
}

bool StudyModel::changeLimits() {
    const bool isUnderWay = last_ != nullptr && (last_->isDone || job_->isRunning());
    if (!isUnderWay || stopped_ || later_.isActive() || isRefused_ || last_->key != runKey()) {
        return false;
    }
    if (last_->limits() != study_.watch) {
        last_->setLimits(study_.watch);
        if (last_->isDone) {
            countWithin(last_);
        }
    }
    return true;
}

void StudyModel::countWithin(const std::shared_ptr<Run>& run) {
    job_->start([this, run](const BackgroundJob::Progress&) -> std::function<void()> {
        if (!studies::change_limits(run->part, run->limits())) {
            return [this] { outdate(); };
        }
        return [this, answers = answersOf(run->part)] { show(answers, {}); };
    });
}

void StudyModel::move() {
    if (!watched_) {
        behind_ = true;
    } else if (scene_->inputJson().dump() != seen_) {
        behind_ = true;
        const bool isFirst = !stale_;
        outdate();
        if (isFirst) {
            Q_EMIT changed();  // sweeps are of the past, too
        }
    }
}

void StudyModel::outdate() {
    seen_ = scene_->inputJson().dump();
    stopped_ = false;
    ++run_;  // what is under way is of the values before
    job_->cancel();
    later_.start();
    stale_ = answers_.has_value();
    Q_EMIT answered();
}

void StudyModel::refresh() {
    behind_ = false;
    readStudy();
    inputs_.clear();
    for (const InputNumber& number : inputNumbers(*scene_)) {
        Input input{number.pointer, number.name, number.unit, number.value, {}, number.shown};
        if (!number.hasLabel) {  // no form names it
            const ResultName name = resultName(number.pointer);
            input.name = capitalised(name.text);
            input.unit = name.unit;
            input.shown = shownUnit(name.unit);
        }
        const auto found =
            std::find_if(study_.vary.begin(), study_.vary.end(),
                         [&](const Varied& varied) { return varied.pointer == input.pointer; });
        if (found != study_.vary.end()) {
            input.varied = *found;
        }
        inputs_.push_back(std::move(input));
    }
    addListed();
    trouble_ = named(trouble_);
    Q_EMIT changed();
}

void StudyModel::addListed() {
    Json input;
    for (const Varied& varied : study_.vary) {
        if (std::any_of(inputs_.begin(), inputs_.end(),
                        [&](const Input& each) { return each.pointer == varied.pointer; })) {
            continue;
        }
        if (input.is_null()) {
            input = scene_->inputJson();
        }
        const Json::json_pointer place(varied.pointer);
        if (input.contains(place) && input.at(place).is_number()) {
            const ResultName name = resultName(varied.pointer);
            inputs_.push_back({varied.pointer, capitalised(name.text), name.unit,
                               input.at(place).get<double>(), varied, shownUnit(name.unit)});
        }
    }
}

void StudyModel::readStudy() {
    trouble_.clear();
    isRefused_ = false;
    study_ = freshStudy();
    if (scene_->study().empty()) {
        return;
    }
    try {
        study_ = studies::read_study(parse_json(scene_->study()), true);
    } catch (const InputError& error) {
        trouble_ = scene_->explain(error) + QLatin1Char('\n') +
                   tr("The study cannot be read: undo, choose another method, or clear it by "
                      "“Usual ones”, “None”.");
        isRefused_ = true;
    }
}

std::vector<StudyModel::Value> StudyModel::results() const {
    std::vector<Value> found;
    collectNumbers(scene_->resultJson(), {}, found);
    return found;
}

QString StudyModel::inputName(const std::string& pointer) const {
    const auto found = std::find_if(inputs_.begin(), inputs_.end(),
                                    [&](const Input& each) { return each.pointer == pointer; });
    return found != inputs_.end() ? found->name : capitalised(resultName(pointer).text);
}

ShownTitle StudyModel::inputTitle(const std::string& pointer) const {
    const auto found = std::find_if(inputs_.begin(), inputs_.end(),
                                    [&](const Input& each) { return each.pointer == pointer; });
    if (found == inputs_.end()) {
        return {inputName(pointer)};
    }
    return {titleWithUnit(found->name, found->shown.name), found->shown.factor};
}

QString StudyModel::named(QString text) const {
    std::vector<std::pair<QString, QString>> names;
    const auto add = [&](const std::string& place, const QString& name) {
        names.emplace_back(QString::fromStdString(place), name);
    };
    for (const Input& input : inputs_) {
        add("/input" + input.pointer, input.name);
        add(studies::vary_place(input.pointer), input.name);
    }
    for (const Varied& varied : study_.vary) {
        add(varied.pointer, inputName(varied.pointer));
    }
    for (const Watched& watched : study_.watch) {
        const QString name = resultName(watched.pointer).text;
        add(watched.pointer, name);
        add(studies::watch_place(watched.pointer), name);
    }
    // The longest first: one may begin as another.
    std::sort(names.begin(), names.end(), [](const auto& one, const auto& other) {
        return one.first.size() > other.first.size();
    });
    for (const auto& [pointer, name] : names) {
        text.replace(pointer, tr("“%1”").arg(name));
    }
    return text;
}

QStringList StudyModel::notes() const {
    QStringList notes;
    for (const Message& note : answers_ ? answers_->notes : std::vector<Message>()) {
        notes << noteText(note);
    }
    return notes;
}

QString StudyModel::failure(const StudyAnswer& answer) const {
    return answer.fails ? noteText(*answer.fails) : QString();
}

QString StudyModel::noteText(const Message& note) const {
    QString text = messageText(note);
    for (const Message& why : answers_ ? answers_->said : std::vector<Message>()) {
        if (!why.verbatim().empty()) {
            text.replace(QString::fromStdString(why.verbatim()), whyText(why, scene_->sceneName()));
        }
    }
    return named(text);
}

std::vector<std::pair<QString, std::uint64_t>> StudyModel::refused() const {
    std::vector<std::pair<QString, std::uint64_t>> all;
    if (answers_) {
        for (const studies::Refusal& refusal : answers_->refused) {
            all.emplace_back(reasonText(refusal.reason), refusal.count);
        }
    }
    return all;
}

QString StudyModel::reasonText(const Reason& reason) const {
    const QString why = whyText(reason.why, scene_->sceneName());
    if (reason.where.empty()) {
        return named(why);
    }
    const std::string inputs = "/input";
    const std::string place = reason.where.english();
    const QString name = place.starts_with(inputs + "/") ? inputName(place.substr(inputs.size()))
                                                         : resultName(place).text;
    return name + QStringLiteral(": ") + why;
}

bool StudyModel::isBusy() const {
    return later_.isActive() || job_->isRunning();
}

void StudyModel::setWatched(bool watched) {
    watched_ = watched;
    if (watched) {
        stopped_ = false;
        seen_ = scene_->inputJson().dump();
        start();
    } else {
        later_.stop();
        job_->cancel();
    }
}

void StudyModel::stop() {
    later_.stop();
    ++run_;
    stopped_ = true;
    job_->cancel();
    Q_EMIT answered();
}

void StudyModel::run() {
    stopped_ = false;
    start();
    Q_EMIT answered();
}

void StudyModel::start() {
    later_.stop();
    ++run_;
    if (behind_) {
        refresh();
    }
    if (!watched_) {
        return;
    }
    if (study_.vary.empty() || study_.watch.empty() || isRefused_) {
        job_->cancel();
        show(std::nullopt, trouble_);
        return;
    }
    CaseFile file = scene_->caseFile();
    file.study = studies::write_study(study_);
    last_ = std::make_shared<Run>();
    last_->key = runKey();
    last_->watch = study_.watch;
    job_->start([this, number = run_, run = last_, file = std::move(file),
                 context = scene_->context()](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        const studies::Problem problem = studies::problem_of(file, context);
        // One core stays free for the window.
        const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
        const auto tell = [&](const studies::Part& so_far) {
            job_->post([this, number, answers = answersOf(so_far)] {
                if (number == run_) {
                    show(answers, {});
                }
            });
        };
        QElapsedTimer sinceTold;
        sinceTold.start();
        studies::Part& part = run->part;
        part = studies::begin_part(problem, 1, 1, threads,
                                   [&](double done, const std::function<studies::Part()>& so_far) {
                                       constexpr qint64 oftenMs = 300;
                                       if (so_far && sinceTold.elapsed() > oftenMs) {
                                           studies::Part now = so_far();
                                           if (now.tally.solved() > 1) {
                                               studies::change_limits(now, run->limits());
                                               tell(now);
                                           }
                                           sinceTold.restart();
                                       }
                                       return progress(done);
                                   });
        if (!progress(studies::share_done(part))) {
            return {};
        }
        studies::keep_values(part, mostNumbers);
        studies::run_part(problem, part, threads, [&](const studies::Part&) {
            if (!progress(studies::share_done(part))) {
                return false;
            }
            studies::change_limits(part, run->limits());
            if (part.tally.solved() > 1 && part.done < part.to) {
                tell(part);
            }
            return true;
        });
        if (!part.finished()) {
            return {};
        }
        studies::change_limits(part, run->limits());
        return [this, run, answers = answersOf(part)] {
            run->isDone = true;
            show(answers, {});
            if (run->part.study.watch != run->limits()) {
                countWithin(run);
            }
        };
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

}  // namespace ravnoves
