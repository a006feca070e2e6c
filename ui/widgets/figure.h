#pragma once

#include <QVariant>
#include <QWidget>

namespace ravnoves {

/// Says of a widget that it is a picture of the result: a report draws it, as it does plots.
inline void makeFigure(QWidget* widget) {
    widget->setProperty("isFigure", true);
}
inline bool isFigure(const QWidget* widget) {
    return widget->property("isFigure").toBool();
}

}  // namespace ravnoves
