#include "balance-shaft/model/balance_shaft_model.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/model/speed_study_model.h"
#include "balance-shaft/result_fields.h"
#include "case-file/result_json.h"
#include "model/background_job.h"
#include "model/case_model_json.h"
#include "numerics/vector_state.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using balance_shaft::FlywheelTarget;
using balance_shaft::GasCycle;
using balance_shaft::Input;
using balance_shaft::MomentMetrics;
using balance_shaft::Optimum;

namespace {

QString number(double value, int decimals) {
    return fixedNumber(value, decimals, QLocale());
}

}  // namespace

QString BalanceShaftScene::defaultTitle() {
    return presetTitle(balance_shaft::presets().front().title);
}

template class CaseModel<BalanceShaftScene>;

BalanceShaftModel::BalanceShaftModel(QObject* parent)
    : CaseModel({}, parent), centreJob_(new BackgroundJob(this)) {}

Json BalanceShaftModel::resultJson() const {
    return result_json({}, input());
}

bool BalanceShaftModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("crank_angle_deg")) {
        return false;
    }
    crank_.turnTo(readNumber(key, value));
    return true;
}

void BalanceShaftModel::takeView(const SceneModel& other) {
    if (const auto* model = qobject_cast<const BalanceShaftModel*>(&other)) {
        setCriterion(model->criterion());
    }
}

void BalanceShaftModel::setCriterion(Criterion criterion) {
    if (std::exchange(criterion_, criterion) != criterion) {
        if (shaftMap_ != nullptr) {
            shaftMap_->showCriterion();
        }
        if (speedStudy_ != nullptr) {
            speedStudy_->showCriterion();
        }
        Q_EMIT viewChanged();
    }
}

void BalanceShaftModel::needPart(std::string_view id) {
    if (id == "places" || id == "best-place" || id == "front") {
        shaftMap()->need();
    } else if (id == "best-angles" || id == "speed-map" || id == "least-bad") {
        speedStudy()->need();
    } else if (id == "notes") {
        needDeadCentre();
    }
}

void BalanceShaftModel::needDeadCentre() {
    const auto seen = [](const Input& input) {
        return std::tie(input.torque.kind, input.torque.trace, input.crank_radius, input.cylinder);
    };
    if (seen(soughtIn_) == seen(input())) {
        return;
    }
    soughtIn_ = input();
    centre_.reset();
    if (soughtIn_.torque.kind != balance_shaft::TorqueSource::Kind::pressure) {
        centreJob_->cancel();
        return;
    }
    centreJob_->start([this, sought = soughtIn_](const BackgroundJob::Progress&) {
        return [this, found = find_dead_centre(sought)] {
            centre_ = found;
            Q_EMIT shownChanged();
        };
    });
}

ShaftMapModel* BalanceShaftModel::shaftMap() {
    if (shaftMap_ == nullptr) {
        shaftMap_ = new ShaftMapModel(this);
    }
    return shaftMap_;
}

SpeedStudyModel* BalanceShaftModel::speedStudy() {
    if (speedStudy_ == nullptr) {
        speedStudy_ = new SpeedStudyModel(this);
    }
    return speedStudy_;
}

QString BalanceShaftModel::setTorqueKind(balance_shaft::TorqueSource::Kind kind) {
    return edit(tr("Torque source"), [&](Input& input) {
        balance_shaft::take_torque_kind(input, kind, -result().M_up.mean);
    });
}

QString BalanceShaftModel::tabulateTorque() {
    return edit(tr("Torque table"), [this](Input& input) {
        balance_shaft::TorqueTable& table = input.torque.table;
        table.crank_angle_deg = result().curves.crank_angle_deg;
        table.torque = result().curves.M_gas;
        const auto& inertia = result().curves.M_inertia;
        std::transform(table.torque.begin(), table.torque.end(), inertia.begin(),
                       table.torque.begin(), std::plus<>());
        table.torque.back() = table.torque.front();  // one instant of the cycle
        input.torque.csv.name.clear();
        input.torque.kind = balance_shaft::TorqueSource::Kind::table;
    });
}

bool BalanceShaftModel::canRebuildTorque() const {
    return !result().inertia_check.warning.empty();
}

QString BalanceShaftModel::rebuildTorque() {
    return edit(tr("Rebuild torque"), [this](Input& input) {
        input = balance_shaft::with_rebuilt_torque(input, result().inertia_check);
    });
}

