#pragma once

#include <QCoreApplication>
#include <QRectF>
#include <QSize>
#include <QString>
#include <functional>
#include <vector>

#include "balance-shaft/model/shaft_map_model.h"

class QPainter;

namespace ravnoves {

/// What the colours, lines and signs of the map mean, above the chart of a plot of a size. In a low
/// plot only the colours have room: the signs are left to signsInWords().
class ShaftMapKey {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftMapKey)

  public:
    ShaftMapKey(const ShaftMapModel& map, const QSize& size) : map_(map), size_(size) {}

    /// Too low for the signs.
    bool isLow() const;
    double height() const;
    void paint(QPainter& painter, double top) const;
    /// The markers that can be built: "◆ least range, ● least RMS".
    QString signsInWords() const;

  private:
    struct Entry {
        QString text;
        std::function<void(QPainter&, const QPointF& middle)> draw;
        QRectF rect = {};
    };

    std::vector<Entry> entries() const;
    void paintColours(QPainter& painter, double top) const;

    const ShaftMapModel& map_;
    QSize size_;
};

}  // namespace ravnoves
