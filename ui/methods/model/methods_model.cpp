#include "methods/model/methods_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/case_file.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/range.h"

namespace ravnoves {

using methods::Kernel;
using methods::MeasureOptions;
using methods::StabilityMap;

namespace {

constexpr int settleMs = 350;

template <typename List>
std::size_t indexOf(const List& list, const QString& word, const char* place) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (word == QString::fromStdString(list[i].id)) {
            return i;
        }
        known.push_back(list[i].id);
    }
    throw InputError(place, {Text::tr("must be one of %1"), quoted_list(known)},
                     word.toStdString());
}

/// About a second: by itself, when something was chosen.
constexpr MeasureOptions quick{.batch_seconds = 1e-4, .batches = 9, .max_seconds = 0.03};

constexpr double workShare = 0.6;  ///< of the progress

/// @param known  null: the errors along the sweep, too, are to be found
std::shared_ptr<const MethodMeasurement> measured(const Kernel& kernel, std::size_t sweep,
                                                  double value, const MeasureOptions& options,
                                                  std::shared_ptr<const StabilityMap> known,
                                                  const BackgroundJob::Progress& progress) {
    const double share = known ? 1.0 : workShare;
    auto report = methods::measure_work(kernel, sweep, value, options,
                                        [&](double part) { return progress(share * part); });
    if (!known) {
        known = std::make_shared<const StabilityMap>(methods::map_stability(
            kernel, sweep, options,
            [&](double part) { return progress(workShare + (1.0 - workShare) * part); }));
    }
    add_failing(report, *known);
    return std::make_shared<const MethodMeasurement>(
        MethodMeasurement{std::move(known), std::move(report)});
}

}  // namespace

MethodsModel::MethodsModel(QObject* parent)
    : SceneModel(parent), choices_(methods::kernels().size()), measuring_(new BackgroundJob(this)) {
    for (std::size_t i = 0; i < choices_.size(); ++i) {
        choices_[i].method = kernels()[i].chosen_method();
    }
    settle_.setSingleShot(true);
    connect(&settle_, &QTimer::timeout, this, &MethodsModel::measureIfNeeded);
    connect(measuring_, &BackgroundJob::runningChanged, this, &MethodsModel::measurementChanged);
    connect(measuring_, &BackgroundJob::failed, this, &MethodsModel::failed);
}

Json MethodsModel::inputJson() const {
    return Json::object();
}

Json MethodsModel::resultJson() const {
    return Json::object();
}

void MethodsModel::loadFile(const CaseFile& file, const CaseContext& /*context*/,
                            bool /*isNamed*/) {
    const Json& input = file.input;
    const std::string place = input.empty() ? "/input" : "/input/" + input.begin().key();
    throw InputError(place,
                     Text::tr("is not a setting of this page; settings: kernel, sweep, value"));
}

bool MethodsModel::setViewOption(const QString& key, const QString& value) {
    if (key == QLatin1String("kernel")) {
        setKernel(indexOf(kernels(), value, "kernel"));
        return true;
    }
    if (key == QLatin1String("sweep")) {
        setSweep(indexOf(kernel().sweeps, value, "sweep"));
        return true;
    }
    if (key == QLatin1String("value")) {
        const Range allowed = Range::between(sweep().from, sweep().to);
        const auto number = parse_decimal(value.toStdString());
        if (!number || !allowed.contains(*number)) {
            throw InputError("value", allowed.message(), value.toStdString());
        }
        setValue(*number);
        choiceMoved(0);  // no hand is moving it
        return true;
    }
    return false;
}

void MethodsModel::setActive(bool active) {
    active_ = active;
    if (active) {
        measureIfNeeded();
    } else {
        cancel();
    }
}

void MethodsModel::setKernel(std::size_t kernel) {
    if (kernel == kernel_ || kernel >= kernels().size()) {
        return;
    }
    before_.reset();
    kernel_ = kernel;
    measuring_->cancel();
    if (chosen().newest) {
        shown_ = chosen().newest;
    }
    Q_EMIT kernelChanged();
    Q_EMIT changed();
    measureIfNeeded();
}

void MethodsModel::setSweep(std::size_t sweep) {
    if (sweep == sweepIndex() || sweep >= kernel().sweeps.size()) {
        return;
    }
    before_.reset();
    chosen().sweep = sweep;
    chosen().value.reset();
    measuring_->cancel();
    Q_EMIT sweepChanged();
    choiceMoved(0);
}

void MethodsModel::setValue(double value) {
    value = std::clamp(value, sweep().from, sweep().to);
    if (chosen().value == value || !std::isfinite(value)) {
        return;
    }
    if (isEditing() && !before_) {
        before_ = this->value();
    }
    chosen().value = value;
    Q_EMIT valueChanged(value);
    choiceMoved(settleMs);
}

bool MethodsModel::takeBack() {
    if (!before_) {
        return false;
    }
    chosen().value = std::exchange(before_, std::nullopt);
    Q_EMIT valueChanged(value());
    choiceMoved(settleMs);
    return true;
}

void MethodsModel::setShownMethod(std::size_t method) {
    if (method != shownMethod() && method < kernel().methods.size()) {
        chosen().method = method;
        Q_EMIT shownMethodChanged();
    }
}

bool MethodsModel::isOfChoice(const MethodMeasurement& measurement) const {
    const methods::KernelReport& report = measurement.report;
    return report.kernel == &kernel() && report.sweep == sweepIndex() && report.value == value();
}

bool MethodsModel::isStale() const {
    return measuring_->isRunning() || (shown_ && !isOfChoice(*shown_));
}

void MethodsModel::choiceMoved(int delay) {
    Q_EMIT measurementChanged();
    if (active_) {
        settle_.start(delay);
    }
}

void MethodsModel::measureIfNeeded() {
    if (active_ && !(shown_ && isOfChoice(*shown_))) {
        measure(quick);
    }
}

void MethodsModel::measure(const MeasureOptions& options) {
    measuring_->start([this, &kernel = kernel(), sweep = sweepIndex(), value = value(), options,
                       known = chosen().maps[sweepIndex()]](const auto& progress) {
        auto measurement = measured(kernel, sweep, value, options, known, progress);
        return [this, measurement] { show(measurement); };
    });
}

void MethodsModel::show(std::shared_ptr<const MethodMeasurement> measurement) {
    chosen().maps[measurement->report.sweep] = measurement->map;
    chosen().newest = measurement;
    shown_ = std::move(measurement);
    Q_EMIT changed();
}

void MethodsModel::measureAgain() {
    settle_.stop();
    measure({});  // as the command line does
}

void MethodsModel::cancel() {
    settle_.stop();
    measuring_->cancel();
}

}  // namespace ravnoves
