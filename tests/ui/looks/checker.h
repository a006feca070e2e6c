#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSizeGrip>
#include <QSlider>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>

#include "painted.h"
#include "pictures/figure.h"
#include "plot/legend_item.h"
#include "plot/plot_view.h"

namespace ravnoves::test {

using namespace Qt::StringLiterals;

inline constexpr int tolerance = 1;  // pixels

/// Where a widget is, so that one finds it: "balance-shaft › torque › QLabel “Bore d”".
inline QString placeOf(const QWidget* widget) {
    QString name = QString::fromLatin1(widget->metaObject()->className()).section(u"::"_s, -1);
    if (!widget->objectName().isEmpty()) {
        name += u' ' + widget->objectName();
    }
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        name += u" “"_s + label->text().left(40) + u'”';
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
        name += u" “"_s + button->text() + u'”';
    } else if (!widget->accessibleName().isEmpty()) {
        name += u" “"_s + widget->accessibleName() + u'”';
    }
    return name + u" (%1×%2)"_s.arg(widget->width()).arg(widget->height());
}

inline bool hasWholeTip(const QWidget* widget, const QString& text) {
    QString bare = text;
    return widget->toolTip().contains(bare.remove(u'&'));
}

/// What is cut, hidden without a tip, overlapping or out of reach in a page or a dialog.
class Checker {
  public:
    explicit Checker(QWidget* page) : page_(page) {}

    QStringList faults() {
        for (QWidget* each : page_->findChildren<QWidget*>()) {
            if (!each->isVisible() || each->isWindow()) {
                continue;
            }
            lookAtText(each);
            lookAtPlace(each);
            lookAtUse(each);
            lookAtPainting(each);
        }
        lookForOverlaps(page_);
        return faults_;
    }

  private:
    void fault(const QWidget* widget, const QString& what) {
        faults_ << placeOf(widget) + u": "_s + what;
    }
    void needs(const QWidget* widget, int room, int wanted, const QString& what) {
        if (room + tolerance < wanted) {
            fault(widget, u"%1 needs %2 and has %3"_s.arg(what).arg(wanted).arg(room));
        }
    }

