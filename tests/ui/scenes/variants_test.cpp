// A page against a variant of its input, whatever its scene.

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <cmath>
#include <map>
#include <memory>
#include <set>
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
#include "page/part_views.h"
#include "page/scene_page.h"
#include "scene_tests.h"
#include "scenes/open_example.h"
#include "shell/variant_table.h"
#include "text/csv_format.h"
#include "text/file_path.h"
#include "widgets/number_field.h"
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
    const SceneModel* reference() { return model().referenceCase().model(); }

    /// Types other numbers into fields of every tab, four at most on each.
    void changeByKeys() {
        const Json before = model().resultJson();
        changeWhatIsSeen();
        test::onEveryTab(*page, [&] { changeWhatIsSeen(); });
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
        test::onEveryTab(shown, [] {});
        EXPECT_TRUE(test::comes([&] { return !shown.isBusy(); }));
        QApplication::processEvents();
    }
    /// What each part shows.
    std::map<std::string, Content> shown() {
        std::map<std::string, Content> all;
        for (const PagePart& part : model().parts()) {
            all.emplace(part.id, model().part(part.id));
        }
        return all;
    }
    /// What is drawn of a curve: where it has a place.
    static std::pair<std::vector<double>, std::vector<double>> drawn(const Figure::Curve& curve) {
        std::pair<std::vector<double>, std::vector<double>> points;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
                points.first.push_back(curve.x[i]);
                points.second.push_back(curve.y[i]);
            }
        }
        return points;
    }

    std::unique_ptr<ScenePage> page = make();
};

TEST_P(EveryPagesVariants, PartsHaveWordsOfTheirOwn) {
    std::set<std::string> words;
    for (const PagePart& part : model().parts()) {
        SCOPED_TRACE(part.id);
        EXPECT_TRUE(words.insert(std::string(part.id)).second);
        const Content content = model().part(part.id);
        EXPECT_FALSE(std::holds_alternative<std::monostate>(content));
        if (const auto* figure = std::get_if<Figure>(&content)) {
            std::set<std::string> curves;
            for (const Figure::Curve& curve : figure->curves) {
                EXPECT_FALSE(curve.id.empty());
                EXPECT_TRUE(curves.insert(curve.id).second) << curve.id;
            }
        }
    }
    EXPECT_FALSE(words.empty());
}

TEST_P(EveryPagesVariants, PartsOfTheReferenceAreWhatTheCaseShowedThen) {
    lookAtAll(*page);
    const auto kept = shown();
    EXPECT_EQ(reference(), nullptr);  // nothing is there without a reference
    model().keepVariant();
    ASSERT_NE(reference(), nullptr);
    changeByKeys();
    lookAtAll(*page);
    for (const auto& [id, before] : kept) {
        SCOPED_TRACE(id);
        const Content now = reference()->part(id);
        ASSERT_EQ(now.index(), before.index());
        if (const auto* figure = std::get_if<Figure>(&before)) {
            const auto& curves = std::get<Figure>(now).curves;
            ASSERT_EQ(curves.size(), figure->curves.size());
            for (std::size_t i = 0; i < curves.size(); ++i) {
                EXPECT_EQ(curves[i].id, figure->curves[i].id);
                EXPECT_EQ(drawn(curves[i]), drawn(figure->curves[i])) << curves[i].id;
            }
        } else if (const auto* results = std::get_if<Results>(&before)) {
            const ResultRows& rows = std::get<Results>(now).rows;
            ASSERT_EQ(rows.size(), results->rows.size());
            for (qsizetype i = 0; i < rows.size(); ++i) {
                EXPECT_EQ(rows[i].texts(), results->rows[i].texts());
            }
        } else if (const auto* notes = std::get_if<Notes>(&before)) {
            EXPECT_EQ(std::get<Notes>(now).lines, notes->lines);
        }
    }
}

