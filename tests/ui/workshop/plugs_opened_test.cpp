// Cases of plugs and of bob weights opened in the window, and plugs that come and go.

#include <QCheckBox>
#include <QSettings>

#include "core/workshop/support.h"
#include "fixtures.h"
#include "job_page_test.h"
#include "model/case_document.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// What is withheld, null or not there, is not compared.
void forgetWithheld(Json& was, const Json& is) {
    if (!was.is_structured() || was.type() != is.type()) {
        was = is.is_null() ? Json() : was;
        return;
    }
    const Json before = was;
    for (const auto& item : before.items()) {
        const Json::json_pointer at("/" + item.key());
        if (is.contains(at)) {
            forgetWithheld(was[at], is.at(at));
        } else if (was.is_object()) {
            was.erase(item.key());
        }
    }
}

/// The files of the scenes that became jobs.
std::vector<std::filesystem::path> casesOf(const std::string& scene) {
    std::vector<std::filesystem::path> files;
    for (const auto& folder : {test::fixture_folder(), std::filesystem::path(RAVNOVES_EXAMPLES)}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().string().ends_with(".case.json") &&
                parse_case(read_text_file(entry.path())).scene == scene) {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}

TEST(OpenedCase, HasTheNumbersOfItsScene) {
    for (const std::string scene : {"v8-plugs", "bob-weights"}) {
        const auto files = casesOf(scene);
        EXPECT_GE(files.size(), 2U);
        for (const auto& path : files) {
            SCOPED_TRACE(path.string());
            const CaseFile file = parse_case(read_text_file(path));
            WorkshopModel model({});
            CaseDocument document(&model);
            const QString name = QFile::decodeName(path.c_str());
            document.open(CaseDocument::read(name), name);
            const CaseFile saved = document.model()->caseFile();
            EXPECT_EQ(saved.scene, "workshop");
            EXPECT_EQ(saved.title, file.title);
            EXPECT_EQ(saved.notes, file.notes);
            ASSERT_EQ(model.variants().size(), static_cast<qsizetype>(file.variants.size()));
            const auto compare = [&](const Json& input) {
                Json was = scene_solver(scene).solve(input, {}, {});
                was.erase("verdict");
                const Json is = model.resultJson();
                if (!is.at("doubtful").is_null()) {
                    forgetWithheld(was, scene == "v8-plugs" ? is.at("plugs") : is);
                }
                if (scene == "v8-plugs") {
                    EXPECT_EQ(workshop::test::difference(was, is.at("plugs")), "");
                } else {
                    was.erase("lines");
                    EXPECT_EQ(workshop::test::difference(was, is), "");
                }
            };
            compare(file.input);
            for (std::size_t i = 0; i < file.variants.size(); ++i) {
                EXPECT_EQ(model.variants().at(static_cast<qsizetype>(i)).name,
                          QString::fromStdString(file.variants[i].name));
                WorkshopModel variant({});
                variant.loadInput(saved.variants.at(i).input, {});
                EXPECT_EQ(variant.hasPlugs(), scene == "v8-plugs");
                EXPECT_FALSE(variant.resultJson().contains("error"));
            }
            // The tolerances come along and name what the job has.
            if (!file.study.is_null()) {
                const Json study = parse_json(model.study());
                EXPECT_EQ(study.at("vary").size(), file.study.at("vary").size());
                EXPECT_EQ(study.at("watch").size(), file.study.at("watch").size());
                for (const auto& spread : study.at("vary").items()) {
                    EXPECT_TRUE(saved.input.contains(Json::json_pointer(spread.key())))
                        << spread.key();
                }
                for (const auto& watched : study.at("watch").items()) {
                    EXPECT_TRUE(model.resultJson().contains(Json::json_pointer(watched.key())))
                        << watched.key();
                }
            }
            // Saved and opened again it is the same.
            WorkshopModel again({});
            again.loadFile(parse_shown_case(write_case(saved).dump()), {});
            EXPECT_EQ(again.input(), model.input());
        }
    }
}

TEST_F(PlugsPageTest, PlugsThatComeAndGoKeepPartsAndFactor) {
    QSettings().setValue(u"workshop/tolerance_g_mm"_s, 7.0);
    const auto guard = qScopeGuard([] { QSettings().remove(u"workshop/tolerance_g_mm"_s); });
    model->loadInput(workshop::test::card(), {});
    type("overbalance_percent", u"2"_s);
    const workshop::Input without = model->input();
    const auto toggle = [&] { keys("has_plugs", {Qt::Key_Space}); };
    EXPECT_FALSE(sheets->isTabVisible(PlugsTab));
    EXPECT_TRUE(field("piston")->isVisibleTo(sheets->widget(PartsTab)));
    QWidget* last = fieldsOf(WeighInTab).constLast();
    show(WeighInTab);
    last->setFocus();
    QTest::keyClick(last, Qt::Key_Return);
    EXPECT_EQ(sheets->currentIndex(), MachineTab) << "no sheet that is not there";
    toggle();
    ASSERT_TRUE(model->hasPlugs());
    EXPECT_TRUE(sheets->isTabVisible(PlugsTab));
    EXPECT_FALSE(field("piston")->isVisibleTo(sheets->widget(PartsTab)));
    EXPECT_TRUE(field("reciprocating_mass_g")->isVisibleTo(sheets->widget(PartsTab)));
    EXPECT_FALSE(model->resultJson().at("error").get<std::string>().find("factor") !=
                 std::string::npos);
    EXPECT_DOUBLE_EQ(model->input().plugs->tolerance, 7.0 * units::gram_mm) << "Shop limit";
    EXPECT_EQ(model->input().correction, without.correction);
    EXPECT_EQ(model->input().tolerance, without.tolerance);
    type("rod_big_end", u"0.5"_s);
    toggle();
    EXPECT_EQ(model->input(), without);
    EXPECT_FALSE(sheets->isTabVisible(PlugsTab));
    toggle();
    EXPECT_NEAR(model->input().plugs->typed_changes.rod_big_end, 0.5 * units::gram, 1e-15);
    model->history()->undo();
    EXPECT_EQ(model->input(), without);
    // Another engine than a V-8 at 90° has none.
    toggle();
    type("bank_angle_deg", u"60"_s);
    EXPECT_TRUE(model->input().engine.bank_angle == without.engine.bank_angle)
        << "refused while there are plugs";
    EXPECT_TRUE(field("bank_angle_deg")->trouble().contains(u"Untick"_s));
    QTest::keyClick(field("bank_angle_deg"), Qt::Key_Escape);
    toggle();
    type("bank_angle_deg", u"60"_s);
    EXPECT_FALSE(find<QCheckBox>("has_plugs")->isEnabled());
    // Those of one job are not in the next.
    type("bank_angle_deg", u"90"_s);
    model->newJob();
    toggle();
    EXPECT_FALSE(model->plugsInput()->changes_known());
}

}  // namespace
}  // namespace ravnoves
