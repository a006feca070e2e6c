#include "text/shown_units.h"
#include "v8-plugs/model/v8_plugs_model.h"

namespace ravnoves {

ResultTips V8PlugsModel::optionTips() {
    return {
        {tr("Option"), tr("What is bored or replaced; ✓ it is enough, ✗ it is not, ! only by the "
                          "method")},
        {shownTitle(tr("const., g")).text,
         tr("Unbalanced mass that the option takes away with nothing bored, "
            "kₚ times the exchange of plugs")},
        {tr("slope"), tr("Unbalanced mass for each gram that is bored out of a plug")},
        {shownTitle(tr("reach, g")).text,
         tr("Largest unbalanced mass that the option compensates")},
        {shownTitle(tr("needed, g")).text,
         tr("To come off each plug; negative or beyond what is possible where the "
            "option cannot")},
        {shownTitle(tr("left, g")).text, tr("Unbalanced mass that stays")},
        {shownTitle(tr("left, g·mm")).text, tr("Unbalance that stays, mass times crank radius")},
    };
}

ResultTips V8PlugsModel::bobWeightTips() {
    return {
        {shownTitle(tr("factor × mass, g")).text,
         tr("Share of the part in the bob weight times its mass")},
        {tr("nominal"), tr("By the nominal masses")},
        {tr("before"), tr("With the parts as they are")},
        {tr("after"), tr("After the compensation")},
        {tr("Bob weight"), tr("Sum of the lines: what is hung on each crankpin")},
    };
}

ResultTips V8PlugsModel::planeTips() {
    return {
        {tr("Plane"), tr("Correction plane of the crankshaft")},
        {shownTitle(tr("allowed, g·mm")).text,
         tr("Permissible residual unbalance, share of U = G m / ω "
            "(ISO 21940-11)")},
        {shownTitle(tr("reading, g·mm")).text, tr("What the balancing machine reads")},
        {tr("verdict"), tr("Passes where the reading is not above what is allowed")},
    };
}

ResultTips V8PlugsModel::crankpinTips() {
    return {
        {shownTitle(tr("as weighed, g")).text,
         tr("Excess on each crankpin over the mean, parts where they are")},
        {shownTitle(tr("after moving, g")).text,
         tr("Excess on each crankpin over the mean, parts moved")},
        {tr("spread"), tr("Largest less smallest excess of the four crankpins")},
    };
}

}  // namespace ravnoves
