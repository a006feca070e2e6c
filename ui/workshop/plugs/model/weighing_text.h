#pragma once

#include <QString>

#include "shop/model/words.h"
#include "v8-plugs/input.h"

namespace ravnoves::v8_text {

/// What the last digit of the scale that is set up leaves uncertain of the bob weight, and whether
/// that is enough.
struct WeighingNote {
    QString text;  ///< empty where scale or engine are not known
    bool enough = true;
};
WeighingNote weighingNote(const Words& words, const v8_plugs::Input& input);

}  // namespace ravnoves::v8_text
