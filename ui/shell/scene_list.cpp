#include "shell/scene_list.h"

#include <QCoreApplication>
#include <array>

#include "balance-shaft/balance_shaft_page.h"
#include "elastic-hinge/elastic_hinge_page.h"
#include "inertia-moments/inertia_moments_page.h"
#include "methods/methods_page.h"
#include "scenes/scenes.h"
#include "studies/tolerance_bands.h"
#include "text/message_text.h"
#include "workshop/workshop_page.h"

namespace ravnoves {

namespace {

template <typename Page>
ScenePage* makePage(QWidget* parent, SceneModel* kept) {
    auto* page = new Page(parent, kept);
    new ToleranceBands(page);
    return page;
}

struct SceneList {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SceneList)
};

}  // namespace

std::vector<SceneInfo> sceneList() {
    constexpr std::array makers{makePage<BalanceShaftPage>, makePage<ElasticHingePage>,
                                makePage<WorkshopPage>, makePage<InertiaMomentsPage>};
    std::vector<SceneInfo> scenes;
    for (const SceneSolver& each : scene_solvers()) {
        if (!each.title.empty()) {
            scenes.push_back({QString::fromUtf8(each.name.data(), std::ssize(each.name)),
                              shownText(each.title), shownText(each.summary),
                              makers.at(scenes.size())});
        }
    }
    scenes.push_back({QStringLiteral("methods"), SceneList::tr("Methods"),
                      SceneList::tr("Numerical methods: speed, accuracy, limits"),
                      makePage<MethodsPage>});
    return scenes;
}

}  // namespace ravnoves
