// What holds for every page, whatever its scene.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QPlainTextEdit>
#include <QSet>
#include <QSlider>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "balance-shaft/torque_source_editor.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "events.h"
#include "model/case_document.h"
#include "page/mechanism_picture.h"
#include "page/scene_page.h"
#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "scene_tests.h"
#include "scenes/open_example.h"
#include "scenes/scenes.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"
#include "widgets/result_table.h"
#include "widgets/table_editor.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class EveryPage : public ::testing::TestWithParam<std::string> {
  protected:
    EveryPage() {
        test::showAt(*page, {1280, 800});
        page->activateWindow();
    }

    static std::unique_ptr<ScenePage> make() { return test::makePage(GetParam()); }
    SceneModel& model() { return *page->model(); }

    void showDetails() {
        for (auto* fold : page->findChildren<QToolButton*>(QStringLiteral("details"))) {
            fold->setChecked(true);
        }
    }
    /// Calls `look` with each tab of the page in front in turn.
    void onEveryTab(const std::function<void()>& look) {
        look();
        test::onEveryTab(*page, look);
    }
    /// The inputs that the user can reach now.
    template <typename Widget>
    QList<Widget*> reachable() const {
        QList<Widget*> found = page->findChildren<Widget*>();
        found.removeIf([](Widget* each) { return !each->isVisible() || !each->isEnabled(); });
        return found;
    }
    /// Fields for a number of the case, each once, on whatever tab it is.
    void forEachField(const std::function<void(NumberField&)>& visit) {
        QSet<NumberField*> seen;
        onEveryTab([&] {
            for (NumberField* field : reachable<NumberField>()) {
                if (!seen.contains(field) && !field->isReadOnly() && field->isVisible()) {
                    seen << field;
                    visit(*field);
                }
            }
        });
    }
    static void type(QWidget& field, const QString& text) {
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&field, text);
    }
    /// So many fields must have been tried; a small scene has fewer.
    qsizetype enough() {
        const auto fields = model().describedFields();
        return std::min<qsizetype>(
            6, std::count_if(fields.begin(), fields.end(),
                             [](const auto& it) { return it.kind == FieldKind::number; }));
    }
    /// True where a label that can be seen says this.
    bool says(const QString& text) const {
        const auto labels = reachable<QLabel>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(text); });
    }
    /// The letter after a text's &; null where there is none.
    static QChar mnemonicOf(const QString& text) {
        const QKeySequence keys = QKeySequence::mnemonic(text);
        return keys.isEmpty() ? QChar() : QChar(static_cast<char16_t>(keys[0].key()));
    }
    /// Another number than the field's that may do as well.
    static QString near(const NumberField& field) {
        const double value = field.value().value_or(1.0);
        const double other =
            value == std::floor(value) && std::abs(value) < 100.0 ? value + 1.0 : value * 1.01;
        return QString::number(other, 'g', 10);
    }

    std::unique_ptr<ScenePage> page = make();
};

/// With a history and a file.
class EveryCase : public EveryPage {};

/// Where all colours are one, as in print, two curves of a legend differ by dash, marker or width.
TEST_P(EveryPage, CurvesAreDistinguishableWithoutColours) {
    using plot::Shape;
    test::openExample(model());
    showDetails();
    int pairs = 0;
    onEveryTab([&] {
        for (const PlotView* plot : reachable<PlotView>()) {
            const auto& curves = plot->data().curves;
            const auto isNamed = [](const PlotCurve& curve) {
                return curve.style.inLegend && !curve.style.name.isEmpty();
            };
            for (std::size_t i = 0; i < curves.size(); ++i) {
                for (std::size_t k = 0; isNamed(curves[i]) && k < i; ++k) {
                    if (!isNamed(curves[k])) {
                        continue;
                    }
                    ++pairs;
                    const plot::CurveStyle& one = curves[i].style;
                    const plot::CurveStyle& other = curves[k].style;
                    const RoleLook look = lookOf(one.role);
                    const RoleLook than = lookOf(other.role);
                    const auto [thin, thick] = std::minmax(one.width, other.width);
                    const bool hasMarker = one.shape != Shape::Line && one.shape != Shape::Bars;
                    EXPECT_TRUE(one.shape != other.shape || look.pen != than.pen ||
                                (hasMarker ? look.marker != than.marker : thick > 1.9 * thin))
                        << plot->title().toStdString() << ": " << other.name.toStdString() << ", "
                        << one.name.toStdString();
                }
            }
        }
    });
    EXPECT_EQ(pairs > 0, !page->findChildren<PlotView*>().isEmpty());
}

