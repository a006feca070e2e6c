#include "widgets/elided_tips.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QToolTip>

#include "plot/legend_item.h"
#include "plot/plot_view.h"
#include "theme/theme.h"
#include "widgets/application_filter.h"
#include "widgets/decimal_spin_box.h"
#include "widgets/entry_field.h"
#include "widgets/value_slider.h"

namespace ravnoves {

namespace {

bool isElided(const QString& text, const QFont& font, int room) {
    return QFontMetrics(font).horizontalAdvance(text) > room;
}

/// The text at a place of a widget where it is elided, else nothing.
QString elidedHeading(const QHeaderView& header, const QPoint& at) {
    const int section = header.logicalIndexAt(at);
    if (section < 0 || header.orientation() != Qt::Horizontal) {
        return {};
    }
    const QString text =
        header.model()->headerData(section, Qt::Horizontal, Qt::DisplayRole).toString();
    return isElided(text, header.font(), header.sectionSize(section) - 6) ? text : QString();
}

QString elidedCell(const QAbstractItemView& view, const QPoint& at) {
    const QModelIndex cell = view.indexAt(at);
    const QString text = cell.data(Qt::DisplayRole).toString();
    const QVariant font = cell.data(Qt::FontRole);
    const int room = view.visualRect(cell).width() - 6;
    return cell.isValid() &&
                   isElided(text, font.isValid() ? font.value<QFont>() : view.font(), room)
               ? text
               : QString();
}

QString elidedChoice(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect room = box.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                   QStyle::SC_ComboBoxEditField, &box);
    return isElided(box.currentText(), box.font(), room.width()) ? box.currentText() : QString();
}

/// A tab's title where it is shortened, and its tip.
std::pair<QString, QString> elidedTab(const QTabBar& bar, int tab) {
    QString title = tab >= 0 ? bar.tabText(tab).remove(QLatin1Char('&')) : QString();
    const int room = bar.tabRect(tab).width() - 2 * Theme::gap;
    return {isElided(title, bar.font(), room) ? title : QString(), bar.tabToolTip(tab)};
}

/// The title of the axis beside a place of a plot, where it is elided.
QString elidedAxis(const PlotView& plot, const QPoint& at) {
    const QRectF area = plot.plotArea();
    const PlotData& data = plot.data();
    const QFont font = Theme::font(Theme::smallSize);
    const auto shown = [&](const PlotScale& scale, double room) {
        const QString& title = scale.spec.title;
        return isElided(title, font, static_cast<int>(room)) ? title : QString();
    };
    return at.y() > area.bottom() ? shown(data.x, data.flatRoom)
           : at.x() < area.left() ? shown(data.left, data.uprightRoom)
           : at.x() > area.right() && data.sideUsed(plot::Side::Right)
               ? shown(data.right, data.uprightRoom)
               : QString();
}

class ElidedTips : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ToolTip || !watched->isWidgetType()) {
            return false;
        }
        auto* widget = static_cast<QWidget*>(watched);
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto [text, tip] = textAndTip(widget, help->pos());
        if (text.isEmpty()) {
            return false;
        }
        QToolTip::showText(help->globalPos(), tip.isEmpty() ? text : text + QLatin1Char('\n') + tip,
                           widget);
        return true;
    }

  private:
    static std::pair<QString, QString> textAndTip(QWidget* widget, const QPoint& at) {
        if (const auto* item = qobject_cast<const LegendItem*>(widget)) {
            return {item->isElided() ? item->text() : QString(), item->toolTip()};
        }
        if (const auto* plot = qobject_cast<const PlotView*>(widget)) {
            const QFont font = Theme::font(Theme::baseSize, true);
            const bool inTitle = at.y() < QFontMetrics(font).height() + 2 * Theme::gap;
            return {inTitle && isElided(plot->title(), font, plot->width() - 2 * Theme::margin)
                        ? plot->title()
                        : elidedAxis(*plot, at),
                    plot->toolTip()};
        }
        if (const auto* field = qobject_cast<const EntryField*>(widget);
            field != nullptr && !field->wholeText().isEmpty()) {
            return {field->wholeText(), field->toolTip()};
        }
        if (const auto* box = qobject_cast<const DecimalSpinBox*>(widget->parentWidget())) {
            const auto* slider = qobject_cast<const ValueSlider*>(box->parentWidget());
            return {slider != nullptr ? slider->wholeText() : QString(), box->toolTip()};
        }
        if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
            constexpr int margins = 8;
            const bool isCut =
                line->text().isEmpty() &&
                isElided(line->placeholderText(), line->font(), line->width() - margins);
            return {isCut ? line->placeholderText() : QString(), line->toolTip()};
        }
        if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
            return {elidedChoice(*box), box->toolTip()};
        }
        if (const auto* bar = qobject_cast<const QTabBar*>(widget)) {
            return elidedTab(*bar, bar->tabAt(at));
        }
        if (const auto* header = qobject_cast<const QHeaderView*>(widget->parentWidget())) {
            return {
                elidedHeading(*header, at),
                header->model()
                    ->headerData(header->logicalIndexAt(at), header->orientation(), Qt::ToolTipRole)
                    .toString()};
        }
        if (const auto* view = qobject_cast<const QAbstractItemView*>(widget->parentWidget())) {
            return {elidedCell(*view, at), view->indexAt(at).data(Qt::ToolTipRole).toString()};
        }
        return {};
    }
};

}  // namespace

void showElidedTips() {
    filterApplication<ElidedTips>();
}

}  // namespace ravnoves
