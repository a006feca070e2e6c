#include "workshop/plugs/model/weighing_text.h"

#include "shop/model/scale_settings.h"
#include "v8-plugs/weighing.h"

namespace ravnoves::v8_text {

WeighingNote weighingNote(const Words& words, const v8_plugs::Input& input) {
    const double resolution = ScaleSettings::load().resolution;
    const auto found = resolution > 0.0 ? v8_plugs::weighing(input, resolution) : std::nullopt;
    if (!found) {
        return {};
    }
    const auto digit = [&](double mass) { return words.plainWithUnit(mass, units::gram, 6); };
    const QString sure =
        words
            .translate("V8",
                       "Weighed to %1, the bob weight is sure to ±%2 and the unbalance of a "
                       "crankpin to ±%3 (19 times of 20).")
            .arg(digit(resolution), words.number(found->bob_weight, units::gram, 2),
                 words.number(found->unbalance, units::gram_mm, 1));
    const QString tolerance = words.number(input.tolerance, units::gram_mm, 0);
    const QString verdict =
        found->enough
            ? words.translate("V8", "That is enough for the tolerance of %1.").arg(tolerance)
            : words
                  .translate("V8",
                             "That is too coarse for the tolerance of %1: take a scale that shows "
                             "%2.")
                  .arg(tolerance, digit(found->coarsest));
    return {sure + QLatin1Char(' ') + verdict, found->enough};
}

}  // namespace ravnoves::v8_text
