#include "plot/accessible_plot.h"

#include <QAccessible>
#include <QAccessibleWidget>

#include "plot/plot_view.h"

namespace ravnoves {

namespace {

class AccessiblePlot final : public QAccessibleWidget {
  public:
    explicit AccessiblePlot(PlotView* plot)
        : QAccessibleWidget(plot, QAccessible::Chart), plot_(plot) {}

    QString text(QAccessible::Text kind) const override {
        return kind == QAccessible::Description ? plot_->sentence() : QAccessibleWidget::text(kind);
    }

  private:
    PlotView* plot_;
};

QAccessibleInterface* makeAccessible(const QString& /*className*/, QObject* object) {
    auto* plot = qobject_cast<PlotView*>(object);
    return plot != nullptr ? new AccessiblePlot(plot) : nullptr;
}

}  // namespace

void makePlotsAccessible() {
    static const bool isInstalled = [] {
        QAccessible::installFactory(makeAccessible);
        return true;
    }();
    static_cast<void>(isInstalled);
}

}  // namespace ravnoves
