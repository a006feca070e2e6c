#include <utility>

#include "plot/model/figure.h"
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

void PlotView::showAxis(const Axis& axis) {
    if (shownX_ == axis) {
        return;
    }
    const bool isOther = !shownX_ || shownX_->title != axis.title;
    if (!isOther && rests({shownX_->min, shownX_->max}, {axis.min, axis.max})) {
        return;
    }
    shownX_ = axis;
    if (data_.zoomed && !isOther) {
        data_.x.setSpec(axis);  // to be gone back to
    } else {
        setXAxis(axis);
    }
}

void PlotView::showFigure(const Figure& figure) {
    setTitle(figure.title);
    showAxis(figure.x);
    for (const Side side : {Side::Left, Side::Right}) {
        std::optional<Axis>& shown = side == Side::Left ? shownLeft_ : shownRight_;
        const Axis& axis = axisOf(figure, side);
        if (shown != axis) {
            shown = axis;
            setYAxis(side, axis);
        }
        if (const auto& range = rangeOf(figure, side)) {
            const auto& fixed = data_.scale(side).fixed;
            if (!fixed || !rests(*fixed, *range)) {
                setYRange(side, range->first, range->second);
            }
        } else if (std::exchange(data_.scale(side).fixed, std::nullopt)) {
            chartChanged();  // it follows its data again
        }
    }
    if (data_.equalScale != figure.equalScale) {
        setEqualScale(figure.equalScale);
    }
    const auto has = [&](const std::string& id) {
        return std::any_of(figure.curves.begin(), figure.curves.end(),
                           [&](const Figure::Curve& curve) { return curve.id == id; });
    };
    for (int number = 0; number < curveCount(); ++number) {
        if (!has(data_.curve(number).id)) {
            setCurve(number, {}, {});
        }
    }
    for (const Figure::Curve& curve : figure.curves) {
        const auto known = data_.find(curve.id);
        const int number = known ? static_cast<int>(*known) : addCurve(curve.style);
        PlotCurve& drawn = data_.curve(number);
        drawn.id = curve.id;
        if (drawn.style != curve.style) {
            setCurveStyle(number, curve.style);
        }
        drawn.trueX = curve.trueX;
        drawn.trueY = curve.trueY;
        setCurve(number, curve.x, curve.y);
        if (curve.text || drawn.text) {
            setPointText(number, textOf(curve, drawn));
        }
    }
    if (figure.marks) {
        setMarks(*figure.marks);
    }
    setBands(figure.bands);
    setLines(figure.lines);
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
    nameReference(name);
    showLegend();
    chartChanged();
    Q_EMIT referenceChanged();
}

}  // namespace ravnoves
