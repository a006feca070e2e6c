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
#include "text/number_text.h"

namespace ravnoves {

using studies::Study;
using studies::Varied;
using studies::Watched;

namespace {

constexpr std::size_t bars = 48;
constexpr std::size_t mostKept = 2000;            ///< samples, to be seen
constexpr std::uint64_t mostNumbers = 4'000'000;  ///< watched ones, kept for other limits
constexpr int restMs = 250;

std::optional<double> numberAt(const Json& json, const char* key) {
    return json.contains(key) && json[key].is_number() ? std::optional(json[key].get<double>())
                                                       : std::nullopt;
}

/// A study of the window begins small: it answers while one looks.
Study freshStudy() {
    Study study;
    study.samples = 4096;
    return study;
}

StudyAnswer answerOf(const Watched& watched, std::size_t place, const Json& found,
                     const studies::Part& part) {
    StudyAnswer answer;
    answer.pointer = watched.pointer;
    answer.nominal = numberAt(found, "nominal");
    answer.mean = numberAt(found, "mean");
    answer.deviation = numberAt(found, "standard_deviation");
    if (found.contains("percentiles") && found["percentiles"].is_object()) {
        answer.low = numberAt(found["percentiles"], "5");
        answer.high = numberAt(found["percentiles"], "95");
    }
    if (found.contains("within") && found["within"].is_object()) {
        answer.within = numberAt(found["within"], "share");
        answer.withinLow = numberAt(found["within"], "low");
        answer.withinHigh = numberAt(found["within"], "high");
    }
    const auto object = [&](const char* key) {
        return found.contains(key) && found[key].is_object() ? found[key] : Json::object();
    };
    const Json linear = object("linear");
    answer.linearDeviation = numberAt(linear, "standard_deviation");
    const Json contributions =
        linear.contains("contributions") ? linear["contributions"] : Json::object();
    const Json first = object("first_order");
    const Json total = object("total");
    for (const Varied& varied : part.study.vary) {
        const char* key = varied.pointer.c_str();
        answer.shares.push_back({varied.pointer, numberAt(contributions, key), numberAt(first, key),
                                 numberAt(total, key)});
    }
    if (studies::is_sampled(part.study.method) && part.tally.solved() > 1) {
        const studies::Statistics statistics = part.tally.statistics(place);
        const double low = statistics.percentiles.front();
        const double high = statistics.percentiles.back();
        if (high > low) {
            const auto counts = part.tally.histogram(place, low, high, bars);
            const double width = (high - low) / static_cast<double>(counts.size());
            for (std::size_t i = 0; i < counts.size(); ++i) {
                answer.middles.push_back(low + (static_cast<double>(i) + 0.5) * width);
                answer.heights.push_back(static_cast<double>(counts[i]) /
                                         static_cast<double>(part.tally.solved()));
            }
        }
    }
    return answer;
}

StudyAnswers answersOf(const studies::Part& part) {
    const Json results = studies::write_results(part);
    StudyAnswers answers;
    answers.solved = results.value("solved", std::uint64_t{0});
    answers.refused = studies::refusals_of(part);
    const std::vector<studies::Note> notes = studies::noted(part);
    for (const studies::Note& note : notes) {
        answers.notes.push_back(note.text);
    }
    for (const studies::Departure& departure : part.basis.departures) {
        answers.said.push_back(departure.reason.why);
    }
    if (!results.contains("watched")) {
        return answers;  // a grid is a table, nothing scatters
    }
    const Json& watched = results.at("watched");
    for (std::size_t i = 0; i < part.study.watch.size(); ++i) {
        const Watched& each = part.study.watch[i];
        if (watched.contains(each.pointer)) {
            answers.values.push_back(answerOf(each, i, watched[each.pointer], part));
            for (const studies::Note& note : notes) {
                if (note.fails == i) {
                    answers.values.back().fails = note.text;
                }
            }
        }
    }
    answers.samples = studies::first_samples(part, mostKept);
    return answers;
}

/// Why something does not exist, in the language of the program. Of what a result says in English,
/// what holds no values is known.
QString whyText(const Message& why, const QString& scene) {
    if (why.verbatim().empty()) {
        return messageText(why);
    }
    QString english = QString::fromStdString(why.verbatim());
    for (const QByteArray& context : {QByteArray("core"), scene.toUtf8(), QByteArray("studies")}) {
        QString text =
            QCoreApplication::translate(context.constData(), why.verbatim().c_str());
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

QString StudyModel::scatterText(const Input& input) {
    const std::optional<Varied>& varied = input.varied;
    if (!varied) {
        return {};
    }
    const QLocale locale;
    const double factor = input.shown.factor;
    const auto written = [&](double value) {
        constexpr int converted = 6;  // digits
        return factor == 1.0 ? shownFormNumber(value, locale)
                             : shownFormNumber(factor * value, locale, converted);
    };
    switch (varied->spread) {
        case Varied::Spread::plus_minus:
            return written(varied->size);
        case Varied::Spread::plus_minus_percent:
            return shownFormNumber(varied->size, locale) + QStringLiteral(" %");
        case Varied::Spread::normal:
            return QStringLiteral("σ ") + written(varied->size);
        case Varied::Spread::uniform:
            return written(varied->from) + QStringLiteral(" … ") + written(varied->to);
        case Varied::Spread::grid:
            break;
    }
    QStringList values;
    for (const double value : varied->values) {
        values << written(value);
    }
    return values.join(QStringLiteral("; "));
}

QString StudyModel::nominalText(const Input& input) {
    constexpr int digits = 8;
    return withUnit(shownFormNumber(input.shown.factor * input.nominal, QLocale(), digits),
                    input.shown.name);
}

QString StudyModel::setScatter(const std::vector<std::pair<std::string, QString>>& texts) {
    if (isRefused_) {
        return trouble_;
    }
    Study next = study_;
    for (const auto& entry : texts) {
        const std::string& pointer = entry.first;
        const QString& text = entry.second;
        const auto there =
            std::find_if(next.vary.begin(), next.vary.end(),
                         [&](const Varied& varied) { return varied.pointer == pointer; });
        QString rest = text.trimmed();
        if (rest.isEmpty()) {
            if (there != next.vary.end()) {
                next.vary.erase(there);
            }
            continue;
        }
        Varied varied{.pointer = pointer};
        if (rest.endsWith(QLatin1Char('%'))) {
            varied.spread = Varied::Spread::plus_minus_percent;
            rest.chop(1);
        } else if (rest.startsWith(QChar(0x03C3)) ||
                   rest.startsWith(QLatin1Char('s'), Qt::CaseInsensitive)) {
            varied.spread = Varied::Spread::normal;
            rest.remove(0, 1);
        }
        if (rest.startsWith(QChar(0x00B1))) {
            rest.remove(0, 1);
        }
        const auto number = readFormNumber(rest);
        if (!number || !(*number > 0.0)) {
            return tr("A tolerance is a number greater than 0: 0.02, 1 %, or σ 0.01 for a standard "
                      "deviation; %1 is none.")
                .arg(text.trimmed());
        }
        const auto input = std::find_if(inputs_.begin(), inputs_.end(),
                                        [&](const Input& each) { return each.pointer == pointer; });
        const double factor =
            varied.spread == Varied::Spread::plus_minus_percent || input == inputs_.end()
                ? 1.0
                : input->shown.factor;
        constexpr int digits = 12;
        varied.size = factor == 1.0 ? *number : rounded_to(*number / factor, digits);
        (there != next.vary.end() ? *there : next.vary.emplace_back()) = varied;
    }
    change(tr("Tolerance"), next);
    return {};
}

void StudyModel::take(Preset preset) {
    Study next = study_;
    const auto unitOf = [](const std::string& pointer, const char* suffix) {
        return pointer.ends_with(suffix);
    };
    for (const Input& input : inputs_) {
        Varied varied{.pointer = input.pointer};
        if (preset == Preset::OnePercent && input.nominal != 0.0) {
            varied.spread = Varied::Spread::plus_minus_percent;
            varied.size = 1.0;
        } else if (preset == Preset::Weighed && unitOf(input.unit.toStdString(), "kg")) {
            varied.size = 0.0005;
        } else if (preset == Preset::Weighed && input.unit == unitText("g")) {
            varied.size = 0.5;
        } else if (preset == Preset::Machined && input.unit == unitText("mm")) {
            varied.size = 0.05;
        } else {
            continue;
        }
        std::erase_if(next.vary, [&](const Varied& each) { return each.pointer == input.pointer; });
        next.vary.push_back(varied);
    }
    change(tr("Tolerances"), next);
}

void StudyModel::clear() {
    scene_->changeStudy(tr("Tolerances"), {});
}

void StudyModel::watch(const std::string& pointer) {
    Study next = study_;
    if (std::none_of(next.watch.begin(), next.watch.end(),
                     [&](const Watched& each) { return each.pointer == pointer; })) {
        next.watch.push_back({pointer});
        change(tr("Watch a result"), next);
    }
}

void StudyModel::unwatch(const std::string& pointer) {
    Study next = study_;
    std::erase_if(next.watch, [&](const Watched& each) { return each.pointer == pointer; });
    change(tr("Watch a result"), next);
}

QString StudyModel::setLimits(const std::vector<Watched>& limits) {
    if (isRefused_) {
        return trouble_;
    }
    Study next = study_;
    for (const Watched& limit : limits) {
        if (limit.min && limit.max && *limit.min > *limit.max) {
            return tr("The lower limit is above the upper one.");
        }
        std::replace_if(
            next.watch.begin(), next.watch.end(),
            [&](const Watched& each) { return each.pointer == limit.pointer; }, limit);
    }
    change(tr("Limits"), next);
    return {};
}

bool StudyModel::hasGrid() const {
    return std::any_of(study_.vary.begin(), study_.vary.end(),
                       [](const Varied& each) { return each.spread == Varied::Spread::grid; });
}

void StudyModel::setMethod(studies::Method method) {
    if (isRefused_) {
        try {
            Json raw = parse_json(scene_->study());
            if (raw.is_object()) {
                raw["method"] = studies::method_words()[static_cast<std::size_t>(method)].word;
                scene_->changeStudy(tr("Method"), raw.dump());
            }
        } catch (const InputError&) {
            Q_EMIT changed();  // it is no JSON at all: the method stays
        }
        return;
    }
    Study next = study_;
    next.method = method;
    if (method != studies::Method::grid) {
        for (Varied& each : next.vary) {
            if (each.spread == Varied::Spread::grid) {
                const auto [low, high] =
                    std::minmax_element(each.values.begin(), each.values.end());
                each = {.pointer = each.pointer,
                        .spread = Varied::Spread::uniform,
                        .from = *low,
                        .to = *high};
            }
        }
        std::erase_if(next.vary, [](const Varied& each) {
            return each.spread == Varied::Spread::uniform && !(each.to > each.from);
        });
    } else if (!hasGrid()) {
        Q_EMIT changed();  // what was chosen goes back
        return;
    }
    change(tr("Method"), next);
}

void StudyModel::setSamples(std::uint64_t samples) {
    Study next = study_;
    next.samples = samples;
    change(tr("Samples"), next);
}

void StudyModel::change(const QString& name, Study next) {
    if (isRefused_) {
        return;  // nothing goes over what was not understood
    }
    // Listed values and tolerances do not go together.
    const auto isGrid = [](const Varied& each) { return each.spread == Varied::Spread::grid; };
    if (!std::all_of(next.vary.begin(), next.vary.end(), isGrid)) {
        std::erase_if(next.vary, isGrid);
    }
    if (next.method == studies::Method::grid &&
        std::none_of(next.vary.begin(), next.vary.end(), isGrid)) {
        next.method = studies::Method::sobol;
    }
    if (next == study_) {
        return;
    }
    const bool isEmpty = next.vary.empty() && next.watch.empty();
    if (copy_ != nullptr) {
        copy_->study = isEmpty ? Json() : studies::write_study(next);
        return;
    }
    scene_->changeStudy(name, isEmpty ? std::string() : studies::write_study(next).dump());
}

void StudyModel::putTyped(CaseFile& file, const std::function<QString()>& take) {
    copy_ = &file;
    take();
    copy_ = nullptr;
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
