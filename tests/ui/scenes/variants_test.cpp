// A page against a variant of its input, whatever its scene.

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <memory>
#include <string>
#include <vector>

#include "balance-shaft/presets.h"
#include "balance-shaft/torque_table.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "events.h"
#include "inertia-moments/inertia_moments_page.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "model/case_document.h"
#include "model/input_differences.h"
#include "model/reference_case.h"
#include "model/variant_files.h"
#include "page/compared_figure.h"
#include "page/mechanism_picture.h"
#include "page/scene_page.h"
#include "plot/plot_view.h"
#include "scene_tests.h"
#include "scenes/open_example.h"
#include "shell/comparison.h"
#include "shell/input_comparison.h"
#include "shell/scene_list.h"
#include "shell/variant_table.h"
#include "shown_number.h"
#include "text/file_path.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class EveryPagesVariants : public ::testing::TestWithParam<std::string> {
  protected:
    EveryPagesVariants() {
        test::showAt(*page, {1280, 800});
        page->activateWindow();
        if (model().resultJson().contains("error")) {
            test::openExample(model());  // a new sheet is half filled
        }
    }

    static std::unique_ptr<ScenePage> make() { return test::makePage(GetParam()); }
    SceneModel& model() { return *page->model(); }
    /// What the page's case is seen against; null: nothing.
    static const SceneModel* referenceOf(const ScenePage& page) {
        if (const auto* comparison = page.findChild<Comparison*>()) {
            return comparison->twin() != nullptr ? comparison->twin()->model() : nullptr;
        }
        return page.findChild<ReferenceCase*>()->model();
    }
    const SceneModel* reference() { return referenceOf(*page); }
    QString trouble() {
        const auto* comparison = page->findChild<Comparison*>();
        return comparison != nullptr ? comparison->trouble() : model().referenceCase().trouble();
    }

    /// Types other numbers into fields of every tab, four at most on each.
    void changeByKeys() {
        const Json before = model().resultJson();
        changeWhatIsSeen();
        for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                changeWhatIsSeen();
            }
        }
        EXPECT_NE(model().resultJson(), before);
    }
    void changeWhatIsSeen() {
        int changed = 0;
        for (NumberField* field : page->findChildren<NumberField*>()) {
            // Those of sliders may be of the picture alone, as the scale of a relief.
            if (changed == 4 || !field->isVisible() || field->isReadOnly() || !field->isEnabled() ||
                !field->value() || qobject_cast<ValueSlider*>(field->parentWidget()) != nullptr) {
                continue;
            }
            field->setFocus();
            QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(field, QString::number(*field->value() * 1.02, 'g', 8));
            QTest::keyClick(field, Qt::Key_Return);
            changed += field->trouble().isEmpty() ? 1 : 0;
            QTest::keyClick(field, Qt::Key_Escape);
        }
    }
    /// Brings each tab to the front once, and lets what is computed in the background end.
    static void lookAtAll(ScenePage& shown) {
        for (QTabWidget* tabs : shown.findChildren<QTabWidget*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                QApplication::processEvents();
            }
        }
        EXPECT_TRUE(QTest::qWaitFor([&] { return !shown.isBusy(); }, 60'000));
        QApplication::processEvents();
    }
    template <typename Part>
    static std::vector<Part*> parts(const ScenePage& of) {
        const QList<Part*> found = of.findChildren<Part*>();
        std::vector<Part*> all(found.begin(), found.end());
        std::sort(all.begin(), all.end(),
                  [](const Part* a, const Part* b) { return a->number() < b->number(); });
        return all;
    }

    std::unique_ptr<ScenePage> page = make();
};

