#include "widgets/heights_by_width.h"

#include <QLabel>

namespace ravnoves {

const int* HeightsByWidth::find(const QLabel& label, int width) {
    constexpr qsizetype most = 16;
    if (text_ != label.text() || font_ != label.font()) {
        known_.clear();
        text_ = label.text();
        font_ = label.font();
    }
    const auto known = known_.constFind(width);
    if (known != known_.constEnd()) {
        return &*known;
    }
    if (known_.size() >= most) {
        known_.clear();
    }
    return nullptr;
}

}  // namespace ravnoves
