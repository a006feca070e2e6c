#include "shell/whats_this.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QShortcut>
#include <QTabBar>
#include <QWhatsThis>
#include <QWidget>

namespace ravnoves {

namespace {

QString paragraphs(const QString& title, const QString& text) {
    if (text.isEmpty()) {
        return {};
    }
    const QString body = Qt::mightBeRichText(text) ? text
                                                   : text.toHtmlEscaped().replace(
                                                         QLatin1Char('\n'), QStringLiteral("<br>"));
    return (title.isEmpty() || text.startsWith(title)
                ? QString()
                : QStringLiteral("<p><b>%1</b></p>").arg(title.toHtmlEscaped())) +
           QStringLiteral("<p>%1</p>").arg(body);
}

QString ofCell(const QModelIndex& index) {
    const QAbstractItemModel* model = index.model();
    QString title = model->headerData(index.row(), Qt::Vertical, Qt::AccessibleTextRole).toString();
    if (title.isEmpty() && index.column() > 0) {
        title = index.siblingAtColumn(0).data().toString();
    }
    const QString tip = index.data(Qt::ToolTipRole).toString();
    return paragraphs(
        title, !tip.isEmpty() ? tip : index.siblingAtColumn(0).data(Qt::ToolTipRole).toString());
}

/// Of what a view shows at a place of its viewport.
QString inView(const QAbstractItemView* view, const QPoint& at) {
    if (const auto* header = qobject_cast<const QHeaderView*>(view)) {
        const int section = header->logicalIndexAt(at);
        const auto read = [&](int role) {
            return header->model()->headerData(section, header->orientation(), role).toString();
        };
        return section < 0 || header->model() == nullptr
                   ? QString()
                   : paragraphs(read(Qt::DisplayRole), read(Qt::ToolTipRole));
    }
    const QModelIndex index = view->indexAt(at);
    return index.isValid() ? ofCell(index) : QString();
}

QString nameOf(const QWidget* widget) {
    QString name = widget->accessibleName();
    if (name.isEmpty()) {
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            name = button->text();
        } else if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            name = Qt::mightBeRichText(label->text()) ? QString() : label->text();
        }
    }
    return name.remove(QLatin1Char('&'));
}

}  // namespace

WhatsThis::WhatsThis(QWidget* window)
    : QObject(window),
      action_(new QAction(tr("&What’s this?") + QStringLiteral("\tShift+F1"), this)) {
    // The key asks what has the focus, so it is not the action's own.
    connect(action_, &QAction::triggered, this, [] { QWhatsThis::enterWhatsThisMode(); });
    auto* key = new QShortcut(Qt::SHIFT | Qt::Key_F1, window);
    connect(key, &QShortcut::activated, this, &WhatsThis::explainFocus);
    connect(this, &QObject::destroyed, key, &QObject::deleteLater);
    qApp->installEventFilter(this);
}

QString WhatsThis::explanation(const QWidget* widget, const QPoint& at) {
    if (!widget->whatsThis().isEmpty()) {
        return widget->whatsThis();
    }
    if (const auto* view = qobject_cast<const QAbstractItemView*>(widget->parentWidget());
        view != nullptr && view->viewport() == widget) {
        if (QString text = inView(view, at); !text.isEmpty()) {
            return text;
        }
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
        const int tab = tabs->tabAt(at);
        if (tab >= 0 && !tabs->tabToolTip(tab).isEmpty()) {
            return paragraphs(tabs->tabText(tab).remove(QLatin1Char('&')), tabs->tabToolTip(tab));
        }
    }
    if (!widget->toolTip().isEmpty()) {
        return paragraphs(nameOf(widget), widget->toolTip());
    }
    if (const auto* label = qobject_cast<const QLabel*>(widget);
        label != nullptr && label->buddy() != nullptr) {
        return explanation(label->buddy(), {});
    }
    return paragraphs(nameOf(widget), widget->accessibleDescription());
}

void WhatsThis::explainFocus() {
    QWidget* focus = QApplication::focusWidget();
    if (focus == nullptr) {
        QWhatsThis::enterWhatsThisMode();
        return;
    }
    QPoint at = focus->rect().center();
    QString text;
    if (const auto* view = qobject_cast<const QAbstractItemView*>(focus);
        view != nullptr && view->currentIndex().isValid()) {
        text = ofCell(view->currentIndex());
        at = view->visualRect(view->currentIndex()).center();
    }
    for (QWidget* each = focus; text.isEmpty() && each != nullptr; each = each->parentWidget()) {
        text = explanation(each, {});
    }
    if (text.isEmpty()) {
        QWhatsThis::enterWhatsThisMode();
    } else {
        QWhatsThis::showText(focus->mapToGlobal(at), text, focus);
    }
}

bool WhatsThis::eventFilter(QObject* watched, QEvent* event) {
    const bool asks = event->type() == QEvent::QueryWhatsThis;
    if ((!asks && event->type() != QEvent::WhatsThis) || !watched->isWidgetType()) {
        return false;
    }
    auto* widget = static_cast<QWidget*>(watched);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = explanation(widget, help->pos());
    if (text.isEmpty()) {
        return false;
    }
    if (!asks) {
        QWhatsThis::showText(help->globalPos(), text, widget);
    }
    event->accept();
    return true;
}

}  // namespace ravnoves
