// Every page, with each of its tabs in front, at the sizes of small and large windows, with normal
// and large text, in both languages: nothing is cut, hidden without a tip, overlapping or out of
// reach.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QSlider>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTextDocument>
#include <QToolBar>
#include <algorithm>
#include <functional>

#include "events.h"
#include "painted.h"
#include "plot/legend_item.h"
#include "plot/plot_view.h"
#include "scene_tests.h"
#include "shell/main_window.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/figure.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// A window as people have it.
struct Look {
    const char* name;
    QSize size;
    double text;
};

const Look unfolded{"at1920x1080", {1920, 1080}, 1.0};
const Look folded{"LargeTextOnALaptop", {1360, 850}, 2.0};
const Look looks[] = {
    {"at1024x700", {1024, 700}, 1.0},
    {"at1280x800", {1280, 800}, 1.0},
    unfolded,
    {"LargeText", {1920, 1080}, 2.0},
    {"ScaleFactor2", {960, 540}, 1.0},  // of a screen of 1920×1080
    folded,
};

constexpr int tolerance = 1;  // pixels

/// Where a widget is, so that one finds it: "balance-shaft › torque › QLabel “Bore d”".
QString placeOf(const QWidget* widget) {
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

bool hasWholeTip(const QWidget* widget, const QString& text) {
    QString bare = text;
    return widget->toolTip().contains(bare.remove(u'&'));
}

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
                !hasWholeTip(button, button->text())) {
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
            constexpr int least = 24;
            for (int i = 0; i < header->count(); ++i) {
                if (!header->isSectionHidden(i)) {
                    needs(table, header->sectionSize(i), least, u"column %1"_s.arg(i));
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
            constexpr int least = 110;
            needs(slider, slider->width(), least, u"a hand"_s);
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
            if (each->isVisible() && !each->isWindow()) {
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

class Looks : public ::testing::TestWithParam<std::tuple<std::string, Look, const char*>> {
  protected:
    ~Looks() override {
        installLanguage(u"en"_s);
        Theme::instance().setTextScale(1.0);
    }

    /// Brings the tabs that hold a widget to the front.
    static void show(const QWidget* widget) {
        for (QWidget* each = widget->parentWidget(); each != nullptr; each = each->parentWidget()) {
            if (auto* tabs = qobject_cast<QTabWidget*>(each)) {
                for (int i = 0; i < tabs->count(); ++i) {
                    if (tabs->widget(i)->isAncestorOf(widget)) {
                        tabs->setCurrentIndex(i);
                    }
                }
            }
        }
    }
    static void onEveryTab(QWidget* page, const std::function<void(const QString&)>& look) {
        look(u"first"_s);
        for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
            show(tabs);
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                for (int turn = 0; turn < 3; ++turn) {
                    QApplication::processEvents();
                }
                look(QString(tabs->tabText(i)).remove(u'&'));
            }
            tabs->setCurrentIndex(0);
        }
    }
};

TEST_P(Looks, NothingIsCutOrOutOfReach) {
    const auto& [scene, look, language] = GetParam();
    installLanguage(QString::fromLatin1(language));
    Theme::instance().setTextScale(look.text);
    MainWindow window;
    window.showScene(QString::fromStdString(scene));
    test::showAt(window, look.size);
    EXPECT_EQ(window.size(), look.size);
    ScenePage* page = window.currentPage();
    QStringList said;
    onEveryTab(page, [&](const QString& tab) {
        QStringList faults = Checker(page).faults();
        for (int turn = 0; turn < 20 && !faults.isEmpty(); ++turn) {
            constexpr int rest = 200;  // ms: what waits until the hand rests is laid out then
            QTest::qWait(rest);
            faults = Checker(page).faults();
        }
        for (const QString& fault : faults) {
            if (!said.contains(fault)) {
                said << fault;
                ADD_FAILURE() << tab.toStdString() << " › " << fault.toStdString();
            }
        }
    });
}

TEST_P(Looks, EveryStopOfTheTabKeyCanBeSeen) {
    const auto& [scene, look, language] = GetParam();
    installLanguage(QString::fromLatin1(language));
    Theme::instance().setTextScale(look.text);
    MainWindow window;
    window.showScene(QString::fromStdString(scene));
    test::showAt(window, look.size);
    window.activateWindow();
    QWidget* page = window.currentPage();
    QWidget* first = nullptr;
    QTest::keyClick(page, Qt::Key_Tab);
    for (int i = 0; i < 400; ++i) {
        QWidget* focus = QApplication::focusWidget();
        if (focus == nullptr || focus == first) {
            break;
        }
        first = first == nullptr ? focus : first;
        if (page->isAncestorOf(focus)) {
            const auto* area = qobject_cast<const QAbstractScrollArea*>(focus);
            EXPECT_FALSE(focus->visibleRegion().isEmpty() &&
                         (area == nullptr || area->viewport()->visibleRegion().isEmpty()))
                << placeOf(focus).toStdString();
        }
        QTest::keyClick(focus, Qt::Key_Tab);
    }
}

QChar letterOf(const QString& text) {
    const qsizetype at = QString(text).replace(u"&&"_s, u"  "_s).indexOf(u'&');
    return at >= 0 && at + 1 < text.size() ? text.at(at + 1).toLower() : QChar();
}

/// Letters depend on what is folded, not on the size.
class Letters : public Looks {};

TEST_P(Letters, NoneOfThePageIsAMenus) {
    const auto& [scene, look, language] = GetParam();
    installLanguage(QString::fromLatin1(language));
    Theme::instance().setTextScale(look.text);
    MainWindow window;
    window.showScene(QString::fromStdString(scene));
    test::showAt(window, look.size);
    QString menus;
    for (const QAction* menu : window.menuBar()->actions()) {
        menus += letterOf(menu->text());
    }
    EXPECT_GE(menus.size(), 4);
    QWidget* page = window.currentPage();
    onEveryTab(page, [&](const QString&) {
        for (const QWidget* each : page->findChildren<QWidget*>()) {
            QStringList texts;
            if (const auto* label = qobject_cast<const QLabel*>(each)) {
                texts << (label->buddy() != nullptr ? label->text() : QString());
            } else if (const auto* button = qobject_cast<const QAbstractButton*>(each)) {
                texts << button->text();
            } else if (const auto* bar = qobject_cast<const QTabBar*>(each)) {
                for (int i = 0; i < bar->count(); ++i) {
                    texts << bar->tabText(i);
                }
            }
            for (const QString& text : texts) {
                const QChar letter = letterOf(text);
                EXPECT_FALSE(each->isVisible() && !letter.isNull() && menus.contains(letter))
                    << text.toStdString();
            }
        }
    });
}

std::string nameOf(const ::testing::TestParamInfo<Looks::ParamType>& each) {
    return test::testName(std::get<0>(each.param) + "_" + std::get<1>(each.param).name + "_" +
                          std::get<2>(each.param));
}

INSTANTIATE_TEST_SUITE_P(Pages, Looks,
                         ::testing::Combine(::testing::ValuesIn(test::sceneNames()),
                                            ::testing::ValuesIn(looks),
                                            ::testing::Values("en", "ru")),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Pages, Letters,
                         ::testing::Combine(::testing::ValuesIn(test::sceneNames()),
                                            ::testing::Values(unfolded, folded),
                                            ::testing::Values("en", "ru")),
                         nameOf);

}  // namespace
}  // namespace ravnoves