TEST_P(EveryPagesVariants, GhostsAreTheCurvesOfTheSameWord) {
    model().keepVariant();
    changeByKeys();
    lookAtAll(*page);
    int ghosts = 0;
    int moved = 0;
    for (PartPlot* plot : page->findChildren<PartPlot*>()) {
        SCOPED_TRACE(plot->id());
        plot->make();
        const Figure figure = std::get<Figure>(reference()->part(plot->id()));
        const PlotData& data = plot->data();
        const int before = ghosts;
        bool isAnyDrawn = false;
        for (const PlotCurve& curve : data.curves) {
            const auto same = std::ranges::find(figure.curves, curve.id, &Figure::Curve::id);
            const bool areBothDrawn =
                same != figure.curves.end() && !drawn(*same).first.empty() && !curve.x.empty();
            isAnyDrawn = isAnyDrawn || areBothDrawn;
            if (const PlotCurve* ghost = data.ghostOf(curve)) {
                ASSERT_NE(same, figure.curves.end()) << curve.id;
                EXPECT_EQ(std::pair(ghost->x, ghost->y), drawn(*same)) << curve.id;
                moved += ghost->y != curve.y ? 1 : 0;
                ++ghosts;
            }
        }
        EXPECT_TRUE(ghosts > before || !isAnyDrawn);
    }
    EXPECT_GT(ghosts, 0);
    EXPECT_GT(moved, 0);
    model().chooseReference(-1);
    EXPECT_EQ(reference(), nullptr);
    lookAtAll(*page);
    for (PartView* view : PartView::below(*page, false)) {
        view->make();  // what is hidden follows when it is shown
    }
    for (const PlotView* plot : page->findChildren<PlotView*>()) {
        EXPECT_EQ(plot->data().reference, nullptr);
    }
}

TEST_P(EveryPagesVariants, DifferencesAreThePresentLessTheReferencesRowOfTheSameName) {
    model().keepVariant();
    changeByKeys();
    lookAtAll(*page);
    int compared = 0;
    for (PartTable* table : page->findChildren<PartTable*>()) {
        SCOPED_TRACE(table->id());
        table->make();
        const Results now = std::get<Results>(model().part(table->id()));
        const Results before = std::get<Results>(reference()->part(table->id()));
        ASSERT_EQ(table->rowCount(), now.rows.size());
        for (int row = 0; row < table->rowCount(); ++row) {
            const auto was = std::ranges::find(before.rows, now.rows[row].key(), &ResultRow::key);
            for (int column = 1; was != before.rows.end() && column < table->columnCount();
                 ++column) {
                const ResultCell is = now.rows[row].value(column);
                if (is.number() == nullptr || was->value(column).number() == nullptr) {
                    continue;
                }
                const auto wanted = is.from(was->value(column));
                EXPECT_EQ(table->differenceAt(row, column),
                          wanted ? (QStringList{wanted->absolute, wanted->percent}) : QStringList())
                    << is.text.toStdString() << " after " << was->value(column).text.toStdString();
                compared += wanted ? 1 : 0;
            }
        }
        // The whole table is copied with them.
        if (table->rowCount() > 0) {
            const QStringList lines = table->asText().split(u'\n');
            EXPECT_EQ(lines[0].count(u'\t'), lines[1].count(u'\t'));
        }
    }
    EXPECT_GT(compared, 0);
    const auto columns = [&] {
        std::vector<int> all;
        for (const PartTable* table : page->findChildren<PartTable*>()) {
            all.push_back(table->columnCount());
        }
        return all;
    };
    const std::vector<int> with = columns();
    model().chooseReference(-1);
    EXPECT_EQ(columns(), with);
}

TEST_P(EveryPagesVariants, TheInputsThatDifferAreNamedAsInTheForm) {
    model().keepVariant();
    changeByKeys();
    const VariantTable dialog(page.get(), nullptr);
    const auto differences = inputDifferences(model(), model().variantInput(0));
    ASSERT_GT(differences.size(), 0U);
    for (std::size_t i = 0; i < differences.size(); ++i) {
        const QString name = dialog.table()->item(static_cast<int>(i), 0)->text();
        EXPECT_TRUE(name.startsWith(differences[i].name)) << name.toStdString();
        EXPECT_FALSE(name.isEmpty() || name.startsWith(u'/') || name.contains(u'_'))
            << name.toStdString();
    }
    model().takeVariant(0);
    EXPECT_TRUE(inputDifferences(model(), model().variantInput(0)).empty());
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
    EXPECT_EQ(read_text_file(fsPath(path)), CsvFormat::file(table.asCsv()));
}

/// Whether a label of a window begins like this.
bool says(const QWidget& window, const QString& words) {
    return std::ranges::any_of(window.findChildren<QLabel*>(),
                               [&](const QLabel* each) { return each->text().startsWith(words); });
}

/// The row of a table whose name begins like this; −1: none.
int rowNamed(const ResultTable& table, const QString& name) {
    for (int row = 0; row < table.rowCount(); ++row) {
        if (table.item(row, 0)->text().startsWith(name)) {
            return row;
        }
    }
    return -1;
}