TEST_P(EveryPagesVariants, GhostsAreTheCurvesThatTheReferenceHad) {
    lookAtAll(*page);
    const auto plots = parts<PlotView>(*page);
    std::vector<std::vector<PlotCurve>> kept;
    for (const PlotView* plot : plots) {
        kept.push_back(plot->data().curves);
    }
    EXPECT_EQ(reference(), nullptr);  // nothing is there without a reference
    model().keepVariant();
    ASSERT_NE(reference(), nullptr);
    changeByKeys();
    lookAtAll(*page);

    int ghosts = 0;
    int moved = 0;
    for (std::size_t p = 0; p < plots.size(); ++p) {
        SCOPED_TRACE(plots[p]->title().toStdString());
        const PlotData& data = plots[p]->data();
        const auto isDrawn = [](const PlotCurve& curve) { return !curve.x.empty(); };
        const bool hasCurves = std::any_of(kept[p].begin(), kept[p].end(), isDrawn) &&
                               std::any_of(data.curves.begin(), data.curves.end(), isDrawn);
        const int before = ghosts;
        for (std::size_t c = 0; c < data.curves.size(); ++c) {
            const PlotCurve* ghost = data.ghostOf(data.curves[c]);
            if (ghost == nullptr) {
                continue;
            }
            ++ghosts;
            ASSERT_LT(c, kept[p].size());
            EXPECT_EQ(ghost->x, kept[p][c].x) << c;
            EXPECT_EQ(ghost->y, kept[p][c].y) << c;
            moved += ghost->y != data.curves[c].y ? 1 : 0;
        }
        EXPECT_TRUE(ghosts > before || !hasCurves);
    }
    EXPECT_GT(ghosts, 0);
    EXPECT_GT(moved, 0);
    const auto pictures = page->findChildren<MechanismPicture*>();
    std::vector<QImage> compared;
    for (MechanismPicture* picture : pictures) {
        compared.push_back(picture->grab().toImage());
    }
    model().chooseReference(-1);
    EXPECT_EQ(reference(), nullptr);
    lookAtAll(*page);
    for (const PlotView* plot : plots) {
        EXPECT_EQ(plot->data().reference, nullptr);
    }
    for (std::size_t i = 0; i < compared.size(); ++i) {
        EXPECT_NE(pictures[static_cast<qsizetype>(i)]->grab().toImage(), compared[i]);
    }
}

TEST_P(EveryPagesVariants, DifferencesAreThePresentLessTheReference) {
    lookAtAll(*page);
    const auto tables = parts<ResultTable>(*page);
    struct Cell {
        QString name;
        QString text;
    };
    std::vector<std::vector<std::vector<Cell>>> kept;
    std::vector<int> columns;
    for (const ResultTable* table : tables) {
        columns.push_back(table->columnCount());
        kept.emplace_back();
        for (int row = 0; row < table->rowCount(); ++row) {
            kept.back().emplace_back();
            for (int column = 0; column < table->columnCount(); ++column) {
                kept.back().back().push_back(
                    {table->item(row, 0)->text(), table->item(row, column)->text()});
            }
        }
    }
    model().keepVariant();
    changeByKeys();
    lookAtAll(*page);
    int compared = 0;
    int other = 0;
    for (std::size_t t = 0; t < tables.size(); ++t) {
        SCOPED_TRACE(tables[t]->accessibleName().toStdString());
        const ResultTable& table = *tables[t];
        const int comparedBefore = compared;
        int numbers = 0;
        for (int row = 0; row < table.rowCount() && row < static_cast<int>(kept[t].size()); ++row) {
            for (int column = 1; column < columns[t]; ++column) {
                const QStringList found = table.differenceAt(row, column);
                const auto& was = kept[t][static_cast<std::size_t>(row)];
                const Cell& cell = was[static_cast<std::size_t>(column)];
                numbers +=
                    cell.name == table.item(row, 0)->text() &&
                            test::readShownNumber(cell.text).has_value() &&
                            test::readShownNumber(table.item(row, column)->text()).has_value()
                        ? 1
                        : 0;
                if (found.isEmpty() || cell.name != table.item(row, 0)->text()) {
                    continue;
                }
                ++compared;
                const auto now = test::readShownNumber(table.item(row, column)->text());
                const auto before = test::readShownNumber(cell.text);
                if (!now || !before) {  // "178 × 305", "1.2·10⁻⁵"
                    EXPECT_TRUE(found[0].contains(QRegularExpression(u"\\d"_s)));
                    continue;
                }
                const auto difference = test::readShownNumber(found[0]);
                ASSERT_TRUE(difference) << cell.text.toStdString();
                const bool isAngle = table.horizontalHeaderItem(column)->text().endsWith(u'°') ||
                                     now->unit == u"°"_s;
                const double wanted = now->value - before->value;
                // Both are as shown, with as many digits as the greater has.
                const double greater = std::max(std::abs(now->value), std::abs(before->value));
                EXPECT_NEAR(
                    isAngle ? std::remainder(difference->value - wanted, 360.0)
                            : difference->value - wanted,
                    0.0, now->isPlain && before->isPlain ? 1e-9 * greater + 1e-9 : 0.01 * greater)
                    << table.item(row, column)->text().toStdString() << " after "
                    << cell.text.toStdString() << ": " << found[0].toStdString();

                other += wanted != 0.0 ? 1 : 0;
            }
        }
        EXPECT_TRUE(compared > comparedBefore || numbers == 0);
        // The whole table is copied with them.
        if (table.reference() != nullptr && table.rowCount() > 0) {
            const QStringList lines = table.asText().split(u'\n');
            EXPECT_EQ(lines[0].count(u'\t'), lines[1].count(u'\t'));
        }
    }
    EXPECT_GT(compared, 0);
    EXPECT_GT(other, 0);
    model().chooseReference(-1);
    for (std::size_t t = 0; t < tables.size(); ++t) {
        EXPECT_EQ(tables[t]->columnCount(), columns[t]);
    }
}

