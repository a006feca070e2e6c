#include "workshop/presets.h"

#include "bob-weights/presets.h"
#include "v8-plugs/presets.h"
#include "workshop/scene.h"

namespace ravnoves::workshop {

std::vector<Preset<Input>> presets() {
    std::vector<Preset<Input>> list;
    for (auto& [title, input] : v8_plugs::presets()) {
        list.push_back({title, as_job(input)});
    }
    for (auto& [title, input] : bob_weights::presets()) {
        list.push_back({title, as_job(input)});
    }
    return list;
}

}  // namespace ravnoves::workshop
