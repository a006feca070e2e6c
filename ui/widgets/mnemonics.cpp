#include "widgets/mnemonics.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>
#include <functional>

namespace ravnoves {

namespace {

const char* const wantedKey = "wantedMnemonicText";
const char* const givenKey = "givenMnemonicText";

qsizetype mnemonicAt(const QString& text) {
    qsizetype at = text.indexOf(QLatin1Char('&'));
    while (at >= 0 && text.mid(at + 1, 1) == QLatin1String("&")) {
        at = text.indexOf(QLatin1Char('&'), at + 2);
    }
    return at >= 0 && at + 1 < text.size() ? at : -1;
}

class Keeper final : public QObject {
  public:
    explicit Keeper(QWidget* page) : QObject(page), page_(page) {
        timer_.setSingleShot(true);
        timer_.callOnTimeout(this, [this] { separate(); });
        qApp->installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        const QEvent::Type type = event->type();
        if ((type == QEvent::ShowToParent || type == QEvent::HideToParent) && !timer_.isActive() &&
            watched->isWidgetType() && page_->isAncestorOf(static_cast<QWidget*>(watched))) {
            timer_.start(0);
        }
        return false;
    }

  private:
    struct Text {
        QObject* owner;
        QByteArray key;  ///< of the owner's properties
        QString shown;
        std::function<void(const QString&)> show;
        int depth = 0;  ///< of pages of tabs that it stands in
    };

    int depthOf(const QWidget* widget) const {
        int depth = 0;
        for (const QWidget* each = widget; each != page_; each = each->parentWidget()) {
            depth += qobject_cast<const QStackedWidget*>(each) != nullptr &&
                             qobject_cast<const QTabWidget*>(each->parentWidget()) != nullptr
                         ? 1
                         : 0;
        }
        return depth;
    }

    QList<Text> texts() const {
        QList<Text> all;
        for (QWidget* each : page_->findChildren<QWidget*>()) {
            if (!each->isVisibleTo(page_)) {
                continue;
            }
            const qsizetype before = all.size();
            if (auto* label = qobject_cast<QLabel*>(each)) {
                if (label->buddy() != nullptr) {
                    all.push_back({label, {}, label->text(), [label](const QString& text) {
                                       label->setText(text);
                                   }});
                }
            } else if (auto* button = qobject_cast<QAbstractButton*>(each)) {
                all.push_back({button, {}, button->text(), [button](const QString& text) {
                                   button->setText(text);
                               }});
            } else if (auto* bar = qobject_cast<QTabBar*>(each)) {
                for (int i = 0; i < bar->count(); ++i) {
                    all.push_back({bar, QByteArray::number(i), bar->tabText(i),
                                   [bar, i](const QString& text) { bar->setTabText(i, text); }});
                }
            }
            for (qsizetype i = before; i < all.size(); ++i) {
                all[i].depth = depthOf(each);
            }
        }
        return all;
    }

    void separate() {
        QString used;
        if (const auto* window = qobject_cast<QMainWindow*>(page_->window())) {
            for (const QAction* menu : window->menuBar()->actions()) {
                const qsizetype at = mnemonicAt(menu->text());
                used += at < 0 ? QString() : menu->text().mid(at + 1, 1).toLower();
            }
        }
        // What stands on the page with any tab in front comes first: it keeps its letters when the
        // tabs change.
        QList<Text> all = texts();
        std::stable_sort(all.begin(), all.end(),
                         [](const Text& a, const Text& b) { return a.depth < b.depth; });
        for (auto from = all.cbegin(); from != all.cend();) {
            const auto to = std::find_if(from, all.cend(), [depth = from->depth](const Text& text) {
                return text.depth != depth;
            });
            separate(from, to, used);
            from = to;
        }
    }

    using Place = QList<Text>::const_iterator;
    static void separate(Place from, Place to, QString& used) {
        QList<Text> late;
        const auto give = [](const Text& text, const QString& given) {
            text.owner->setProperty(givenKey + text.key, given);
            if (given != text.shown) {
                text.show(given);
            }
        };
        for (; from != to; ++from) {
            const Text& text = *from;
            if (text.owner->property(givenKey + text.key).toString() != text.shown) {
                text.owner->setProperty(wantedKey + text.key, text.shown);
            }
            const QString wanted = text.owner->property(wantedKey + text.key).toString();
            const qsizetype at = mnemonicAt(wanted);
            if (at < 0) {
                continue;
            }
            const QChar letter = wanted.at(at + 1).toLower();
            if (used.contains(letter)) {
                late << text;
            } else {
                used += letter;
                give(text, wanted);
            }
        }
        for (const Text& text : late) {
            QString wanted = text.owner->property(wantedKey + text.key).toString();
            wanted.remove(mnemonicAt(wanted), 1);
            give(text, wanted.contains(QLatin1Char('&')) ? wanted : withMnemonic(wanted, used));
        }
    }

    QWidget* page_;
    QTimer timer_;
};

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

void keepMnemonicsApart(QWidget* page) {
    new Keeper(page);
}

}  // namespace ravnoves