    void lookAtText(QWidget* widget) {
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            lookAtLabel(label);
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            if (qobject_cast<const LegendItem*>(widget) == nullptr && !button->text().isEmpty() &&
                (qobject_cast<const QPushButton*>(button) != nullptr ||
                 !hasWholeTip(button, button->text()))) {
                needs(button, button->width(), button->minimumSizeHint().width(), u"the text"_s);
            }
            if (qobject_cast<const LegendItem*>(widget) == nullptr && !button->text().isEmpty()) {
                needs(button, button->height(), button->fontMetrics().height(), u"the height"_s);
            }
        } else if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
            constexpr int margins = 8;
            const bool isNumber = line->alignment().testFlag(Qt::AlignRight);
            if (isNumber && line->isEnabled()) {
                const QString text = line->text().isEmpty() ? u"0.05"_s : line->text();
                needs(line, line->width(), line->fontMetrics().horizontalAdvance(text) + margins,
                      u"“%1”"_s.arg(text));
            }
            needs(line, line->height(), line->fontMetrics().height(), u"the height"_s);
        } else if (const auto* bar = qobject_cast<const QTabBar*>(widget)) {
            int wanted = 0;
            for (int i = 0; i < bar->count(); ++i) {
                wanted += bar->tabRect(i).width();
            }
            needs(bar, bar->width(), wanted, u"all tabs"_s);
        } else if (const auto* table = qobject_cast<const QTableView*>(widget)) {
            const QHeaderView* header = table->horizontalHeader();
            constexpr int minimum = 24;
            for (int i = 0; i < header->count(); ++i) {
                if (!header->isSectionHidden(i)) {
                    needs(table, header->sectionSize(i), minimum, u"column %1"_s.arg(i));
                }
            }
            needs(table, table->verticalHeader()->defaultSectionSize(),
                  table->fontMetrics().height(), u"a row"_s);
        }
    }

    void lookAtLabel(const QLabel* label) {
        if (label->text().isEmpty() || hasWholeTip(label, label->text())) {
            return;
        }
        if (!label->wordWrap()) {
            needs(label, label->width(), label->minimumSizeHint().width(), u"the text"_s);
            needs(label, label->height(), label->minimumSizeHint().height(),
                  u"the text's height"_s);
        } else {
            needs(label, label->height(), label->heightForWidth(label->width()),
                  u"the text's height"_s);
            for (const QString& word : label->text().split(u' ')) {
                if (!word.contains(u'<')) {
                    QString bare = word.section(u'\n', 0, 0);
                    needs(label, label->width(),
                          label->fontMetrics().horizontalAdvance(bare.remove(u'&')),
                          u"“%1”"_s.arg(word));
                }
            }
        }
    }

    /// Inside its parent, or what a scroll area can bring there.
    void lookAtPlace(QWidget* widget) {
        QWidget* parent = widget->parentWidget();
        if (parent == nullptr || widget == page_ || isInsideOfControl(widget)) {
            return;
        }
        if (auto* area = qobject_cast<QScrollArea*>(parent->parentWidget());
            area != nullptr && area->widget() == widget) {
            needs(widget, parent->width(), widget->width(), u"without scrolling sideways it"_s);
            return;
        }
        if (!parent->rect()
                 .adjusted(-tolerance, -tolerance, tolerance, tolerance)
                 .contains(widget->geometry())) {
            const QRect at = widget->geometry();
            fault(widget,
                  u"is cut by %1: at %2, %3"_s.arg(placeOf(parent)).arg(at.x()).arg(at.y()));
        }
        if (widget->width() == 0 || widget->height() == 0) {
            fault(widget, u"has no size"_s);
        }
    }

    /// A part of a combo box, a spin box, a table, tabs: its owner's business.
    static bool isInsideOfControl(const QWidget* widget) {
        for (const QWidget* each = widget->parentWidget(); each != nullptr;
             each = each->parentWidget()) {
            if (qobject_cast<const QComboBox*>(each) != nullptr ||
                qobject_cast<const QAbstractSpinBox*>(each) != nullptr ||
                qobject_cast<const QAbstractItemView*>(each) != nullptr ||
                qobject_cast<const QTabBar*>(each) != nullptr) {
                return true;
            }
            if (qobject_cast<const QScrollArea*>(each) != nullptr) {
                return each->isAncestorOf(widget) && widget->parentWidget() == each;
            }
        }
        return qobject_cast<const QScrollBar*>(widget) != nullptr;
    }

    void lookAtUse(QWidget* widget) {
        if (const auto* slider = qobject_cast<const QSlider*>(widget)) {
            constexpr int minimum = 110;
            needs(slider, slider->width(), minimum, u"a hand"_s);
        } else if (auto* plot = qobject_cast<PlotView*>(widget)) {
            plot->grab();  // lays it out
            needs(plot, static_cast<int>(plot->plotArea().width()), 90, u"the chart's width"_s);
            needs(plot, static_cast<int>(plot->plotArea().height()), 45, u"the chart's height"_s);
        }
    }

    /// What a picture or a plot writes itself.
    void lookAtPainting(QWidget* widget) {
        if (qobject_cast<PlotView*>(widget) == nullptr && !isFigure(widget)) {
            return;
        }
        if (const auto* plot = qobject_cast<PlotView*>(widget);
            plot != nullptr && plot->data().faded) {
            return;  // it gives way to what is being computed
        }
        const auto texts = test::painted(*widget).texts;
        const QRectF inside = QRectF(widget->rect()).adjusted(-1.0, -1.0, 1.0, 1.0);
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (texts[i].isCut || !inside.contains(texts[i].ink)) {
                fault(widget, u"cuts “%1”"_s.arg(texts[i].text));
            }
            for (std::size_t j = 0; j < i; ++j) {
                const QRectF common = texts[i].ink.intersected(texts[j].ink);
                if (common.width() > 2.0 && common.height() > 2.0) {
                    fault(widget, u"writes “%1” over “%2”"_s.arg(texts[i].text, texts[j].text));
                }
            }
        }
    }

    void lookForOverlaps(QWidget* parent) {
        if (!parent->isVisible() || qobject_cast<QTabWidget*>(parent) != nullptr ||
            qobject_cast<QAbstractScrollArea*>(parent) != nullptr ||
            qobject_cast<QComboBox*>(parent) != nullptr ||
            qobject_cast<QAbstractSpinBox*>(parent) != nullptr ||
            qobject_cast<QTabBar*>(parent) != nullptr) {
            for (QWidget* each : parent->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
                lookForOverlaps(each);
            }
            return;
        }
        QList<QWidget*> shown;
        for (QWidget* each : parent->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
            // The grip of a dialog lies over its corner.
            if (each->isVisible() && !each->isWindow() &&
                qobject_cast<QSizeGrip*>(each) == nullptr) {
                for (const QWidget* other : shown) {
                    const QRect common = other->geometry().intersected(each->geometry());
                    if (common.width() > tolerance && common.height() > tolerance) {
                        fault(each, u"lies over %1"_s.arg(placeOf(other)));
                    }
                }
                shown << each;
                lookForOverlaps(each);
            }
        }
    }

    QWidget* page_;
    QStringList faults_;
};

}  // namespace ravnoves::test
