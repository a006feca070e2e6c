#include "v8-plugs/model/v8_plugs_model.h"

namespace ravnoves {

ResultTips V8PlugsModel::optionTips() {
    return {
        {tr("Option"), tr("What is bored or replaced; ✓ it is enough, ✗ it is not, ! only by the "
                          "method")},
        {tr("const., g"), tr("Unbalanced mass that the option takes away with nothing bored, "
                             "kₚ times the exchange of plugs")},
        {tr("slope"), tr("Unbalanced mass for each gram that is bored out of a plug")},
        {tr("reach, g"), tr("Largest unbalanced mass that the option compensates")},
        {tr("needed, g"), tr("To come off each plug; negative or beyond what is possible where the "
                             "option cannot")},
        {tr("left, g"), tr("Unbalanced mass that stays")},
        {tr("left, g·mm"), tr("Unbalance that stays, mass times crank radius")},
    };
}

ResultTips V8PlugsModel::bobWeightTips() {
    return {
        {tr("factor × mass, g"), tr("Share of the part in the bob weight times its mass")},
        {tr("nominal"), tr("By the nominal masses, g")},
        {tr("before"), tr("With the parts as they are, g")},
        {tr("after"), tr("After the compensation, g")},
        {tr("Bob weight"), tr("Sum of the lines: what is hung on each crankpin")},
    };
}

ResultTips V8PlugsModel::planeTips() {
    return {
        {tr("Plane"), tr("Correction plane of the crankshaft")},
        {tr("allowed, g·mm"), tr("Permissible residual unbalance, share of U = G m / ω "
                                 "(ISO 21940-11)")},
        {tr("reading, g·mm"), tr("What the balancing machine reads")},
        {tr("verdict"), tr("Passes where the reading is not above what is allowed")},
    };
}

ResultTips V8PlugsModel::assignmentTips() {
    return {
        {tr("Cylinder"), tr("A dot: the part stays; a number: it comes from that cylinder")},
        {tr("Piston from"), tr("Cylinder from which the piston comes")},
        {tr("Rod from"), tr("Cylinder from which the rod comes")},
    };
}

ResultTips V8PlugsModel::crankpinTips() {
    return {
        {tr("as weighed, g"), tr("Excess on each crankpin over the mean, parts where they are")},
        {tr("after moving, g"), tr("Excess on each crankpin over the mean, parts moved")},
        {tr("spread"), tr("Largest less smallest excess of the four crankpins")},
    };
}

}  // namespace ravnoves
