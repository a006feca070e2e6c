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

using methods::SweepInfo;

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

}  // namespace

MethodsModel::MethodsModel(QObject* parent)
    : SceneModel(parent),
      choices_(methods::kernels().size()),
      measurements_(new MethodMeasurements(this)) {
    for (std::size_t i = 0; i < choices_.size(); ++i) {
        choices_[i].method = kernels()[i].chosen_method();
    }
    settle_.setSingleShot(true);
    connect(&settle_, &QTimer::timeout, this, &MethodsModel::measureIfNeeded);
    connect(measurements_, &MethodMeasurements::measured, this,
            [this](std::shared_ptr<const MethodMeasurement> measurement) {
                shown_ = std::move(measurement);
                Q_EMIT changed();
            });
    connect(measurements_, &MethodMeasurements::runningChanged, this,
            &MethodsModel::measurementChanged);
    connect(measurements_, &MethodMeasurements::failed, this, &MethodsModel::failed);
}

Json MethodsModel::inputJson() const {
    return Json::object();
}

void MethodsModel::loadFile(const CaseFile& file, const CaseContext& /*context*/,
                            const Json* /*named*/) {
    const Json& input = file.input;
    const std::string place = input.empty() ? "/input" : "/input/" + input.begin().key();
    throw InputError(place,
                     Text::tr("is not a setting of this page; settings: kernel, sweep, value"));
}

Json MethodsModel::resultJson() const {
    Json rows = Json::array();
    if (shown_) {
        for (const methods::MethodRow& row : shown_->report.rows) {
            const auto& method = shown_->kernel().methods[row.method];
            Json entry{{"method", method.id},
                       {"setting", method.settings[row.setting].label.english()},
                       {"in_use", row.in_use},
                       {"median_ns", row.timing.median}};
            if (row.result.rejected()) {
                entry["refusal"] = row.result.rejection.english();
            } else {
                entry["error"] = row.result.error;
            }
            rows.push_back(std::move(entry));
        }
    }
    return Json{{"kernel", shown_ ? shown_->kernel().id : kernel().id}, {"methods", rows}};
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
    measurements_->cancel();
    if (auto known = measurements_->newest(this->kernel())) {
        shown_ = std::move(known);
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
    measurements_->cancel();
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

bool MethodsModel::isStale() const {
    return measurements_->isRunning() || (shown_ && !shown_->isOf(kernel(), sweepIndex(), value()));
}

void MethodsModel::choiceMoved(int delay) {
    Q_EMIT measurementChanged();
    if (active_) {
        settle_.start(delay);
    }
}

void MethodsModel::measureIfNeeded() {
    if (!active_) {
        return;
    }
    if (!shown_ || !shown_->isOf(kernel(), sweepIndex(), value())) {
        measurements_->start(kernel(), sweepIndex(), value(), MeasurementEffort::quick);
    }
}

void MethodsModel::measureAgain() {
    settle_.stop();
    measurements_->start(kernel(), sweepIndex(), value(), MeasurementEffort::thorough);
}

void MethodsModel::cancel() {
    settle_.stop();
    measurements_->cancel();
}

}  // namespace ravnoves
