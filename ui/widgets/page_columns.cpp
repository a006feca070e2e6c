#include "widgets/page_columns.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QShowEvent>
#include <QTabBar>
#include <QTabWidget>
#include <algorithm>
#include <utility>

#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

namespace {

constexpr int plotsWidth = 440;  ///< designed pixels that plots need at least
constexpr int plotShare = 5;

/// Groups of tabs, with room between them and the tabs.
class GroupBar : public QTabBar {
  public:
    using QTabBar::QTabBar;

    QSize sizeHint() const override { return QTabBar::sizeHint() + QSize(3 * Theme::space, 0); }
};

/// 0 for none.
int minWidth(const QWidget* widget) {
    return widget != nullptr ? std::max(widget->minimumWidth(), widget->minimumSizeHint().width())
                             : 0;
}

int minHeight(const QWidget* widget) {
    return std::max(widget->minimumHeight(), widget->minimumSizeHint().height());
}

}  // namespace

PageColumns::PageColumns(const Parts& parts, QWidget* parent)
    : QWidget(parent),
      parts_(parts),
      grid_(new QGridLayout(this)),
      results_(scrolled(parts.results, this)),
      resultsWidth_(minWidth(parts.results) + results_->verticalScrollBar()->sizeHint().width() +
                    2),
      inputsMin_(minWidth(parts.inputs)),
      inputsAlone_(parts.narrowest > 0 ? parts.narrowest : inputsMin_),
      inputsMax_(parts.inputs->maximumWidth()),
      resultsMax_(parts.results->maximumWidth()) {
    grid_->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    grid_->setSpacing(Theme::space);
    placeTop(false);
    if (parts_.plots != nullptr) {
        grid_->addWidget(parts_.plots, 1, 1);
    }
    grid_->addWidget(results_, 1, 2);
    grid_->setRowStretch(1, 1);
    grid_->setColumnStretch(1, parts_.plots != nullptr ? plotShare : 0);
    grid_->setColumnStretch(2, parts_.resultShare);
    results_->setObjectName(QStringLiteral("results"));
    results_->setMaximumWidth(resultsMax_);
    results_->setMinimumWidth(resultsWidth_);
    parts_.results->setMinimumWidth(0);  // as narrow as it can be in a tab
    parts_.results->setMaximumWidth(QWIDGETSIZE_MAX);
}

int PageColumns::inputsWidth() {
    constexpr int designed = 316;
    return Theme::withText(designed);
}

PageColumns::Fold PageColumns::foldFor(int width) const {
    const int two = inputsMin_ + 3 * Theme::space;
    if (parts_.plots == nullptr) {
        return width >= two + resultsWidth_ ? Fold::None : Fold::Plots;
    }
    const int plots = std::max(minWidth(parts_.plots), minWidth(parts_.top));
    const int roomy = std::max(Theme::withText(plotsWidth), plots);
    if (width >= two + roomy + resultsWidth_ + Theme::space) {
        return Fold::None;
    }
    return width >= two + plots ? Fold::Results : Fold::Plots;
}

void PageColumns::placeTop(bool overAll) {
    // Over the columns that there are: an empty one leaves the spacing before it.
    const int first = overAll ? 0 : 1;
    const int end = fold_ == Fold::None ? 3 : fold_ == Fold::Results || !overAll ? 2 : 1;
    grid_->removeWidget(parts_.inputs);
    grid_->addWidget(parts_.inputs, overAll ? 1 : 0, 0, overAll ? 1 : 2, 1);
    if (parts_.top != nullptr) {
        grid_->removeWidget(parts_.top);
        grid_->addWidget(parts_.top, 0, first, 1, end - first);
    }
}

void PageColumns::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const Fold fold = foldFor(width());
    if (std::exchange(fold_, fold) == fold) {
        return;
    }
    const bool folds = fold != Fold::None;
    place(results_, tr("Results"), 2, folds ? 0 : parts_.resultShare);
    results_->setMinimumWidth(folds ? 0 : resultsWidth_);
    results_->setMaximumWidth(folds ? QWIDGETSIZE_MAX : resultsMax_);
    const bool isAlone = fold == Fold::Plots;
    if (parts_.plots != nullptr) {
        place(parts_.plots, tr("Plots"), 1, isAlone ? 0 : plotShare);
    }
    parts_.inputs->setMaximumWidth(isAlone ? QWIDGETSIZE_MAX : inputsMax_);
    if (inputsAlone_ < inputsMin_) {
        parts_.inputs->setMinimumWidth(isAlone ? inputsAlone_ : inputsMin_);
    }
    grid_->setColumnStretch(0, isAlone ? 1 : 0);
    placeTop(isAlone);
}

