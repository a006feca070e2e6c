#include "elastic-hinge/model/elastic_hinge_model.h"

namespace ravnoves {

ResultTips ElasticHingeModel::quantityTips() {
    return {
        {tr("Relief of the guide"), tr("Largest less smallest radius of the guide")},
        {tr("Preload needed / given"),
         tr("|ℓ₀/2 − ρ₀|: the least with which the spring can store the energy, and the present "
            "one")},
        {tr("Spring travel"), tr("Largest less smallest length of the spring over a turn")},
        {tr("Largest spring force"), tr("c |ℓ − ℓ₀|, largest over a turn")},
        {tr("Moment error from %1"), tr("Largest error of the hinge's moment when the guide is "
                                        "made so much off its profile; in "
                                        "brackets against the largest moment")},
        {tr("Least curvature radius"), tr("Of the guide; a cutter must be smaller")},
        {tr("Largest roller radius"), tr("That still touches the whole guide")},
        {tr("∮ M₁₂ dφ"), tr("Work of the rod hinge's moment over a turn; 0 where a spring can give "
                            "it")},
        {tr("Side force without hinge"), tr("Largest force of the slider on its guide")},
        {tr("Side force with rod hinge"),
         tr("The same with the hinge in the rod; in brackets how many "
            "times less")},
        {tr("Counterweight P₄"), tr("On the rod, with which ∮ M₁₂ dφ = 0, or as entered")},
        {tr("Ripple without hinge"), tr("(ω_max − ω_min) / ω mean of the free motion, %")},
        {tr("Ripple with hinge"), tr("The same with the crank's hinge")},
        {tr("Ripple from %1"), tr("The same when the crank starts at another speed than the "
                                  "hinge is made for")},
    };
}

}  // namespace ravnoves
