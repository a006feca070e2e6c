#include "widgets/mnemonics.h"

#include <QAbstractButton>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QStackedWidget>
#include <QTabWidget>
#include <functional>
#include <vector>

namespace ravnoves {

namespace {

qsizetype mnemonicAt(const QString& text) {
    qsizetype at = text.indexOf(QLatin1Char('&'));
    while (at >= 0 && text.mid(at + 1, 1) == QLatin1String("&")) {
        at = text.indexOf(QLatin1Char('&'), at + 2);
    }
    return at >= 0 && at + 1 < text.size() ? at : -1;
}

QChar mnemonicOf(const QString& text) {
    const qsizetype at = mnemonicAt(text);
    return at < 0 ? QChar() : text.at(at + 1).toLower();
}

struct Labelled {
    QString text;
    std::function<void(const QString&)> show;
};

/// The tab's page that a widget is in directly; the page where it is in none.
QWidget* placeOf(QWidget* widget, QWidget* page) {
    while (widget != page) {
        QWidget* around = widget->parentWidget();
        if (qobject_cast<QStackedWidget*>(around) != nullptr &&
            qobject_cast<QTabWidget*>(around->parentWidget()) != nullptr) {
            return widget;
        }
        widget = around;
    }
    return page;
}

void separateIn(QWidget* place, const std::vector<std::pair<QWidget*, Labelled>>& texts,
                const std::vector<std::pair<QWidget*, QWidget*>>& tabs, QString used) {
    std::vector<const Labelled*> late;
    for (const auto& [where, each] : texts) {
        if (const QChar letter = mnemonicOf(each.text); where != place || letter.isNull()) {
            continue;
        } else if (used.contains(letter)) {
            late.push_back(&each);
        } else {
            used += letter;
        }
    }
    for (const Labelled* each : late) {
        QString bare = each->text;
        bare.remove(mnemonicAt(bare), 1);
        each->show(bare.contains(QLatin1Char('&')) ? bare : withMnemonic(bare, used));
    }
    for (const auto& [tab, around] : tabs) {
        if (around == place) {
            separateIn(tab, texts, tabs, used);
        }
    }
}

}  // namespace

QString withMnemonic(QString label, QString& used) {
    for (const bool wordStart : {true, false}) {
        for (qsizetype i = 0; i < label.size(); ++i) {
            const QChar c = label.at(i).toLower();
            const bool onKeyboard = c.isLetter() && c.script() != QChar::Script_Greek;
            if (!onKeyboard || used.contains(c) ||
                (wordStart && i > 0 && !label.at(i - 1).isSpace())) {
                continue;
            }
            used += c;
            return label.insert(i, QLatin1Char('&'));
        }
    }
    return label;
}

void separateMnemonics(QWidget* page) {
    std::vector<std::pair<QWidget*, Labelled>> texts;
    std::vector<std::pair<QWidget*, QWidget*>> tabs;  // each page of tabs, and what they are in
    for (QWidget* each : page->findChildren<QWidget*>()) {
        QWidget* const place = placeOf(each, page);
        if (place == each) {
            tabs.emplace_back(each, placeOf(each->parentWidget(), page));
        }
        if (auto* label = qobject_cast<QLabel*>(each); label != nullptr && label->buddy()) {
            const auto show = [label](const QString& text) { label->setText(text); };
            texts.push_back({place, {label->text(), show}});
        } else if (auto* button = qobject_cast<QAbstractButton*>(each)) {
            const auto show = [button](const QString& text) { button->setText(text); };
            texts.push_back({place, {button->text(), show}});
        } else if (auto* bar = qobject_cast<QTabBar*>(each)) {
            for (int i = 0; i < bar->count(); ++i) {
                const auto show = [bar, i](const QString& text) { bar->setTabText(i, text); };
                texts.push_back({place, {bar->tabText(i), show}});
            }
        }
    }
    QString used;
    if (const auto* window = qobject_cast<QMainWindow*>(page->window())) {
        for (const QAction* menu : window->menuBar()->actions()) {
            used += mnemonicOf(menu->text());
        }
    }
    separateIn(page, texts, tabs, used);
}

}  // namespace ravnoves