TEST_P(EveryPagesVariants, SwappedTwiceAllIsAsItWas) {
    model().keepVariant();
    changeByKeys();
    const Json input = model().inputJson();
    const Json result = model().resultJson();
    const Json reference = model().variantInput(0);
    EXPECT_FALSE(inputDifferences(model(), reference).empty());
    ASSERT_EQ(model().swapVariant(0), QString());
    EXPECT_EQ(model().inputJson(), reference);
    EXPECT_EQ(model().variantInput(0), input);
    EXPECT_EQ(this->reference()->inputJson(), input);
    EXPECT_EQ(this->reference()->resultJson(), result);
    ASSERT_EQ(model().swapVariant(0), QString());
    EXPECT_EQ(model().inputJson(), input);
    EXPECT_EQ(model().resultJson(), result);
    EXPECT_EQ(model().variantInput(0), reference);
}

TEST_P(EveryPagesVariants, TheInputsThatDifferAreNamedAsInTheForm) {
    model().keepVariant();
    changeByKeys();
    const InputComparison dialog(page.get(), nullptr);
    const auto differences = inputDifferences(model(), model().variantInput(0));
    ASSERT_EQ(dialog.table()->rowCount(), static_cast<int>(differences.size()));
    for (int row = 0; row < dialog.table()->rowCount(); ++row) {
        const QString name = dialog.table()->item(row, 0)->text();
        EXPECT_FALSE(name.isEmpty() || name.startsWith(u'/') || name.contains(u'_'))
            << name.toStdString();
    }
    EXPECT_TRUE(dialog.table()->asText().contains(dialog.table()->item(0, 0)->text()));
    model().takeVariant(0);
    EXPECT_EQ(dialog.table()->rowCount(), 0);
}

TEST_P(EveryPagesVariants, StandSideBySideWithThePresent) {
    model().keepVariant(u"first"_s);
    changeByKeys();
    model().keepVariant(u"second"_s);
    const VariantTable dialog(page.get(), nullptr);
    const ResultTable& table = *dialog.table();
    ASSERT_EQ(table.columnCount(), 4);
    EXPECT_EQ(table.horizontalHeaderItem(2)->text(), u"first"_s);
    ASSERT_GT(table.rowCount(), 0);
    for (int row = 0; row < table.rowCount(); ++row) {
        EXPECT_EQ(table.item(row, 1)->text(), table.item(row, 3)->text());
    }
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"variants.csv"_s);
    EXPECT_EQ(dialog.exportTo(path), QString());
    EXPECT_EQ(read_text_file(fsPath(path)), table.asCsv().toStdString());
}

TEST(VariantsSideBySide, GiveTheirMomentsAUnit) {
    const auto page = test::makePage("balance-shaft");
    const VariantTable dialog(page.get(), nullptr);
    const QString text = dialog.table()->asText();
    EXPECT_TRUE(text.contains(u"\nrange · Mᵤₚₛ, N·m\t"_s)) << qPrintable(text);
    EXPECT_TRUE(text.contains(u"\nmin · Mₛ, N·m\t"_s));
    EXPECT_TRUE(text.contains(u"\nrange · change\t"_s));
}