void BalanceShaftModel::moveTraceByTurn() {
    edit(fieldName(balance_shaft::field::trace_shift), [](Input& input) {
        double& shift = input.torque.trace_shift;
        shift += shift > 0.0 ? -two_pi : two_pi;
    });
}

QString BalanceShaftModel::setLoad(std::optional<double> GasCycle::*given, double value) {
    namespace field = balance_shaft::field;
    return edit(fieldName(given == &GasCycle::heat ? field::heat : field::imep), [&](Input& input) {
        input.torque.cycle.heat.reset();
        input.torque.cycle.imep.reset();
        input.torque.cycle.*given = value;
    });
}

double BalanceShaftModel::shaftAngleDeg() const {
    return input().shaft_angle / degree;
}

void BalanceShaftModel::setShaftAngleDeg(double angle) {
    if (!std::isfinite(angle)) {
        return;
    }
    // A case may have the shaft elsewhere: up to there its slider goes.
    const double now = shaftAngleDeg();
    const double radians = std::clamp(angle, std::min(0.0, now), std::max(360.0, now)) * degree;
    if (radians == input().shaft_angle) {
        return;
    }
    const QString name =
        QCoreApplication::translate("ravnoves::BalanceShaftPage", "Shaft angle &α")
            .remove(QLatin1Char('&'));  // as its slider has it: the field has no label
    // Only the number goes into the history, so that a drag copies no torque table.
    auto* step = new InputCommand<double>(name, input().shaft_angle, radians, stepOf(name),
                                          [this](double a) { applyShaftAngle(a); });
    applyShaftAngle(radians);
    history()->push(step);
}

void BalanceShaftModel::applyShaftAngle(double radians) {
    inputInPlace().shaft_angle = radians;
    clear_vector_state();
    solver().move_shaft(radians, solvedInPlace().result);
    solvedInPlace().gears.reset();
    countSolution();
    Q_EMIT shownChanged();
}

void BalanceShaftModel::pickShaftAngleDeg(double angle) {
    setShaftAngleDeg(std::round(angle * 10.0) / 10.0);
}

const Optimum& BalanceShaftModel::best(Criterion criterion) const {
    const bool any = result().buildable.stretches.empty();
    return criterion == Criterion::range
               ? (any ? result().best_range : result().best_range_buildable)
               : (any ? result().best_rms : result().best_rms_buildable);
}

void BalanceShaftModel::goToBest(Criterion criterion) {
    if (const auto angle = best(criterion).shaft_angle) {
        finishDrag();
        setShaftAngleDeg(*angle / degree);
        finishDrag();
    }
}

QString BalanceShaftModel::setFlywheel(std::optional<double> FlywheelTarget::*given,
                                       std::optional<double> value) {
    const bool isInertia = given == &FlywheelTarget::inertia;
    namespace field = balance_shaft::field;
    return edit(
        fieldName(isInertia ? field::flywheel_inertia : field::fluctuation), [&](Input& input) {
            FlywheelTarget target =
                value ? FlywheelTarget{} : input.flywheel.value_or(FlywheelTarget{});
            target.*given = value;
            input.flywheel = target == FlywheelTarget{} ? std::nullopt : std::optional(target);
        });
}

void BalanceShaftModel::setSpeed(double angularSpeed) {
    drag(fieldName(balance_shaft::field::speed), [&](Input& input) {
        input.angular_speed = angularSpeed;
        input.speed_in_rpm = true;
    });
}

const balance_shaft::GearError& BalanceShaftModel::gearError() const {
    if (!solved().gears) {
        clear_vector_state();
        solved().gears = balance_shaft::gear_error(solver(), input().shaft_angle);
    }
    return *solved().gears;
}

const balance_shaft::EnvelopeStudy& BalanceShaftModel::envelopeStudy() const {
    auto& study = solved().envelopes;
    clear_vector_state();
    return study ? *study : study.emplace(balance_shaft::envelope_study(solver()));
}

double BalanceShaftModel::mass(const std::string& name) const {
    const auto& parts = input().reciprocating_masses;
    const auto part = std::ranges::find(parts, name, &balance_shaft::NamedMass::name);
    return part != parts.end() ? part->mass : 0.0;
}

double BalanceShaftModel::otherMasses() const {
    const auto& listed = balance_shaft::field::mass_parts;
    double sum = 0.0;
    for (const balance_shaft::NamedMass& part : input().reciprocating_masses) {
        const bool isListed = std::any_of(listed.begin(), listed.end(),
                                          [&](const Field& row) { return row.key == part.name; });
        sum += isListed ? 0.0 : part.mass;
    }
    return sum;
}

