#include <algorithm>
#include <utility>

#include "plot/legend_item.h"
#include "plot/plot_view.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

const plot::Axis& axisOf(const Figure& figure, plot::Side side) {
    return side == plot::Side::Left ? figure.left : figure.right;
}

const std::optional<std::pair<double, double>>& rangeOf(const Figure& figure, plot::Side side) {
    return side == plot::Side::Left ? figure.leftRange : figure.rightRange;
}

/// Under a hand that drags, an interval that still holds what is there, and not much more, rests.
bool rests(const std::pair<double, double>& shown, const std::pair<double, double>& wanted) {
    constexpr double enough = 0.6;
    return PlotData::steady && shown.first <= wanted.first && wanted.second <= shown.second &&
           wanted.second - wanted.first > enough * (shown.second - shown.first);
}

/// What is read of a point that is drawn, by its number among all that the figure has.
std::function<QString(std::size_t)> textOf(const Figure::Curve& curve, const PlotCurve& drawn) {
    if (!curve.text) {
        return {};
    }
    return [all = std::pair(curve.x, curve.y), text = curve.text,
            drawn = std::pair(drawn.x, drawn.y)](std::size_t point) {
        for (std::size_t i = 0; i < all.first.size(); ++i) {
            if (all.first[i] == drawn.first[point] && all.second[i] == drawn.second[point]) {
                return text(i);
            }
        }
        return QString();
    };
}

PlotData dataOf(const Figure& figure) {
    PlotData data;
    data.x.setSpec(figure.x);
    for (const plot::Side side : {plot::Side::Left, plot::Side::Right}) {
        data.scale(side).setSpec(axisOf(figure, side));
        if (const auto& range = rangeOf(figure, side)) {
            data.scale(side).fix(range->first, range->second);
        }
    }
    for (const Figure::Curve& curve : figure.curves) {
        PlotCurve& drawn = data.curves.emplace_back();
        drawn.id = curve.id;
        drawn.style = curve.style;
        drawn.trueX = curve.trueX;
        drawn.trueY = curve.trueY;
        drawn.set(curve.x, curve.y, data.x, data.scale(curve.style.side));
    }
    return data;
}

}  // namespace

void PlotView::showX(const plot::Axis& axis) {
    if (shownX_ == axis) {
        return;
    }
    const bool isOther = !shownX_ || shownX_->title != axis.title;
    if (!isOther && rests({shownX_->min, shownX_->max}, {axis.min, axis.max})) {
        return;
    }
    shownX_ = axis;
    data_.x.setSpec(axis);
    if (!data_.zoomed || isOther) {  // else it is to be gone back to
        data_.x.low = axis.min;
        data_.x.high = axis.max;
        data_.zoomed = false;
        data_.makeStale();
        chartChanged();
    }
}

void PlotView::showY(Side side, const Figure& figure) {
    PlotScale& scale = data_.scale(side);
    const plot::Axis& axis = axisOf(figure, side);
    if (std::optional<plot::Axis>& shown = shownY_.at(static_cast<std::size_t>(side));
        shown != axis) {
        shown = axis;
        scale.setSpec(axis);
        if (axis.logarithmic) {
            data_.makeStale();
            if (!(scale.low > 0.0)) {
                scale.low = 0.1;
                scale.high = 1.0;
            }
        }
        chartChanged();
    }
    if (const auto& range = rangeOf(figure, side)) {
        if ((!scale.fixed || !rests(*scale.fixed, *range)) &&
            scale.fix(range->first, range->second)) {
            chartChanged();
        }
    } else if (std::exchange(scale.fixed, std::nullopt)) {
        chartChanged();  // it follows its data again
    }
}

