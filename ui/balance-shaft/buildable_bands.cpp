#include "balance-shaft/buildable_bands.h"

#include <QCoreApplication>

#include "numerics/constants.h"
#include "theme/theme.h"

namespace ravnoves {

std::vector<PlotView::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                             Qt::Orientation orientation) {
    QColor colour = Theme::instance().error();
    colour.setAlphaF(0.13F);
    const QString text =
        QCoreApplication::translate("ravnoves::BalanceShaftModel", "cannot be built");
    std::vector<PlotView::Band> bands;
    for (const balance_shaft::AngleStretch& gap : buildable.gaps()) {
        bands.push_back({gap.from / degree, gap.to / degree, colour, text, orientation});
    }
    return bands;
}

}  // namespace ravnoves
