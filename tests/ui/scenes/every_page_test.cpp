// What holds for every page, whatever its scene.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QSet>
#include <QSlider>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "events.h"
#include "model/case_document.h"
#include "plot/plot_view.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/table_editor.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class EveryPage : public ::testing::TestWithParam<std::string> {
  protected:
    EveryPage() {
        test::showAt(*page, {1280, 800});
        page->activateWindow();
    }

    static std::unique_ptr<ScenePage> make() {
        for (const SceneInfo& info : sceneList()) {
            if (info.name.toStdString() == GetParam()) {
                return std::unique_ptr<ScenePage>(info.make(nullptr));
            }
        }
        return nullptr;
    }
    SceneModel& model() { return *page->model(); }

    /// Calls `look` with each tab of the page in front in turn.
    void onEveryTab(const std::function<void()>& look) {
        look();
        for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                QApplication::processEvents();
                look();
            }
        }
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
    static void type(NumberField& field, const QString& text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
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

TEST_P(EveryPage, NamesAndExplainsEveryInput) {
    const auto check = [](const QWidget& input) {
        EXPECT_FALSE(input.accessibleName().isEmpty()) << qPrintable(input.objectName());
    };
    for (const EntryField* input : page->findChildren<EntryField*>()) {
        check(*input);
    }
    for (const NumberField* input : page->findChildren<NumberField*>()) {
        EXPECT_TRUE(input->toolTip().contains(u"must be")) << qPrintable(input->objectName());
    }
    for (const QAbstractSpinBox* input : page->findChildren<QAbstractSpinBox*>()) {
        check(*input);
    }
    for (const QComboBox* input : page->findChildren<QComboBox*>()) {
        check(*input);
    }
    for (const QSlider* input : page->findChildren<QSlider*>()) {
        check(*input);
    }
    for (const QTableView* input : page->findChildren<QTableView*>()) {
        EXPECT_FALSE(input->accessibleName().isEmpty()) << qPrintable(input->objectName());
    }
    for (const QAbstractButton* input : reachable<QAbstractButton>()) {
        EXPECT_FALSE(input->text().isEmpty() && input->accessibleName().isEmpty() &&
                     input->toolTip().isEmpty())
            << qPrintable(input->objectName());
    }
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
        EXPECT_GT(changed, 5);
    }
}

TEST_P(EveryPage, WheelChangesNothingWithoutTheFocus) {
    onEveryTab([&] {
        const Json before = model().inputJson();
        const auto turn = [&](QWidget* input) {
            page->setFocus();
            test::turnWheel(input, input->rect().center(), -1);
            test::turnWheel(input, input->rect().center(), -1);
            EXPECT_EQ(model().inputJson(), before) << qPrintable(input->objectName());
        };
        for (QComboBox* input : reachable<QComboBox>()) {
            const int index = input->currentIndex();
            turn(input);
            EXPECT_EQ(input->currentIndex(), index) << qPrintable(input->objectName());
        }
        for (QSlider* input : reachable<QSlider>()) {
            const int value = input->value();
            turn(input);
            EXPECT_EQ(input->value(), value) << qPrintable(input->objectName());
        }
        for (QAbstractSpinBox* input : reachable<QAbstractSpinBox>()) {
            const QString text = input->text();
            turn(input);
            EXPECT_EQ(input->text(), text) << qPrintable(input->objectName());
        }
        for (NumberField* input : reachable<NumberField>()) {
            turn(input);
        }
    });
}

TEST_P(EveryPage, ResetsTheZoomOfEveryPlot) {
    const auto plots = page->findChildren<PlotView*>();
    EXPECT_FALSE(plots.isEmpty());
    bool zoomed = false;
    for (PlotView* plot : plots) {
        test::turnWheel(plot, plot->plotArea().center().toPoint(), 2);
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
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, u"4"_s);
            break;
        }
    }
    page.reset();
    QApplication::processEvents();
}

TEST_P(EveryPage, ComesBackFromItsFile) {
    if (!model().hasCaseFile()) {
        GTEST_SKIP() << "has no case file";
    }
    const QTemporaryDir folder;
    const auto throughFile = [&](const QString& name) {
        const Json input = model().inputJson();
        const std::unique_ptr<ScenePage> other = make();
        other->model()->loadInput(input, model().context());
        EXPECT_EQ(other->model()->inputJson(), input) << qPrintable(name);

        CaseDocument document(&model(), {});
        model().setTitle(u"Ж \"1\""_s);
        const QString path = folder.filePath(name);
        ASSERT_EQ(document.saveTo(path), QString());
        CaseDocument second(other->model(), {});
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
            CaseDocument(&model(), {}).open(file, path);
            throughFile(name);
            ++opened;
        }
    }
    EXPECT_GT(opened, 0);
}

TEST_P(EveryPage, TakesInATableWhatItCopiedAndRefusesOtherText) {
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
        for (const QString& text : {u""_s, u"1x\t2y\n3z\t4\n"_s}) {
            QApplication::clipboard()->setText(text);
            table->paste();
            EXPECT_EQ(model().inputJson(), before) << qPrintable(text);
        }
    }
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const SceneInfo& info : sceneList()) {
        names.push_back(info.name.toStdString());
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryPage, ::testing::ValuesIn(sceneNames()),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace ravnoves
