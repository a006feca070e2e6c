#include "shell/case_tabs.h"

#include <QKeySequence>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

const CaseTab* withId(const std::vector<CaseTab>& cases, int id) {
    const auto found = std::find_if(cases.begin(), cases.end(),
                                    [&](const CaseTab& each) { return each.id == id; });
    return found == cases.end() ? nullptr : &*found;
}

}  // namespace

CaseTabs::CaseTabs(QWidget* parent) : QTabBar(parent) {
    setObjectName(QStringLiteral("documents"));
    setDocumentMode(true);
    setDrawBase(true);
    setExpanding(false);
    setMovable(true);
    setUsesScrollButtons(true);
    setElideMode(Qt::ElideMiddle);
    renew();
    hide();
}

void CaseTabs::renew() {
    setAccessibleName(tr("Open cases"));
    setFont(Theme::font(Theme::smallSize));
    setIconSize(QSize(Theme::withText(16), Theme::withText(16)));
}

QSize CaseTabs::minimumTabSizeHint(int index) const {
    const QSize whole = tabSizeHint(index);
    return {std::min(whole.width(), Theme::withText(150)), whole.height()};
}

void CaseTabs::arrange(const std::vector<CaseTab>& cases, int front) {
    const QSignalBlocker blocker(this);
    for (int tab = count(); tab-- > 0;) {
        if (withId(cases, idOf(tab)) == nullptr) {
            tabButton(tab, QTabBar::RightSide)->deleteLater();  // the bar only hides it
            removeTab(tab);
        }
    }
    for (const CaseTab& each : cases) {
        int tab = 0;
        while (tab < count() && idOf(tab) != each.id) {
            ++tab;
        }
        if (tab == count()) {
            addCase(each);
        }
        if (each.id == front) {
            setCurrentIndex(tab);
        }
    }
    name(cases);
    setVisible(hasSeveral());
}

void CaseTabs::addCase(const CaseTab& added) {
    const int tab = addTab(themedIcon(added.icon), {});
    setTabData(tab, added.id);
    auto* button = new QToolButton(this);
    button->setIcon(themedIcon(QStringLiteral("close")));
    button->setIconSize(QSize(12, 12));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // Ctrl+W does it
    connect(button, &QToolButton::clicked, this, [this, id = added.id] { Q_EMIT closeAsked(id); });
    setTabButton(tab, QTabBar::RightSide, button);
}

void CaseTabs::name(const std::vector<CaseTab>& cases) {
    QStringList titles;
    for (int tab = 0; tab < count(); ++tab) {
        QWidget* button = tabButton(tab, QTabBar::RightSide);
        button->setToolTip(
            tr("Close (%1)")
                .arg(QKeySequence(Qt::CTRL | Qt::Key_W).toString(QKeySequence::NativeText)));
        button->setAccessibleName(tr("Close"));
        const CaseTab* of = withId(cases, idOf(tab));
        if (of == nullptr) {
            continue;
        }
        // Two of one name differ by their number.
        QString title = of->name;
        for (int number = 2; titles.contains(title); ++number) {
            title = of->name + QStringLiteral(" (%1)").arg(number);
        }
        titles << title;
        setTabText(tab, QString(title).replace(QLatin1Char('&'), QStringLiteral("&&")) +
                            (of->needsSaving ? QStringLiteral(" *") : QString()));
        setTabToolTip(tab, of->toolTip);
    }
}

void CaseTabs::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) {
        if (const int id = idOf(tabAt(event->pos())); id != 0) {
            Q_EMIT closeAsked(id);
            return;
        }
    }
    QTabBar::mouseReleaseEvent(event);
}

}  // namespace ravnoves
