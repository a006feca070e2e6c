#include "model/state_brought_in.h"

#include "model/scene_model.h"

namespace ravnoves {

StateBroughtIn& StateBroughtIn::of(SceneModel* model) {
    auto* there = model->findChild<StateBroughtIn*>(QString(), Qt::FindDirectChildrenOnly);
    return there != nullptr ? *there : *new StateBroughtIn(model);
}

}  // namespace ravnoves
