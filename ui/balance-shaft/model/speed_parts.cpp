// The shaft over a band of speeds.

#include <array>
#include <cmath>
#include <limits>

#include "balance-shaft/model/speed_study_model.h"
#include "text/number_text.h"

namespace ravnoves {

namespace shaft_parts {

namespace {

/// The words of the map.
struct SpeedMapWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SpeedMapPlot)
};

/// Null: nothing is solved.
const SpeedStudyModel* solvedOf(const BalanceShaftModel& model) {
    const SpeedStudyModel* study = model.speedStudy();
    return study != nullptr && study->isSolved() ? study : nullptr;
}

/// The speeds that are seen, min⁻¹.
std::pair<double, double> speedsOf(const BalanceShaftModel& model) {
    if (const SpeedStudyModel* study = solvedOf(model)) {
        const QRectF& where = study->map().where;
        return {where.top(), where.bottom()};
    }
    const balance_shaft::SpeedBand band = SpeedStudyModel::bandOf(model.input());
    return {band.from / units::rpm, band.to / units::rpm};
}

/// Curves of an angle over speed: broken where the angle passes 0, which is no jump.
struct Broken {
    std::vector<double> speed;
    std::vector<double> angle;
};

Broken brokenAtZero(const std::vector<double>& speed, const std::vector<double>& angle) {
    Broken broken;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        if (i > 0 && std::abs(angle[i] - angle[i - 1]) > 180.0) {
            broken.speed.push_back(speed[i]);
            broken.angle.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        broken.speed.push_back(speed[i]);
        broken.angle.push_back(angle[i]);
    }
    return broken;
}

bool isByRange(const BalanceShaftModel& model) {
    return model.speedCriterion() == BalanceShaftModel::Criterion::range;
}

Figure bestAngles(const BalanceShaftModel& model) {
    const auto [lowest, highest] = speedsOf(model);
    Figure figure;
    figure.title = SpeedWords::tr("Best α over speed");
    figure.x = {.title = SpeedWords::tr("n, min⁻¹"), .min = lowest, .max = highest};
    figure.left = {.title = SpeedWords::tr("α, °")};
    figure.leftRange = std::pair(0.0, 360.0);
    const SpeedStudyModel* study = solvedOf(model);
    if (study == nullptr) {
        return figure;
    }
    const auto curves = study->curves();
    const auto add = [&](const char* id, const QString& name, Role role, const QString& tip,
                         const std::vector<double>& angles) {
        Broken broken = brokenAtZero(curves.speed, angles);
        figure.add(id, {.name = name, .role = role, .width = 1.8, .toolTip = tip, .gaps = true},
                   std::move(broken.speed), std::move(broken.angle));
    };
    add("range", SpeedWords::tr("range"), Role::Range,
        SpeedWords::tr("α of the minimum range at each speed"), curves.rangeAngle);
    add("RMS", SpeedWords::tr("RMS"), Role::Rms,
        SpeedWords::tr("α of the minimum RMS at each speed"), curves.rmsAngle);
    const double best = study->bestCompromiseDeg();
    figure.lines = {
        {.at = best,
         .role = Role::Best,
         .text = SpeedWords::tr("best compromise %1°").arg(fixedNumber(best, 1, QLocale()))}};
    figure.bands = unbuildableBands(study->buildable(), Qt::Vertical);
    return figure;
}

Figure speedMap(const BalanceShaftModel& model) {
    Figure figure;
    figure.title = SpeedMapWords::tr("Map over α and speed");
    figure.x = {.title = SpeedMapWords::tr("α, °"), .min = 0.0, .max = 360.0, .degrees = true};
    figure.left = {.title = SpeedMapWords::tr("n, min⁻¹")};
    figure.leftRange = speedsOf(model);
    figure.presentX = model.shaftAngleDeg();
    const SpeedStudyModel* study = solvedOf(model);
    if (study == nullptr) {
        return figure;
    }
    figure.title =
        changeTitle(isByRange(model) ? PlaceCriterion::Kind::Range : PlaceCriterion::Kind::Rms);
    figure.bands = unbuildableBands(study->buildable());
    const auto curves = study->curves();
    Broken line =
        brokenAtZero(curves.speed, isByRange(model) ? curves.rangeAngle : curves.rmsAngle);
    figure.add("best",
               {.name = SpeedWords::tr("best α"), .role = Role::Best, .width = 2.0, .gaps = true},
               std::move(line.angle), std::move(line.speed));
    return figure;
}

Notes bestCompromise(const BalanceShaftModel& model) {
    const SpeedStudyModel* study = model.speedStudy();
    return study != nullptr ? Notes::of(Severity::note, study->answer()) : Notes{};
}

constexpr std::array speedMakers{
    PartMaker<BalanceShaftModel>{{.id = "best-angles", .tab = "speed", .hasBand = false},
                                 made<bestAngles>},
    PartMaker<BalanceShaftModel>{{.id = "speed-map", .tab = "speed", .hasBand = false},
                                 made<speedMap>},
    PartMaker<BalanceShaftModel>{{.id = "least-bad", .tab = "speed", .hasBand = false},
                                 made<bestCompromise>},
};

}  // namespace

}  // namespace shaft_parts

ShaftPartMakers speedParts() {
    return shaft_parts::speedMakers;
}

}  // namespace ravnoves
