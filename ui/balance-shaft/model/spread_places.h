#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

namespace ravnoves {

/// Moves places that are nearer to one another than `apart` away from each other; those beyond the
/// rectangle, which nobody sees, stay. Where they are many some may still be nearer.
std::vector<QPointF> spreadApart(std::vector<QPointF> places, double apart, const QRectF& inside);

}  // namespace ravnoves