void PlotView::showCurve(const Figure::Curve& curve) {
    const auto known = data_.find(curve.id);
    const std::size_t number = known.value_or(data_.curves.size());
    if (!known) {
        data_.curves.push_back({.id = curve.id, .shown = curve.style.shown});
        LegendItem* item = curve.style.inLegend ? new LegendItem(this) : nullptr;
        legend_.push_back(item);
        if (item != nullptr) {
            item->setChecked(curve.style.shown);
            connect(item, &LegendItem::toggled, this,
                    [this, number](bool on) { setCurveShown(static_cast<int>(number), on); });
        }
    }
    PlotCurve& drawn = data_.curves[number];
    if (!known || drawn.style != curve.style) {
        drawn.style = curve.style;
        drawn.stale = true;
        const QString& name = curve.style.name;
        const QString& tip = curve.style.toolTip;
        if (LegendItem* item = legend_[number]) {
            item->setName(name);
            item->setAccessibleName(tr("Show %1").arg(name));
            item->setToolTip(tip.isEmpty() ? tr("Show or hide %1").arg(name) : tip);
            item->setSwatch(curve.style.role, curve.style.shape);
        }
        chartChanged();
    }
    drawn.trueX = curve.trueX;
    drawn.trueY = curve.trueY;
    showPoints(drawn, curve.x, curve.y);
    if (curve.text || drawn.text) {
        data_.pointRead.reset();
        overlay(drawn.text, textOf(curve, drawn));
    }
}

void PlotView::showPoints(PlotCurve& drawn, const std::vector<double>& x,
                          const std::vector<double>& y) {
    const bool wasEmpty = drawn.x.empty();
    if (drawn.set(x, y, data_.x, data_.scale(drawn.style.side))) {
        data_.pointRead.reset();
        wasEmpty != drawn.x.empty() ? chartChanged() : curvesChanged();
    }
}

void PlotView::showFigure(const Figure& figure) {
    if (std::exchange(data_.title, figure.title) != figure.title) {
        setAccessibleName(figure.title);
        chartChanged();
    }
    showX(figure.x);
    showY(Side::Left, figure);
    showY(Side::Right, figure);
    if (std::exchange(data_.equalScale, figure.equalScale) != figure.equalScale) {
        chartChanged();
    }
    for (PlotCurve& drawn : data_.curves) {
        const bool isIn =
            std::ranges::find(figure.curves, drawn.id, &Figure::Curve::id) != figure.curves.end();
        if (std::exchange(drawn.inFigure, isIn) != isIn) {
            chartChanged();
        }
        if (!isIn) {
            showPoints(drawn, {}, {});
        }
    }
    for (const Figure::Curve& curve : figure.curves) {
        showCurve(curve);
    }
    showLegend();
    if (figure.marks) {
        setMarks(*figure.marks);
    }
    if (std::exchange(data_.bands, figure.bands) != figure.bands) {
        chartChanged();
    }
    overlay(data_.lines, figure.lines);
    if (figure.presentX) {
        setPresentX(figure.presentX);
    }
    if (figure.spreads) {
        setSpreads(*figure.spreads);
    }
}

void PlotView::showReference(const Figure* figure, const QString& name) {
    if (figure == nullptr) {
        if (referenceData_ != nullptr) {
            data_.reference = nullptr;
            referenceData_.reset();
            chartChanged();
            Q_EMIT referenceChanged();
        }
        return;
    }
    referenceData_ = std::make_unique<PlotData>(dataOf(*figure));
    data_.reference = referenceData_.get();
    data_.referenceName = name;
    if (referenceItem_ == nullptr) {
        referenceItem_ = new LegendItem(this);
        referenceItem_->setChecked(true);
        referenceItem_->setSwatch({}, plot::Shape::Line);
        connect(referenceItem_, &LegendItem::toggled, this, [this](bool on) {
            data_.referenceShown = on;
            chartChanged();
            Q_EMIT referenceChanged();
        });
    }
    constexpr int longest = 24;
    referenceItem_->setName(name.size() > longest ? name.left(longest - 1) + QChar(0x2026) : name);
    referenceItem_->setAccessibleName(tr("Show reference %1").arg(name));
    referenceItem_->setToolTip(tr("Show or hide the curves of the reference %1").arg(name));
    showLegend();
    chartChanged();
    Q_EMIT referenceChanged();
}

}  // namespace ravnoves
