#include "balance-shaft/model/buildable_bands.h"

#include <QCoreApplication>

#include "numerics/constants.h"

namespace ravnoves {

std::vector<plot::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                             Qt::Orientation orientation) {
    const QString text =
        QCoreApplication::translate("ravnoves::BalanceShaftModel", "cannot be built");
    std::vector<plot::Band> bands;
    for (const balance_shaft::AngleStretch& gap : buildable.gaps()) {
        bands.push_back({gap.from / degree, gap.to / degree, plot::ErrorInk, 0.13, text, orientation});
    }
    return bands;
}

}  // namespace ravnoves