TEST_P(EveryPage, NamesAndExplainsEveryInput) {
    QSet<const QWidget*> labelled;
    for (const QLabel* label : page->findChildren<QLabel*>()) {
        labelled << label->buddy();
    }
    QSet<const QWidget*> checked;
    const auto check = [&](const QWidget& input, const QString& text = {}) {
        if (checked.contains(&input)) {
            return;
        }
        checked << &input;
        const auto what = (input.objectName() + u" "_s + text + input.accessibleName() + u" in "_s +
                           input.parentWidget()->metaObject()->className())
                              .toStdString();
        EXPECT_FALSE(input.accessibleName().isEmpty() && text.isEmpty()) << what;
        EXPECT_FALSE(input.toolTip().isEmpty()) << what;
        // The cells of a grid are named by its lines and columns.
        EXPECT_TRUE(labelled.contains(&input) || input.property("isCell").toBool() ||
                    !text.isEmpty())
            << what;
    };
    for (const EntryField* input : page->findChildren<EntryField*>()) {
        EXPECT_FALSE(input->whatsThis().isEmpty()) << qPrintable(input->objectName());
    }
    for (const NumberField* input : page->findChildren<NumberField*>()) {
        EXPECT_TRUE(input->toolTip().contains(u"must be")) << qPrintable(input->objectName());
    }
    onEveryTab([&] {
        for (const EntryField* input : reachable<EntryField>()) {
            check(*input);
        }
        for (const QComboBox* input : reachable<QComboBox>()) {
            check(*input);
        }
        for (const QCheckBox* input : reachable<QCheckBox>()) {
            check(*input, input->text());
        }
        for (const QPlainTextEdit* input : reachable<QPlainTextEdit>()) {
            check(*input);
        }
        for (const QSlider* input : reachable<QSlider>()) {
            EXPECT_FALSE(input->accessibleName().isEmpty()) << qPrintable(input->objectName());
            EXPECT_FALSE(input->toolTip().isEmpty()) << qPrintable(input->accessibleName());
        }
        for (const QAbstractButton* input : reachable<QAbstractButton>()) {
            if (qobject_cast<const QTableView*>(input->parent()) != nullptr ||
                qobject_cast<const QTabBar*>(input->parent()) != nullptr) {
                continue;  // Qt's own
            }
            EXPECT_FALSE(input->text().isEmpty() && input->accessibleName().isEmpty() &&
                         input->toolTip().isEmpty())
                << qPrintable(input->objectName());
        }
    });
    for (const QTableView* input : page->findChildren<QTableView*>()) {
        EXPECT_FALSE(input->accessibleName().isEmpty()) << qPrintable(input->objectName());
    }
}

TEST_P(EveryPage, EveryTextEntryHasALength) {
    for (const QLineEdit* entry : page->findChildren<QLineEdit*>()) {
        EXPECT_TRUE(entry->maxLength() <= 1000 || entry->isReadOnly())
            << qPrintable(entry->objectName());
    }
    for (const QPlainTextEdit* entry : page->findChildren<QPlainTextEdit*>()) {
        EXPECT_TRUE(entry->isReadOnly()) << qPrintable(entry->objectName());
    }
}

TEST_P(EveryPage, ExplainsEveryResult) {
    onEveryTab([&] {
        for (const ResultTable* table : reachable<ResultTable>()) {
            for (int row = 0; row < table->rowCount(); ++row) {
                for (int column = 0; column < table->columnCount(); ++column) {
                    const QTableWidgetItem* cell = table->item(row, column);
                    if (cell != nullptr && !cell->text().isEmpty()) {
                        EXPECT_FALSE(cell->toolTip().isEmpty())
                            << table->accessibleName().toStdString() << ": "
                            << table->item(row, 0)->text().toStdString() << " / "
                            << table->horizontalHeaderItem(column)->text().toStdString();
                    }
                }
            }
        }
    });
}