Results BalanceShaftModel::criteria() const {
    const auto moment = [](double value) { return shownCell(value, units::N_m, 1); };
    double scale = 0.0;
    for (const MomentMetrics* each : {&result().M_up, &result().M_s, &result().M_ups}) {
        scale = std::max({scale, std::abs(each->max), std::abs(each->min)});
    }
    // Rounding noise changes by nothing that has a meaning.
    const auto relative = [&](double with, double without) -> std::optional<double> {
        constexpr double rounding = 1e-9;
        if (std::abs(without) <= rounding * scale) {
            return std::nullopt;
        }
        return balance_shaft::relative_change(without, with);
    };
    const auto percent = [](const std::optional<double>& fraction) {
        return fraction ? ResultCell(*fraction / units::percent, signedPercentText(*fraction),
                                     ResultCell::Kind::Change)
                        : ResultCell(QStringLiteral("–"));
    };
    const auto change = [&](double MomentMetrics::*value) {
        const auto fraction = relative(result().M_ups.*value, result().M_up.*value);
        const double rounded = fraction ? std::round(1e3 * *fraction) / 10.0 : 0.0;
        if (rounded == 0.0 || value == &MomentMetrics::mean) {
            return percent(fraction);
        }
        // The sign of a change does not say whether it is a good one.
        const QString size = percentText(std::abs(*fraction), std::abs(rounded) < 100.0 ? 1 : 0);
        return ResultCell((rounded < 0.0) == (value != &MomentMetrics::min)
                              ? tr("%1 better").arg(size)
                              : tr("%1 worse").arg(size));
    };
    const auto row = [&](const QString& name, double MomentMetrics::*value, const QString& tip) {
        ResultCell ups = moment(result().M_ups.*value);
        ups.isSmallerBetter = value == &MomentMetrics::range || value == &MomentMetrics::rms;
        return ResultRow(
            {name, moment(result().M_up.*value), moment(result().M_s.*value), ups, change(value)},
            tip);
    };
    Results results{{
        shownUnit(units::N_m).name,
        {tr("Mᵤₚ"), tr("Tipping moment on the engine without a shaft, −Mᵢ")},
        {tr("Mₛ"), tr("Moment of the shaft, P₁ l sin(α + φ)")},
        {tr("Mᵤₚₛ"), tr("Moment on the mounts with the shaft, Mᵤₚ + Mₛ")},
        {tr("change"), tr("Change from Mᵤₚ to Mᵤₚₛ, relative to Mᵤₚ. Better: smaller range, RMS "
                          "and maximum, minimum nearer to zero.")},
    }};
    results.rows = {
        row(tr("range"), &MomentMetrics::range, tr("Maximum minus minimum over the cycle")),
        row(tr("RMS"), &MomentMetrics::rms, tr("RMS about the mean over the cycle")),
        row(tr("mean"), &MomentMetrics::mean,
            tr("Mean over the cycle; for the shaft 0 at every α")),
        row(tr("max"), &MomentMetrics::max, tr("Maximum over the cycle")),
        row(tr("min"), &MomentMetrics::min,
            tr("Minimum over the cycle; usually negative, nearer to zero is better"))};
    static const balance_shaft::TorqueTable printed = balance_shaft::preset_tmz_650d().torque.table;
    if (!input().torque.is_computed() && input().torque.table == printed) {
        results.rows.push_back(
            {{tr("nodes"), moment(result().printed_mean_M_up), moment(result().printed_mean_M_s),
              moment(result().printed_mean_M_ups),
              percent(relative(result().printed_mean_M_ups, result().printed_mean_M_up))},
             tr("Mean of table rows (paper), with the end of the cycle counted twice. It "
                "reproduces the paper's numbers only.")});
    }
    return results;
}

Results BalanceShaftModel::quantities() const {
    namespace key = balance_shaft::result_field;
    const auto& share = result().order_1_share;
    Results results{{tr("Quantity"), tr("Value"), tr("Unit")}};
    results.rows = {
        shownRow(key::inertia_force_1_max, result().inertia_force_1_max),
        shownRow(key::counterweight_mass, result().counterweight_mass),
        shownRow(key::counterweight_force, result().counterweight_force),
        shownRow(key::shaft_bearing_load, result().counterweight_force),
        shownRow(key::moment_amplitude, result().moment_amplitude),
        {{tr("First order's share of Mᵤₚ"),
          share ? ResultCell(*share / units::percent, number(*share / units::percent, 1))
                : ResultCell(QStringLiteral("–")),
          QStringLiteral("%")},
         tr("Share of the mean square about the mean; only this share can be changed by a shaft at "
            "crank speed.")},
        {{tr("Envelope, width × height"),
          ResultCell::two(QStringLiteral("%1 × %2"),
                          shownCell(result().envelope.width(), units::mm, 0),
                          shownCell(result().envelope.height(), units::mm, 0)),
          shownUnit(units::mm).name},
         tr("Box around cylinder, crank circle, shaft circle, gears and wall in the front view")},
    };
    return results;
}

