#include "shell/case_tabs.h"

#include <QKeySequence>
#include <QMouseEvent>
#include <QToolButton>
#include <algorithm>

#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {

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

int CaseTabs::tabOf(int id, const QString& icon) {
    for (int tab = 0; tab < count(); ++tab) {
        if (idOf(tab) == id) {
            return tab;
        }
    }
    const int tab = addTab(themedIcon(icon), {});
    setTabData(tab, id);
    auto* button = new QToolButton(this);
    button->setIcon(themedIcon(QStringLiteral("close")));
    button->setIconSize(QSize(12, 12));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // Ctrl+W does it
    connect(button, &QToolButton::clicked, this, [this, id] { Q_EMIT closeAsked(id); });
    setTabButton(tab, QTabBar::RightSide, button);
    return tab;
}

void CaseTabs::removeCase(int tab) {
    tabButton(tab, QTabBar::RightSide)->deleteLater();  // the bar only hides it
    removeTab(tab);
}

void CaseTabs::name(int tab, const QString& title, bool needsSaving, const QString& toolTip) {
    QWidget* button = tabButton(tab, QTabBar::RightSide);
    button->setToolTip(
        tr("Close (%1)")
            .arg(QKeySequence(Qt::CTRL | Qt::Key_W).toString(QKeySequence::NativeText)));
    button->setAccessibleName(tr("Close"));
    setTabText(tab, QString(title).replace(QLatin1Char('&'), QStringLiteral("&&")) +
                        (needsSaving ? QStringLiteral(" *") : QString()));
    setTabToolTip(tab, toolTip);
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