TEST_P(EveryPage, SaysWhatItsPlotsAndPicturesShow) {
    onEveryTab([&] {
        for (const PlotView* plot : reachable<PlotView>()) {
            EXPECT_FALSE(plot->accessibleName().isEmpty());
            EXPECT_FALSE(plot->sentence().isEmpty()) << plot->title().toStdString();
        }
        for (const QWidget* picture : reachable<QWidget>()) {
            if (isFigure(picture)) {
                EXPECT_FALSE(picture->accessibleName().isEmpty())
                    << picture->metaObject()->className();
                // What a screen reader gets: else the tip is the description.
                EXPECT_FALSE(picture->accessibleDescription().isEmpty() &&
                             picture->toolTip().isEmpty())
                    << picture->accessibleName().toStdString();
            }
        }
    });
}

TEST_P(EveryPage, ItsTabsKeepTheirLettersWhicheverIsInFront) {
    QMap<const QTabBar*, QStringList> letters;
    onEveryTab([&] {
        for (const QTabBar* bar : reachable<QTabBar>()) {
            bool isInTab = false;
            for (const QWidget* each = bar->parentWidget()->parentWidget(); each != nullptr;
                 each = each->parentWidget()) {
                isInTab = isInTab || qobject_cast<const QTabWidget*>(each) != nullptr;
            }
            QStringList texts;
            for (int i = 0; i < bar->count() && !isInTab; ++i) {
                texts << bar->tabText(i);
            }
            if (!isInTab && !letters.contains(bar)) {
                letters[bar] = texts;
            }
            EXPECT_EQ(letters.value(bar), texts);
        }
    });
}

/// What turns on a page is one crank: its picture, the picture's slider and the plots over φ.
TEST_P(EveryPage, ItsPictureAndPlotsTurnOneCrank) {
    auto* panel = page->findChild<PicturePanel*>();
    auto* picture = page->findChild<MechanismPicture*>();
    if (panel == nullptr) {
        GTEST_SKIP() << "nothing turns";
    }
    ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
    CrankAngle& crank = *picture->crank();
    const auto turns = [&](const auto& act) {
        const double before = crank.degrees();
        act();
        EXPECT_NE(crank.degrees(), before);
        EXPECT_NEAR(panel->slider()->value(), crank.degrees(), 0.51);
    };
    picture->setFocus();
    turns([&] { QTest::keyClick(picture, Qt::Key_Right); });
    turns([&] {
        QTest::keyClick(picture, Qt::Key_Space);
        EXPECT_TRUE(picture->isPlaying());
        EXPECT_TRUE(test::comes([&, from = crank.degrees()] { return crank.degrees() != from; }));
    });
    QTest::keyClick(picture, Qt::Key_Space);
    EXPECT_FALSE(picture->isPlaying());
    panel->action()->trigger();
    EXPECT_TRUE(picture->isPlaying());
    page->setActive(false);
    EXPECT_FALSE(picture->isPlaying());
    int plots = 0;
    onEveryTab([&] {
        for (PlotView* plot : reachable<PlotView>()) {
            const QPointF at = plot->plotArea().center();
            crank.turnTo(10.0);
            test::movePointer(plot, at);
            plots += std::abs(crank.degrees() - plot->xAt(at.x())) < 2.0 ? 1 : 0;
        }
    });
    EXPECT_GT(plots, 0);
}

/// Counts what is asked to be laid out again.
class LayoutRequests final : public QObject {
  public:
    LayoutRequests() { qApp->installEventFilter(this); }
    int count = 0;

  protected:
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        count += event->type() == QEvent::LayoutRequest ? 1 : 0;
        return false;
    }
};