Results BalanceShaftModel::cycle() const {
    namespace key = balance_shaft::result_field;
    Results results{{tr("Cycle"), tr("Value"), tr("Unit")}};
    if (!result().indicated) {
        return results;
    }
    const balance_shaft::IndicatedCycle& cycle = *result().indicated;
    results.rows = {
        shownRow(key::mean_effective_pressure, cycle.imep),
        shownRow(key::work, cycle.work),
        shownRow(key::power, result().indicated_power),
        shownRow(key::mean_torque, result().indicated_power / result().angular_speed),
        shownRow(key::peak_pressure, cycle.peak_pressure),
        shownRow(key::peak_pressure_crank_angle, cycle.peak_pressure_angle),
        shownRow(key::displacement, cycle.displacement),
        shownRow(key::clearance_volume, cycle.clearance),
        shownRow(key::heat, cycle.heat),
    };
    results.rows.removeIf([](const ResultRow& row) { return row.isBlank(); });
    return results;
}

Results BalanceShaftModel::flywheel() const {
    namespace key = balance_shaft::result_field;
    const balance_shaft::Flywheel& wheel = result().flywheel;
    const auto angle = [](const QString& name, double radians, const QString& tip) {
        return shownRow(name, radians, units::degree, 1, tip);
    };
    // Half of δ to each side of the mean speed.
    ResultRow swing = shownRow(tr("speed fluctuates by ±"),
                               wheel.fluctuation.value_or(0.0) * result().angular_speed / 2.0,
                               units::rpm, 1, tr("± half of δ n about the mean speed"));
    if (!wheel.fluctuation) {
        swing[1] = QStringLiteral("–");
    }
    Results results{{tr("Flywheel"), tr("Value"), tr("Unit")}};
    results.rows = {
        shownRow(key::excess_work, wheel.excess_work),
        shownRow(key::fluctuation, wheel.fluctuation),
        shownRow(key::inertia, wheel.inertia),
        swing,
        angle(tr("maximum speed at crank angle"), wheel.max_angle,
              tr("Crank angle of the maximum excess energy")),
        angle(tr("minimum speed at crank angle"), wheel.min_angle,
              tr("Crank angle of the minimum excess energy")),
    };
    return results;
}

std::vector<std::string> BalanceShaftModel::replacedInputs() const {
    using Kind = balance_shaft::TorqueSource::Kind;
    return input().torque.kind == Kind::cycle ? std::vector<std::string>{"/interpolation"}
                                              : std::vector<std::string>();
}

QString BalanceShaftModel::bestText(Criterion criterion) const {
    const Optimum& found = best(criterion);
    if (!found.shaft_angle) {
        return tr("α has no effect.");
    }
    const bool byRange = criterion == Criterion::range;
    const Optimum& all = byRange ? result().best_range : result().best_rms;
    QString text =
        (byRange ? tr("Minimum range %2 at %1°") : tr("Minimum RMS %2 at %1°"))
            .arg(number(*found.shaft_angle / degree, 2), shownNumber(found.value, units::N_m, 1));
    if (!found.note.empty()) {
        text += QLatin1Char('\n') + messageText(found.note);
    }
    if (result().buildable.stretches.empty()) {
        text += tr("\nbut at this l no α is feasible");
    } else if (const ResultCell less = shownCell(found.value - all.value, units::N_m, 1);
               all.shaft_angle && less.text != shownCell(0.0, units::N_m, 1).text) {
        text += QLatin1Char('\n') + tr("%1° would give %2 less but does not fit")
                                        .arg(number(*all.shaft_angle / degree, 2),
                                             withUnit(less.text, shownUnit(units::N_m).name));
    }
    return text;
}

QString BalanceShaftModel::notesText() const {
    std::vector<Message> notes = result().notes;
    if (Message note = dead_centre_note(input(), centre_); !note.empty()) {
        notes.insert(notes.begin(), std::move(note));
    }
    return messageLines(notes);
}

}  // namespace ravnoves
