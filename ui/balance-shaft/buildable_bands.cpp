#include "balance-shaft/buildable_bands.h"

#include <QCoreApplication>
#include <algorithm>

#include "numerics/constants.h"
#include "theme/theme.h"

namespace ravnoves {

std::vector<PlotView::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                             Qt::Orientation orientation) {
    // What can be built, in degrees of one turn; a stretch over 0 stands there twice.
    std::vector<std::pair<double, double>> free;
    for (const balance_shaft::AngleStretch& stretch : buildable.stretches) {
        const double from = stretch.from / degree;
        const double to = stretch.to / degree;
        free.emplace_back(from, std::min(to, 360.0));
        if (to > 360.0) {
            free.emplace_back(0.0, to - 360.0);
        }
    }
    std::sort(free.begin(), free.end());
    free.emplace_back(360.0, 360.0);
    QColor colour = Theme::instance().error();
    colour.setAlphaF(0.13F);
    const QString text =
        QCoreApplication::translate("ravnoves::BalanceShaftModel", "cannot be built");
    std::vector<PlotView::Band> bands;
    double end = 0.0;
    for (const auto& [from, to] : free) {
        if (from > end) {
            bands.push_back({end, from, colour, text, orientation});
        }
        end = std::max(end, to);
    }
    return bands;
}

}  // namespace ravnoves