void PageColumns::place(QWidget* part, const QString& title, int column, int share) {
    const int tab = parts_.tabs->indexOf(part);
    if (share == 0 && tab < 0) {
        grid_->removeWidget(part);
        parts_.tabs->addTab(part, title);
    } else if (share > 0 && tab >= 0) {
        parts_.tabs->removeTab(tab);
        grid_->addWidget(part, 1, column);
        part->show();
    }
    grid_->setColumnStretch(column, share);
}

QSize PageColumns::minimumSizeHint() const {
    const QSize all = QWidget::minimumSizeHint();
    const int narrowest =
        std::max({inputsAlone_, minWidth(parts_.plots), minWidth(parts_.top)}) + 2 * Theme::space;
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

int FoldingRow::neededUnfolded() const {
    if (unfoldedFrom_ > 0) {
        return Theme::withText(unfoldedFrom_);
    }
    int width = (row_->count() - 1) * row_->spacing();
    for (int i = 0; i < row_->count(); ++i) {
        width += row_->itemAt(i)->sizeHint().width();
    }
    return width;
}

void FoldingRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool folded = event->size().width() < neededUnfolded();
    if (folded != isFolded()) {
        row_->setDirection(folded ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
        Q_EMIT foldChanged(folded);
    }
}

QSize FoldingRow::minimumSizeHint() const {
    int width = 0;
    for (int i = 0; i < row_->count(); ++i) {
        width = std::max(width, row_->itemAt(i)->minimumSize().width());
    }
    return {width, row_->minimumSize().height()};
}

FittedTabs::FittedTabs(QWidget* parent) : QTabWidget(parent) {
    connect(this, &QTabWidget::currentChanged, this, &QWidget::updateGeometry);
}

void FittedTabs::beginGroup(const QString& title) {
    if (groups_ == nullptr) {
        groups_ = new GroupBar(this);
        groups_->setDrawBase(false);
        groups_->setExpanding(false);
        setCornerWidget(groups_, Qt::TopLeftCorner);
        connect(this, &QTabWidget::currentChanged, this, &FittedTabs::showGroup);
        connect(groups_, &QTabBar::currentChanged, this,
                [this](int group) { setCurrentIndex(groups_->tabData(group).toInt()); });
    }
    groups_->setTabData(groups_->addTab(title), count());
}

int FittedTabs::groupOf(int tab) const {
    return tabBar()->tabData(tab).toInt();
}

void FittedTabs::showGroup() {
    const int group = groupOf(currentIndex());
    groups_->setTabData(group, currentIndex());
    groups_->setCurrentIndex(group);
    setTabVisible(currentIndex(), true);  // first: Qt turns from a hidden one to what is shown
    for (int i = 0; i < count(); ++i) {
        setTabVisible(i, groupOf(i) == group);
    }
    fit();
}

int FittedTabs::barHeight() const {
    int highest = 0;
    for (int i = 0; i < count(); ++i) {
        highest = std::max(highest, minHeight(widget(i)));
    }
    return QTabWidget::minimumSizeHint().height() - highest;
}

QSize FittedTabs::minimumSizeHint() const {
    const QSize all = QTabWidget::minimumSizeHint();
    return count() == 0 ? all : QSize(all.width(), barHeight() + minHeight(currentWidget()));
}

bool FittedTabs::hasHeightForWidth() const {
    const QLayout* front = count() == 0 ? nullptr : currentWidget()->layout();
    return front != nullptr && front->hasHeightForWidth();
}

int FittedTabs::heightForWidth(int width) const {
    if (!hasHeightForWidth()) {
        return -1;
    }
    const int room = std::min(width, currentWidget()->maximumWidth());
    return barHeight() + currentWidget()->layout()->minimumHeightForWidth(room);
}

void FittedTabs::resizeEvent(QResizeEvent* event) {
    fit();
    QTabWidget::resizeEvent(event);
}

void FittedTabs::tabInserted(int index) {
    QTabWidget::tabInserted(index);
    if (groups_ != nullptr) {
        tabBar()->setTabData(index, groups_->count() - 1);
        showGroup();
    }
    fit();
}

void FittedTabs::fit() {
    const bool fits = Theme::tabsWidth(*this, Theme::font(), 2 * Theme::gap + 2) <= width();
    const QFont font = fits ? Theme::font() : Theme::font(Theme::smallSize);
    if (tabBar()->font() != font) {
        tabBar()->setFont(font);
    }
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
