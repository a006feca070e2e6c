#include "balance-shaft/model/shaft_parts.h"

#include <vector>

#include "balance-shaft/model/balance_shaft_model.h"
#include "numerics/constants.h"

namespace ravnoves {

namespace {

const std::vector<PartMaker<BalanceShaftModel>>& makers() {
    static const auto all = [] {
        std::vector<PartMaker<BalanceShaftModel>> found;
        for (const auto parts :
             {momentParts, mapParts, cycleParts, speedParts, sizeParts, orderParts, forceParts}) {
            const ShaftPartMakers some = parts();
            found.insert(found.end(), some.begin(), some.end());
        }
        return found;
    }();
    return all;
}

}  // namespace

std::span<const PagePart> shaftParts() {
    return partsOf(makers());
}

Content shaftPart(const BalanceShaftModel& model, std::string_view id) {
    return makePart(makers(), model, id);
}

std::vector<plot::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                         Qt::Orientation orientation) {
    const QString text = QCoreApplication::translate("ravnoves::BalanceShaftModel", "does not fit");
    std::vector<plot::Band> bands;
    for (const balance_shaft::AngleStretch& gap : buildable.gaps()) {
        bands.push_back(
            {gap.from / degree, gap.to / degree, Role::Forbidden, 0.13, text, orientation});
    }
    return bands;
}

Figure overCycle(const BalanceShaftModel& model, const QString& title, const QString& unit) {
    return {.title = title,
            .x = {.title = MomentWords::tr("φ, °"),
                  .min = 0.0,
                  .max = model.cycleDeg(),
                  .degrees = true},
            .left = {.title = unit}};
}

Figure overAngle(const BalanceShaftModel& model, const QString& title, const QString& unit) {
    return {
        .title = title,
        .x = {.title = MomentWords::tr("α, °"), .min = 0.0, .max = 360.0, .degrees = true},
        .left = {.title = unit},
        .bands = unbuildableBands(model.result().buildable),
        .presentX = model.shaftAngleDeg(),
    };
}

QString changeTitle(PlaceCriterion::Kind criterion) {
    switch (criterion) {
        case PlaceCriterion::Kind::Range:
            return PlacesWords::tr("Change in range vs. no shaft, %");
        case PlaceCriterion::Kind::Rms:
            return PlacesWords::tr("Change in RMS vs. no shaft, %");
        default:
            return PlacesWords::tr("Change in weighted sum vs. no shaft, %");
    }
}

}  // namespace ravnoves
