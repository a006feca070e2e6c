#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>

#include "model/scene_model.h"

namespace ravnoves::test {

/// A part of a model that is a figure.
inline Figure figureOf(const SceneModel& model, std::string_view part) {
    return std::get<Figure>(model.part(part));
}

/// The curve with this word.
inline const Figure::Curve& curveOf(const Figure& figure, std::string_view id) {
    const auto found = std::find_if(figure.curves.begin(), figure.curves.end(),
                                    [&](const Figure::Curve& curve) { return curve.id == id; });
    if (found == figure.curves.end()) {
        throw std::out_of_range("no curve " + std::string(id));
    }
    return *found;
}

}  // namespace ravnoves::test
