#include "balance-shaft/model/shaft_parts.h"

#include <array>

#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/model/speed_study_model.h"
#include "numerics/constants.h"

namespace ravnoves {

namespace {

using Model = BalanceShaftModel;

template <Model::Criterion criterion>
Notes bestAngle(const Model& model) {
    Notes notes;  // one line: a report says none twice
    notes.say(Severity::note, model.bestText(criterion));
    return notes;
}

Notes notes(const Model& model) {
    return Notes::of(Severity::note, model.notesText());
}

Notes bestPlace(const Model& model) {
    const ShaftMapModel* map = model.shaftMap();
    return map != nullptr ? Notes::of(Severity::note, map->answer()) : Notes();
}

Notes bestCompromise(const Model& model) {
    const SpeedStudyModel* study = model.speedStudy();
    return study != nullptr ? Notes::of(Severity::note, study->answer()) : Notes{};
}

using Maker = PartMaker<Model>;
constexpr std::array makers{
    Maker{{.id = "criteria", .isAnswer = true}, made<&Model::criteria>},
    Maker{{.id = "best-range", .isAnswer = true}, made<bestAngle<Model::Criterion::range>>},
    Maker{{.id = "best-rms", .isAnswer = true}, made<bestAngle<Model::Criterion::rms>>},
    Maker{{.id = "quantities", .isAnswer = true}, made<&Model::quantities>},
    Maker{{.id = "notes"}, made<notes>},
    Maker{{.id = "moments", .tab = "moments"}, made<shaft_parts::moments>},
    Maker{{.id = "range", .tab = "moments"}, made<shaft_parts::range>},
    Maker{{.id = "means", .tab = "moments"}, made<shaft_parts::means>},
    Maker{{.id = "places", .tab = "map", .hasBand = false}, made<shaft_parts::places>},
    Maker{{.id = "best-place", .tab = "map", .hasBand = false}, made<bestPlace>},
    Maker{{.id = "front", .tab = "map", .hasBand = false}, made<shaft_parts::front>},
    Maker{{.id = "torque", .tab = "cycle"}, made<shaft_parts::torque>},
    Maker{{.id = "pressure", .tab = "cycle"}, made<shaft_parts::pressure>},
    Maker{{.id = "indicator", .tab = "cycle"}, made<shaft_parts::indicator>},
    Maker{{.id = "cycle", .tab = "cycle"}, made<&Model::cycle>},
    Maker{{.id = "best-angles", .tab = "speed", .hasBand = false}, made<shaft_parts::bestAngles>},
    Maker{{.id = "speed-map", .tab = "speed", .hasBand = false}, made<shaft_parts::speedMap>},
    Maker{{.id = "least-bad", .tab = "speed", .hasBand = false}, made<bestCompromise>},
    Maker{{.id = "sizes", .tab = "envelope"}, made<shaft_parts::sizes>},
    Maker{{.id = "range-over-size", .tab = "envelope"}, made<shaft_parts::rangeOverSize>},
    Maker{{.id = "orders", .tab = "orders"}, made<shaft_parts::orders>},
    Maker{{.id = "order-table", .tab = "orders"}, made<shaft_parts::orderTable>},
    Maker{{.id = "energy", .tab = "flywheel"}, made<shaft_parts::energy>},
    Maker{{.id = "flywheel", .tab = "flywheel"}, made<&Model::flywheel>},
    Maker{{.id = "force-locus", .tab = "forces"}, made<shaft_parts::forceLocus>},
    Maker{{.id = "gear-moment", .tab = "forces"}, made<shaft_parts::gearMoment>},
    Maker{{.id = "forces", .tab = "forces"}, made<shaft_parts::forces>},
    Maker{{.id = "gears", .tab = "forces"}, made<shaft_parts::gears>},
    Maker{{.id = "relief", .tab = "relieved"}, made<shaft_parts::relief>},
    Maker{{.id = "relief-verdict", .tab = "relieved"}, made<shaft_parts::reliefVerdict>},
};

}  // namespace

std::span<const PagePart> shaftParts() {
    return partsOf(makers);
}

Content shaftPart(const BalanceShaftModel& model, std::string_view id) {
    return makePart(makers, model, id);
}

std::vector<plot::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                         Qt::Orientation orientation) {
    const QString text = BalanceShaftModel::tr("does not fit");
    std::vector<plot::Band> bands;
    for (const balance_shaft::AngleStretch& gap : buildable.gaps()) {
        bands.push_back(
            {gap.from / degree, gap.to / degree, Role::Forbidden, 0.13, text, orientation});
    }
    return bands;
}

Figure overCycle(const BalanceShaftModel& model, const QString& title, const QString& unit) {
    return {.title = title,
            .x = {.title = ShaftParts::tr("φ, °"),
                  .min = 0.0,
                  .max = model.cycleDeg(),
                  .degrees = true},
            .left = {.title = unit}};
}

Figure overAngle(const BalanceShaftModel& model, const QString& title, const QString& unit) {
    return {
        .title = title,
        .x = {.title = ShaftParts::tr("α, °"), .min = 0.0, .max = 360.0, .degrees = true},
        .left = {.title = unit},
        .bands = unbuildableBands(model.result().buildable),
        .presentX = model.shaftAngleDeg(),
    };
}

std::vector<double> inUnit(std::vector<double> values, const Unit& unit) {
    for (double& value : values) {
        value /= unit.to_si;
    }
    return values;
}

QString changeTitle(Model::Criterion criterion) {
    return criterion == Model::Criterion::range ? ShaftParts::tr("Change in range vs. no shaft, %")
                                                : ShaftParts::tr("Change in RMS vs. no shaft, %");
}

}  // namespace ravnoves
