#include "widgets/page_columns.h"

#include <QGridLayout>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <algorithm>

#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

namespace {

constexpr int plotsWidth = 440;  ///< designed pixels that plots need at least

int leastWidth(const QWidget* widget) {
    return std::max(widget->minimumWidth(), widget->minimumSizeHint().width());
}

}  // namespace

PageColumns::PageColumns(const Parts& parts, QWidget* parent)
    : QWidget(parent),
      parts_(parts),
      grid_(new QGridLayout(this)),
      results_(scrolled(parts.results, this)),
      resultsWidth_(leastWidth(parts.results) + results_->verticalScrollBar()->sizeHint().width() +
                    2) {
    grid_->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    grid_->setSpacing(Theme::space);
    grid_->addWidget(parts_.inputs, 0, 0, 2, 1);
    if (parts_.top != nullptr) {
        grid_->addWidget(parts_.top, 0, 1, 1, 2);
    }
    grid_->addWidget(parts_.plots, 1, 1);
    grid_->addWidget(results_, 1, 2);
    grid_->setRowStretch(1, 1);
    grid_->setColumnStretch(1, parts_.plotShare);
    grid_->setColumnStretch(2, parts_.resultShare);
    results_->setObjectName(QStringLiteral("results"));
    results_->setMaximumWidth(parts_.results->maximumWidth());
    results_->setMinimumWidth(resultsWidth_);
    parts_.results->setMinimumWidth(0);  // as narrow as it can be in a tab
    parts_.results->setMaximumWidth(QWIDGETSIZE_MAX);
}

int PageColumns::inputsWidth() {
    constexpr int designed = 316;
    return Theme::withText(designed);
}

int PageColumns::widthForAll() const {
    const int plots = std::max(Theme::withText(plotsWidth), leastWidth(parts_.plots));
    return leastWidth(parts_.inputs) + plots + resultsWidth_ + 4 * Theme::space;
}

void PageColumns::arrange() {
    const bool folded = width() < widthForAll();
    if (folded == folded_) {
        return;
    }
    folded_ = folded;
    if (folded) {
        grid_->removeWidget(results_);
        most_ = results_->maximumWidth();
        results_->setMinimumWidth(0);
        results_->setMaximumWidth(QWIDGETSIZE_MAX);
        parts_.tabs->addTab(results_, tr("Results"));
    } else {
        parts_.tabs->removeTab(parts_.tabs->indexOf(results_));
        grid_->addWidget(results_, 1, 2);
        results_->setMinimumWidth(resultsWidth_);
        results_->setMaximumWidth(most_);
        results_->show();
    }
    grid_->setColumnStretch(2, folded ? 0 : parts_.resultShare);
}

void PageColumns::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

QSize PageColumns::minimumSizeHint() const {
    const QSize all = QWidget::minimumSizeHint();
    const int narrowest = leastWidth(parts_.inputs) + leastWidth(parts_.plots) + 3 * Theme::space;
    return {std::min(all.width(), narrowest), all.height()};
}

FoldingRow::FoldingRow(int unfoldedFrom, QWidget* parent)
    : QWidget(parent),
      row_(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      unfoldedFrom_(unfoldedFrom) {
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(Theme::space);
}

void FoldingRow::add(QWidget* widget, int share) {
    row_->addWidget(widget, share);
}

bool FoldingRow::isFolded() const {
    return row_->direction() == QBoxLayout::TopToBottom;
}

void FoldingRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool folded = event->size().width() < Theme::withText(unfoldedFrom_);
    if (folded != isFolded()) {
        row_->setDirection(folded ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    }
}

QSize FoldingRow::minimumSizeHint() const {
    int width = 0;
    for (int i = 0; i < row_->count(); ++i) {
        width = std::max(width, row_->itemAt(i)->minimumSize().width());
    }
    return {width, row_->minimumSize().height()};
}

void addScrolledTab(QTabWidget* tabs, QWidget* view, const QString& name, const QString& title) {
    QScrollArea* area = scrolled(view, tabs);
    area->setObjectName(name);
    tabs->addTab(area, title);
}

void showTabOf(QWidget* view) {
    for (QWidget* around = view->parentWidget(); around != nullptr;
         around = around->parentWidget()) {
        if (auto* tabs = qobject_cast<QTabWidget*>(around)) {
            for (int tab = 0; tab < tabs->count(); ++tab) {
                if (tabs->widget(tab) == view || tabs->widget(tab)->isAncestorOf(view)) {
                    tabs->setCurrentIndex(tab);
                }
            }
        }
    }
}

}  // namespace ravnoves