TEST(VariantsSideBySide, HaveTheRowsThatAnyOfThemHas) {
    const auto page = test::makePage("elastic-hinge");
    SceneModel& model = *page->model();
    ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
    model.setByKey(u"profile_error_um"_s, u"7"_s);
    model.keepVariant(u"seven"_s);
    model.setByKey(u"profile_error_um"_s, u"9"_s);
    const VariantTable dialog(page.get(), nullptr);
    const ResultTable& table = *dialog.table();
    const int seven = rowNamed(table, u"Moment error, 7"_s);
    const int nine = rowNamed(table, u"Moment error, 9"_s);
    ASSERT_GE(seven, 0) << table.asText().toStdString();
    ASSERT_GE(nine, 0);
    EXPECT_EQ(std::abs(nine - seven), 1) << "each where it stands on the page";
    EXPECT_EQ(table.item(seven, 1)->text(), u"–"_s);
    EXPECT_NE(table.item(seven, 2)->text(), u"–"_s);
    EXPECT_EQ(table.item(nine, 2)->text(), u"–"_s);
    // What a job computes none of them has.
    EXPECT_FALSE(table.asText().contains(u"Ripple"_s));
}

TEST(VariantsSideBySide, OfOneThatIsRejectedNothingIsShown) {
    const auto page = test::makePage("elastic-hinge");
    SceneModel& model = *page->model();
    CaseFile file = model.caseFile();
    Json good = file.input;
    good["lambda"] = 0.25;
    Json bad = file.input;
    bad["lambda"] = 5.0;
    file.variants = {{"good", good}, {"bad", bad}};
    CaseDocument(&model).open(file, u"/tmp/x.case.json"_s);
    const VariantTable dialog(page.get(), nullptr);
    const ResultTable& table = *dialog.table();
    ASSERT_EQ(table.columnCount(), 4);
    EXPECT_EQ(table.item(0, 2)->text(), u"0.25"_s) << table.asText().toStdString();
    for (int row = 0; row < table.rowCount(); ++row) {
        EXPECT_EQ(table.item(row, 3)->text(), u"–"_s) << row;
    }
}

/// The file of the present case is gone: what the page shows of it stands.
TEST(VariantsSideBySide, ShowThePresentWithoutItsFile) {
    const QTemporaryDir folder;
    const auto page = test::makePage("balance-shaft");
    SceneModel& model = *page->model();
    write_text_file(
        fsPath(folder.filePath(u"ind.csv"_s)),
        balance_shaft::write_torque_table(balance_shaft::preset_tmz_650d().torque.table));
    model.keepVariant(u"inside"_s);
    Json input = model.inputJson();
    input["torque"] = {{"csv", "ind.csv"}};
    model.loadInput(input, CaseContext{fsPath(folder.path())});
    QFile::remove(folder.filePath(u"ind.csv"_s));
    const VariantTable dialog(page.get(), nullptr);
    const ResultTable& table = *dialog.table();
    const int row = rowNamed(table, u"range · Mᵤₚₛ, N·m"_s);
    ASSERT_GE(row, 0);
    EXPECT_NE(table.item(row, 1)->text(), u"–"_s);
    EXPECT_TRUE(says(dialog, u"Present: "_s));
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
    EXPECT_EQ(model.changedFilesText(0), QString());
    table.torque[5] += 1.0;
    write();
    const QString wanted = u"ind.csv has changed since this variant was kept"_s;
    QSignalSpy said(page.get(), &ScenePage::status);
    model.chooseReference(-1);
    model.chooseReference(0);
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.last().at(0).toString().contains(wanted));
    const VariantTable dialog(page.get(), nullptr);
    EXPECT_TRUE(says(dialog, u"C: "_s + wanted));
}