/// A layout that asks for itself again keeps a core busy as long as the window is open.
TEST_P(EveryPage, RestsWhenNothingHappens) {
    onEveryTab([&] {
        ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
        constexpr int rounds = 20;
        for (int i = 0; i < rounds; ++i) {
            QApplication::processEvents();
        }
        LayoutRequests asked;
        for (int i = 0; i < rounds; ++i) {
            QApplication::processEvents();
        }
        EXPECT_EQ(asked.count, 0);
    });
}

TEST_P(EveryPage, HasNoMnemonicTwiceInOneTab) {
    onEveryTab([&] {
        QMap<QChar, QList<std::pair<const QWidget*, QString>>> uses;
        const auto take = [&](const QWidget* of, const QString& text) {
            const QChar letter = mnemonicOf(text);
            const QWidget* tab = of;
            while (tab != page.get() &&
                   qobject_cast<const QStackedWidget*>(tab->parentWidget()) == nullptr) {
                tab = tab->parentWidget();
            }
            for (const auto& [other, before] : letter.isNull() ? uses[{}] : uses[letter]) {
                EXPECT_FALSE(other == tab || other->isAncestorOf(tab) || tab->isAncestorOf(other))
                    << qPrintable(before + u" | "_s + text);
            }
            if (!letter.isNull()) {
                uses[letter].emplaceBack(tab, text);
            }
        };
        for (const QLabel* label : reachable<QLabel>()) {
            if (label->buddy() != nullptr) {
                take(label, label->text());
            }
        }
        for (const QAbstractButton* button : reachable<QAbstractButton>()) {
            take(button, button->text());
        }
        for (const QTabBar* bar : reachable<QTabBar>()) {
            for (int i = 0; i < bar->count(); ++i) {
                take(bar, bar->tabText(i));
            }
        }
    });
}

TEST_P(EveryPage, MakesOneStepOfAnEditing) {
    int changed = 0;
    forEachField([&](NumberField& field) {
        SCOPED_TRACE(field.objectName().toStdString());
        const Json before = model().inputJson();
        const int steps = model().history()->index();
        const QString text = near(field);
        type(field, text);
        QTest::keyClick(&field, Qt::Key_Return);
        const Json after = model().inputJson();
        if (!field.trouble().isEmpty() || after == before) {
            EXPECT_EQ(after, before);
            EXPECT_EQ(model().history()->index(), steps);
            QTest::keyClick(&field, Qt::Key_Escape);
            return;
        }
        EXPECT_EQ(model().history()->index(), steps + 1);
        EXPECT_FALSE(model().history()->undoText().isEmpty());
        model().history()->undo();
        EXPECT_EQ(model().inputJson(), before);
        model().history()->redo();
        EXPECT_EQ(model().inputJson(), after);
        model().history()->undo();
        ++changed;
    });
    if (model().hasCaseFile()) {
        EXPECT_GE(changed, enough());
    }
}

TEST_P(EveryCase, AnEscapeLeavesNoStepBehind) {
    const Json before = model().inputJson();
    const int index = model().history()->index();
    const int count = model().history()->count();
    const auto escape = [&](EntryField& field, const QString& typed) {
        const QString text = field.text();
        type(field, typed);
        QTest::keyClick(&field, Qt::Key_Escape);
        EXPECT_EQ(field.text(), text);
        EXPECT_EQ(field.trouble(), QString());
        // Nothing is left to the loss of the focus either.
        page->setFocus();
        EXPECT_EQ(model().inputJson(), before);
        EXPECT_EQ(model().history()->index(), index);
        EXPECT_EQ(model().history()->count(), count);
    };
    QSet<EntryField*> seen;
    onEveryTab([&] {
        for (EntryField* field : reachable<EntryField>()) {
            if (!seen.contains(field) && !field->isReadOnly() && field->isVisible()) {
                seen << field;
                SCOPED_TRACE(field->objectName().toStdString());
                const auto* number = qobject_cast<NumberField*>(field);
                escape(*field, number != nullptr ? near(*number) : u"1"_s);
                escape(*field, number != nullptr ? near(*number) + u'x' : u"1x"_s);
            }
        }
    });
    EXPECT_GE(seen.size(), enough());
}

