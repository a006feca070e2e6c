#include "shell/scene_list.h"

#include <iterator>

#include "balance-shaft/balance_shaft_page.h"
#include "elastic-hinge/elastic_hinge_page.h"
#include "inertia-moments/inertia_moments_page.h"
#include "methods/methods_page.h"
#include "numerics/demand.h"
#include "studies/tolerance_bands.h"
#include "workshop/workshop_page.h"

namespace ravnoves {

namespace {

template <typename Page>
ScenePage* makePage(QWidget* parent, SceneModel* kept) {
    auto* page = new Page(parent, kept);
    new ToleranceBands(page);
    return page;
}

/// In the order of sceneNames().
constexpr ScenePage* (*makers[])(QWidget*, SceneModel*){
    makePage<BalanceShaftPage>,   makePage<ElasticHingePage>, makePage<WorkshopPage>,
    makePage<InertiaMomentsPage>, makePage<MethodsPage>,
};

}  // namespace

ScenePage* SceneInfo::make(QWidget* parent, SceneModel* kept) const {
    ScenePage* page = maker(parent, kept);
    RAVNOVES_DEMAND(page->model()->sceneName() == name, "a scene has its own page");
    return page;
}

std::vector<SceneInfo> sceneList() {
    std::vector<SceneInfo> scenes;
    RAVNOVES_DEMAND(sceneNames().size() == std::size(makers), "each scene has a page");
    for (const SceneName& each : sceneNames()) {
        scenes.push_back({each, makers[scenes.size()]});
    }
    return scenes;
}

}  // namespace ravnoves
