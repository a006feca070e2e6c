#include "widgets/mnemonics.h"

#include <QAbstractButton>
#include <QLabel>
#include <QMainWindow>
#include <QMap>
#include <QMenuBar>
#include <QStackedWidget>
#include <QTabBar>
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
    QWidget* place;
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
    std::vector<Labelled> texts;
    std::vector<QWidget*> places{page};  // and each page of tabs, after what it is in
    for (QWidget* each : page->findChildren<QWidget*>()) {
        QWidget* const place = placeOf(each, page);
        if (place == each) {
            places.push_back(each);
        }
        if (auto* label = qobject_cast<QLabel*>(each); label != nullptr && label->buddy()) {
            const auto show = [label](const QString& text) { label->setText(text); };
            texts.push_back({place, label->text(), show});
        } else if (auto* button = qobject_cast<QAbstractButton*>(each)) {
            const auto show = [button](const QString& text) { button->setText(text); };
            texts.push_back({place, button->text(), show});
        } else if (auto* bar = qobject_cast<QTabBar*>(each)) {
            for (int i = 0; i < bar->count(); ++i) {
                const auto show = [bar, i](const QString& text) { bar->setTabText(i, text); };
                texts.push_back({place, bar->tabText(i), show});
            }
        }
    }
    QMap<QWidget*, QString> letters;
    if (const auto* window = qobject_cast<QMainWindow*>(page->window())) {
        for (const QAction* menu : window->menuBar()->actions()) {
            letters[page] += mnemonicOf(menu->text());
        }
    }
    for (QWidget* place : places) {
        QString used = letters.value(place == page ? page : placeOf(place->parentWidget(), page));
        std::vector<const Labelled*> late;
        for (const Labelled& each : texts) {
            const QChar letter = mnemonicOf(each.text);
            if (each.place != place || letter.isNull()) {
                continue;
            }
            used.contains(letter) ? late.push_back(&each) : void(used += letter);
        }
        for (const Labelled* each : late) {
            QString bare = each->text;
            bare.remove(mnemonicAt(bare), 1);
            each->show(bare.contains(QLatin1Char('&')) ? bare : withMnemonic(bare, used));
        }
        letters[place] = used;
    }
}

}  // namespace ravnoves