TEST(AVariantOfAFile, SaysEverywhereThatTheFileHasChanged) {
    const QTemporaryDir folder;
    const auto page = test::makePage("balance-shaft");
    SceneModel& model = *page->model();
    balance_shaft::TorqueTable table = balance_shaft::preset_tmz_650d().torque.table;
    const auto write = [&] {
        write_text_file(fsPath(folder.filePath(u"ind.csv"_s)),
                        balance_shaft::write_torque_table(table));
    };
    write();
    Json input = model.inputJson();
    input["torque"] = {{"csv", "ind.csv"}};
    model.loadCase(input, CaseContext{fsPath(folder.path())}, u"x"_s);
    model.keepVariant(u"C"_s);
    EXPECT_EQ(changedFilesText(model, 0), QString());
    table.torque[5] += 1.0;
    write();
    const QString wanted = u"ind.csv has changed since this variant was kept"_s;
    QSignalSpy said(page.get(), &ScenePage::status);
    model.chooseReference(-1);
    model.chooseReference(0);
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.last().at(0).toString().contains(wanted));
    const VariantTable dialog(page.get(), nullptr);
    const auto labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* each) {
        return each->text().startsWith(u"C: "_s + wanted);
    }));
}

TEST(InputsAgainstTheReference, ScrollWhereTheyAreMany) {
    InertiaMomentsPage page;
    page.viewModel()->chooseLayout(u"vr6"_s);
    page.viewModel()->makeTable();
    page.model()->keepVariant();
    page.viewModel()->chooseLayout(u"v2-45"_s);
    const InputComparison dialog(&page, nullptr);
    ASSERT_GT(dialog.table()->rowCount(), 20);
    EXPECT_LT(dialog.minimumSizeHint().height(), 420);
}

TEST_P(EveryPagesVariants, ComeBackFromTheFile) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"variants.case.json"_s);
    model().keepVariant(u"тяжёлый"_s);
    changeByKeys();
    model().keepVariant();
    ASSERT_EQ(CaseDocument(&model(), {}).saveTo(path), QString());
    const std::unique_ptr<ScenePage> other = make();
    CaseDocument document(other->model(), {});
    document.open(CaseDocument::read(path), path);
    EXPECT_EQ(other->model()->variants(), model().variants());
    for (int place = 0; place < 2; ++place) {
        EXPECT_EQ(other->model()->variantTrouble(place), QString());
    }
    other->model()->chooseReference(0);
    ASSERT_NE(referenceOf(*other), nullptr);
    EXPECT_EQ(referenceOf(*other)->inputJson(), model().variantInput(0));
}

TEST_P(EveryPagesVariants, AReferenceThatIsRefusedSaysWhy) {
    model().keepVariant();
    CaseFile file{GetParam(), "", model().inputJson()};
    Json bad = model().inputJson();
    bad["no_such_key"] = 1;
    file.variants.push_back({"bad", bad});
    CaseDocument(&model(), {}).open(file, u"/tmp/x.case.json"_s);
    ASSERT_EQ(model().variants().size(), 1);
    model().chooseReference(0);
    EXPECT_EQ(reference(), nullptr);
    EXPECT_FALSE(trouble().isEmpty());
    model().chooseReference(-1);
    EXPECT_TRUE(trouble().isEmpty());
}

TEST_P(EveryPagesVariants, APageThatGoesLeavesNothingBehind) {
    model().keepVariant();
    changeByKeys();
    page.reset();
    QApplication::processEvents();
}

/// What only the crank's side view, only the guide shows.
struct Detail {
    const char* scene;
    const char* key;
    const char* value;
};

class PictureOfAReference : public ::testing::TestWithParam<Detail> {};

TEST_P(PictureOfAReference, ShowsTheDetailThatDiffers) {
    const Detail detail = GetParam();
    const std::unique_ptr<ScenePage> page = test::makePage(detail.scene);
    test::showAt(*page, {1280, 800});
    SceneModel& model = *page->model();
    auto* picture = page->findChild<MechanismPicture*>();
    ASSERT_NE(picture, nullptr);
    model.keepVariant();
    model.setByKey(QString::fromLatin1(detail.key), QString::fromLatin1(detail.value));
    const QImage againstOther = picture->grab().toImage();
    model.keepVariant();  // the reference is now what is shown
    EXPECT_NE(picture->grab().toImage(), againstOther);
}

INSTANTIATE_TEST_SUITE_P(Pages, PictureOfAReference,
                         ::testing::Values(Detail{"inertia-moments", "reference_position_mm", "60"},
                                           Detail{"elastic-hinge", "spring/stiffness_N_m", "1e7"}),
                         [](const auto& each) { return test::testName(each.param.scene); });

INSTANTIATE_TEST_SUITE_P(Scenes, EveryPagesVariants,
                         ::testing::ValuesIn(test::sceneNamesWithCases()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

}  // namespace
}  // namespace ravnoves
