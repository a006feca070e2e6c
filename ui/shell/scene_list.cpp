#include "shell/scene_list.h"

#include <QCoreApplication>

#include "balance-shaft/balance_shaft_page.h"
#include "bob-weights/bob_weights_page.h"
#include "elastic-hinge/elastic_hinge_page.h"
#include "inertia-moments/inertia_moments_page.h"
#include "methods/methods_page.h"
#include "shell/comparison.h"
#include "studies/tolerance_bands.h"
#include "v8-plugs/v8_plugs_page.h"

namespace ravnoves {

namespace {

template <typename Page>
ScenePage* makePage(QWidget* parent, SceneModel* kept) {
    auto* page = new Page(parent, kept);
    new Comparison(page);
    new ToleranceBands(page);
    return page;
}

QString translated(const char* text) {
    return QCoreApplication::translate("ravnoves::SceneList", text);
}

}  // namespace

std::vector<SceneInfo> sceneList() {
    return {
        {QStringLiteral("balance-shaft"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Balance shaft")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Where the balance shaft of a single-cylinder engine goes")),
         makePage<BalanceShaftPage>},
        {QStringLiteral("elastic-hinge"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Elastic hinges")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Spring guides that hold the crank speed constant")),
         makePage<ElasticHingePage>},
        {QStringLiteral("v8-plugs"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "V-8 workshop")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Crankpin plugs and bob weights of a V-8 under repair")),
         makePage<V8PlugsPage>},
        {QStringLiteral("bob-weights"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Bob weights")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Bob weights and the drilled crankshaft of any engine")),
         makePage<BobWeightsPage>},
        {QStringLiteral("inertia-moments"),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Inertia moments")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Forces and moments of VR5 and any other cylinder layout")),
         makePage<InertiaMomentsPage>},
        {QStringLiteral("methods"), translated(QT_TRANSLATE_NOOP("ravnoves::SceneList", "Methods")),
         translated(QT_TRANSLATE_NOOP("ravnoves::SceneList",
                                      "Speed against accuracy, and where methods fail")),
         makePage<MethodsPage>},
    };
}

}  // namespace ravnoves