/// The best is marked among designs without a warning: the present one is better and does not fit.
TEST(VariantsSideBySide, MarkTheBestAndSayNothingOfWhatIsEqual) {
    const auto page = test::makePage("balance-shaft");
    SceneModel& model = *page->model();
    const QString example = QStringLiteral(RAVNOVES_EXAMPLES "/with-shaft-88x75.case.json");
    CaseDocument(&model, {}).open(CaseDocument::read(example), example);
    model.setByKey(u"shaft_angle_deg"_s, u"70"_s);
    model.keepVariant(u"worse"_s);
    model.setByKey(u"shaft_angle_deg"_s, u"60"_s);
    model.setByKey(u"centre_distance_mm"_s, u"90"_s);
    model.keepVariant(nameByDifferences(model));
    EXPECT_EQ(model.variants().constLast().name, u"l\u00a090\u00a0mm, α\u00a060°"_s);
    model.chooseReference(0);
    model.setByKey(u"shaft_angle_deg"_s, u"50"_s);
    const VariantTable dialog(page.get(), nullptr);
    const ResultTable& table = *dialog.table();
    EXPECT_TRUE(table.item(0, 0)->text().startsWith(u"Centre distance"_s));
    EXPECT_TRUE(table.item(1, 0)->text().startsWith(u"Shaft angle"_s));
    EXPECT_EQ(table.item(1, 1)->text(), u"50"_s);
    EXPECT_EQ(table.differenceAt(1, 1).value(0), u"−20"_s);
    EXPECT_FALSE(table.item(2, 0)->text().startsWith(u"Offset"_s)) << "nothing else differs";
    const int range = rowNamed(table, u"range · Mᵤₚₛ"_s);
    ASSERT_GE(range, 0);
    std::vector<double> values;
    int stars = 0;
    for (int column = 1; column < 4; ++column) {
        QString text = table.item(range, column)->text();
        const bool isBest = text.startsWith(u"★"_s);
        stars += isBest ? 1 : 0;
        values.push_back(text.remove(u"★ "_s).section(u' ', 0, 0).toDouble());
        EXPECT_EQ(isBest, column == 3) << text.toStdString();
    }
    EXPECT_EQ(stars, 1);
    const auto isSaid = [&dialog] {
        return std::ranges::any_of(dialog.findChildren<QLabel*>(), [&](const QLabel* each) {
            return each->text().startsWith(u'★') && each->isVisibleTo(&dialog);
        });
    };
    EXPECT_TRUE(isSaid());
    EXPECT_EQ(model.verdictShown()->severity, Severity::error);
    EXPECT_LT(values[2], values[1]);
    EXPECT_EQ(std::min_element(values.begin(), values.end()), values.begin());
    const int without = rowNamed(table, u"range · Mᵤₚ,"_s);
    ASSERT_GE(without, 0);
    for (int column = 1; column < 4; ++column) {
        EXPECT_TRUE(table.differenceAt(without, column).isEmpty());
    }
    // For a spreadsheet: numbers alone, differences in columns of their own.
    const QStringList lines = table.asCsv().split(u'\n');
    EXPECT_EQ(lines[0],
              u"Result,Present,Δ Present,\"Δ Present, %\",worse (reference),"
              u"\"l\u00a090\u00a0mm, α\u00a060°\",\"Δ l\u00a090\u00a0mm, α\u00a060°\","
              u"\"Δ l\u00a090\u00a0mm, α\u00a060°, %\""_s);
    EXPECT_FALSE(table.asCsv().contains(u'★'));
    const auto labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* each) {
        return each->text().startsWith(u"Present: "_s) && each->text().contains(u"\nworse: "_s);
    })) << "the verdicts are first";
}

TEST(VariantsSideBySide, NameLayoutsAndSayWhichTheyAre) {
    InertiaMomentsPage page;
    InertiaMomentsModel& model = *page.viewModel();
    for (const auto& [layout, name] : {std::pair(u"i3"_s, u"In-line 3"_s), {u"vr6"_s, u"VR6"_s}}) {
        model.chooseLayout(layout);
        model.keepVariant(nameByDifferences(model));
        EXPECT_EQ(model.variants().constLast().name, name);
    }
    model.makeTable();
    const VariantTable dialog(&page, nullptr);
    const ResultTable& table = *dialog.table();
    EXPECT_EQ(table.item(0, 0)->text(), u"Layout"_s);
    EXPECT_EQ(table.item(0, 1)->text(), u"Own table, cylinders: 6"_s);
    EXPECT_EQ(table.item(0, 2)->text(), u"In-line 3"_s);
    EXPECT_EQ(table.item(0, 3)->text(), u"VR6"_s);
    EXPECT_TRUE(table.item(1, 0)->text().contains(u"1\u2002M"_s)) << qPrintable(table.asText());
}

TEST_P(EveryPagesVariants, AReferenceThatIsRejectedSaysWhy) {
    model().keepVariant();
    CaseFile file{GetParam(), "", model().inputJson()};
    Json bad = model().inputJson();
    bad["no_such_key"] = 1;
    file.variants.push_back({"bad", bad});
    CaseDocument(&model()).open(file, u"/tmp/x.case.json"_s);
    ASSERT_EQ(model().variants().size(), 1);
    QSignalSpy said(page.get(), &ScenePage::status);
    model().chooseReference(0);
    EXPECT_EQ(reference(), nullptr);
    ASSERT_FALSE(said.isEmpty());
    const QString why = model().takeVariant(0);
    ASSERT_FALSE(why.isEmpty());
    EXPECT_TRUE(said.last().at(0).toString().contains(why));
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryPagesVariants,
                         ::testing::ValuesIn(test::sceneNamesWithCases()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

}  // namespace
}  // namespace ravnoves