TEST_P(EveryCase, WhatWasTypedIsUndoneByKeys) {
    forEachField([&](NumberField& field) {
        SCOPED_TRACE(field.objectName().toStdString());
        const Json before = model().inputJson();
        const QString text = field.text();
        type(field, near(field));
        // The text's own: nothing has been made of it.
        for (int i = 0; i < 30 && field.text() != text; ++i) {
            QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
        }
        EXPECT_EQ(field.text(), text);
        EXPECT_EQ(model().inputJson(), before);
        QTest::keyClick(&field, Qt::Key_Escape);
        EXPECT_EQ(model().inputJson(), before);
    });
    EXPECT_EQ(model().history()->count(), 0);
}

TEST_P(EveryPage, ARejectedTextIsKeptAndSaidWhyAndIsNoNumber) {
    int rejected = 0;
    forEachField([&](NumberField& field) {
        const Json before = model().inputJson();
        const int steps = model().history()->index();
        const double value = field.value().value_or(1.0);
        const QString times10 = QString::number(value * 10.0, 'g', 10);
        for (const QString& text :
             {near(field) + u"x"_s, u"nan"_s, u"1e999"_s, u"-1e30"_s, u"0"_s, times10}) {
            SCOPED_TRACE((field.objectName() + u": "_s + text).toStdString());
            const QString shown = field.text();
            type(field, text);
            QTest::keyClick(&field, Qt::Key_Return);
            if (field.trouble().isEmpty()) {
                // Taken: then it is this number and no other.
                ASSERT_TRUE(field.value().has_value());
                const double typed = text.toDouble();
                EXPECT_NEAR(*field.value(), typed, 1e-9 * std::abs(typed));
                while (model().history()->index() > steps) {
                    model().undo();
                }
                EXPECT_EQ(model().inputJson(), before);
                continue;
            }
            ++rejected;
            const QString why = field.trouble();
            const auto keeps = [&] {
                EXPECT_EQ(field.text(), text);
                EXPECT_TRUE(says(field.trouble())) << qPrintable(field.trouble());
                EXPECT_FALSE(field.trouble().contains(u"/input"_s)) << qPrintable(field.trouble());
                EXPECT_EQ(model().inputJson(), before);
                EXPECT_EQ(model().history()->index(), steps);
            };
            keeps();
            page->setFocus();
            keeps();
            field.setFocus();
            QTest::keyClick(&field, Qt::Key_Escape);
            EXPECT_EQ(field.text(), shown);
            EXPECT_FALSE(says(why)) << qPrintable(why);
        }
    });
    EXPECT_GT(rejected, 0);
}

TEST_P(EveryPage, WheelChangesNothingWhereNobodyWent) {
    onEveryTab([&] {
        const Json before = model().inputJson();
        const auto turn = [&](QWidget* input) {
            page->setFocus();
            test::turnWheel(input, input->rect().center(), -1);
            input->setFocus();  // as if its page had just come to the front
            test::turnWheel(input, input->rect().center(), -1);
            EXPECT_EQ(model().inputJson(), before) << qPrintable(input->objectName());
        };
        for (QComboBox* input : reachable<QComboBox>()) {
            const int index = input->currentIndex();
            // A real turn of the wheel would give it the focus first.
            EXPECT_NE(input->focusPolicy(), Qt::WheelFocus) << qPrintable(input->objectName());
            turn(input);
            input->setFocus(Qt::TabFocusReason);  // a list stays what it is also where one went
            test::turnWheel(input, input->rect().center(), -1);
            EXPECT_EQ(input->currentIndex(), index) << qPrintable(input->objectName());
            EXPECT_EQ(model().inputJson(), before) << qPrintable(input->objectName());
        }
        for (QSlider* input : reachable<QSlider>()) {
            const int value = input->value();
            turn(input);
            EXPECT_EQ(input->value(), value) << qPrintable(input->objectName());
        }
        for (NumberField* input : reachable<NumberField>()) {
            turn(input);
        }
    });
}

