#include <algorithm>
#include <utility>

#include "plot/legend_item.h"
#include "plot/plot_view.h"
#include "theme/theme.h"

namespace ravnoves {

void PlotView::showFigure(const Figure& figure) {
    const QString before = data_.title;
    const PlotData::Change change = data_.show(figure);
    if (data_.title != before) {
        setAccessibleName(data_.title);
    }
    if (change == PlotData::Change::Chart) {
        for (std::size_t number = 0; number < data_.curves.size(); ++number) {
            dressLegend(number);
        }
        chartChanged();
    } else if (change == PlotData::Change::Curves) {
        curvesChanged();
    }
    showLegend();
    updateChart();
    if (figure.spreads) {
        setSpreads(*figure.spreads);
    }
}

LegendItem* PlotView::addSwitch(bool& shown, plot::Shape shape) {
    auto* item = new LegendItem(this);
    item->setChecked(shown);
    item->setSwatch({}, shape);
    connect(item, &LegendItem::toggled, this, [this, &shown](bool on) {
        shown = on;
        data_.makeStale();
        chartChanged();
    });
    return item;
}

void PlotView::dressLegend(std::size_t number) {
    const plot::CurveStyle& style = data_.curves[number].style;
    if (number == legend_.size()) {
        legend_.push_back(style.inLegend ? new LegendItem(this) : nullptr);
        if (LegendItem* item = legend_.back()) {
            item->setChecked(style.shown);
            connect(item, &LegendItem::toggled, this,
                    [this, number](bool on) { setCurveShown(static_cast<int>(number), on); });
        }
    }
    if (LegendItem* item = legend_[number]) {
        item->setName(style.name);
        item->setAccessibleName(tr("Show %1").arg(style.name));
        item->setToolTip(style.toolTip.isEmpty() ? tr("Show or hide %1").arg(style.name)
                                                 : style.toolTip);
        item->setSwatch(style.role, style.shape);
    }
}

void PlotView::showReference(const Figure* figure, const QString& name) {
    if (figure == nullptr) {
        if (referenceData_ != nullptr) {
            data_.reference = nullptr;
            referenceData_.reset();
            chartChanged();
        }
        return;
    }
    referenceData_ = std::make_unique<PlotData>();
    referenceData_->show(*figure);
    data_.reference = referenceData_.get();
    data_.referenceName = name;
    if (referenceItem_ == nullptr) {
        referenceItem_ = addSwitch(data_.referenceShown, plot::Shape::Line);
    }
    constexpr int longest = 24;
    referenceItem_->setName(name.size() > longest ? name.left(longest - 1) + QChar(0x2026) : name);
    referenceItem_->setAccessibleName(tr("Show reference %1").arg(name));
    referenceItem_->setToolTip(tr("Show or hide the curves of the reference %1").arg(name));
    showLegend();
    chartChanged();
}

}  // namespace ravnoves