TEST_P(EveryPage, ResetsTheZoomOfEveryPlot) {
    test::openExample(model());  // a new sheet may show no plot
    showDetails();
    QApplication::processEvents();
    const auto plots = page->findChildren<PlotView*>();
    EXPECT_FALSE(plots.isEmpty());
    bool zoomed = false;
    for (PlotView* plot : plots) {
        showTabOf(plot);
        plot->grab();  // it may be below the fold
        test::turnWheel(plot, plot->plotArea().center().toPoint(), 2, Qt::ControlModifier);
        zoomed = zoomed || plot->isZoomed();
    }
    EXPECT_TRUE(zoomed);
    page->resetZoom();
    for (PlotView* plot : plots) {
        EXPECT_FALSE(plot->isZoomed()) << qPrintable(plot->title());
    }
}

TEST_P(EveryPage, GoesAsAWindowWithAFieldHalfTyped) {
    for (QLineEdit* field : reachable<QLineEdit>()) {
        if (!field->isReadOnly()) {
            test::typeOver(field, u"4"_s);
            break;
        }
    }
    page.reset();
    QApplication::processEvents();
}

TEST_P(EveryCase, ComesBackFromItsFile) {
    const QTemporaryDir folder;
    const auto throughFile = [&](const QString& name) {
        const Json input = model().inputJson();
        if (const Json result = model().resultJson(); !result.contains("error")) {
            // What the command line prints.
            EXPECT_EQ(solve_case(model().caseFile(), model().context()).at("result"), result);
        }
        const std::unique_ptr<ScenePage> other = make();
        other->model()->loadInput(input, model().context());
        EXPECT_EQ(other->model()->inputJson(), input) << qPrintable(name);

        CaseDocument document(&model());
        model().setTitle(u"Ж \"1\""_s);
        const QString path = folder.filePath(name);
        ASSERT_EQ(document.saveTo(path), QString());
        CaseDocument second(other->model());
        second.open(CaseDocument::read(path), path);
        EXPECT_EQ(other->model()->inputJson(), input) << qPrintable(name);
        EXPECT_EQ(other->model()->resultJson(), model().resultJson()) << qPrintable(name);
        EXPECT_EQ(other->model()->title(), model().title());
        EXPECT_FALSE(second.needsSaving());
    };
    throughFile(u"begun.case.json"_s);
    const QDir examples(QString::fromUtf8(RAVNOVES_EXAMPLES));
    int opened = 0;
    for (const QString& name : examples.entryList({u"*.case.json"_s})) {
        const QString path = examples.filePath(name);
        const CaseFile file = CaseDocument::read(path);
        if (file.scene == GetParam()) {
            CaseDocument(&model()).open(file, path);
            throughFile(name);
            ++opened;
        }
    }
    EXPECT_GT(opened, 0);
}

TEST_P(EveryPage, TakesInATableWhatItCopiedAndRejectsOtherText) {
    for (TableEditor* table : page->findChildren<TableEditor*>()) {
        if (table->view()->model()->rowCount() == 0) {
            continue;
        }
        const Json before = model().inputJson();
        const int steps = model().history()->index();
        table->view()->clearSelection();
        table->copy();
        const QString cells = QApplication::clipboard()->text();
        EXPECT_FALSE(cells.trimmed().isEmpty());
        table->view()->setCurrentIndex(table->view()->model()->index(0, 0));
        table->paste();
        table->view()->clearSelection();
        table->copy();
        EXPECT_EQ(QApplication::clipboard()->text(), cells);
        model().history()->setIndex(steps);
        EXPECT_EQ(model().inputJson(), before);
        QStringList texts{QString(), u"1x\t2y\n3z\t4w\n"_s};
        if (qobject_cast<TorqueTableEditor*>(table) == nullptr) {  // there what is right counts
            texts << u"1x\t2y\n3z\t4\n"_s;
        }
        for (const QString& text : texts) {
            QApplication::clipboard()->setText(text);
            table->paste();
            EXPECT_EQ(model().inputJson(), before) << qPrintable(text);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryCase, ::testing::ValuesIn(test::sceneNamesWithCases()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);
INSTANTIATE_TEST_SUITE_P(Scenes, EveryPage, ::testing::ValuesIn(test::sceneNames()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

}  // namespace
}  // namespace ravnoves
