// The plugs of a job without a page: what is computed, said, kept and listed.

#include <QDate>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <algorithm>

#include "job_page_test.h"
#include "v8-plugs/presets.h"
#include "workshop/doubts.h"
#include "workshop/input.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

class PlugsModelTest : public ::testing::Test {
  protected:
    QString path() const { return QDir(folder_.path()).filePath(u"journal.sqlite"_s); }
    static void number(WorkshopModel& model, const char* text) {
        model.edit(u"number"_s, [&](auto& input) { input.job.engine_number = text; });
    }
    QTemporaryDir folder_;
};

TEST_F(PlugsModelTest, OptionsWithConstantSlopeReachNeedAndWhatIsLeft) {
    PlugsModel model;
    model.loadInput(repairJob(), {});
    const auto rows = model.optionResults().rows;
    ASSERT_EQ(rows.size(), 5);
    EXPECT_EQ(rows.at(0).texts(),
              (QStringList{u"✓ Machine the steel plugs"_s, u"0.000"_s, u"2.360"_s, u"4.604"_s,
                           u"1.832"_s, u"0.000"_s, u"0.0"_s}));
    // For the other crankshaft, in brackets; 4.3225 − 6.25281 g times 40 mm.
    EXPECT_EQ(rows.at(4).texts(),
              (QStringList{u"(✗) New crankshaft, aluminium plugs"_s, u"6.253"_s, u"2.360"_s,
                           u"7.867"_s, u"0.000"_s, u"−1.930"_s, u"−77.2"_s}));
    EXPECT_EQ(model.optionResults().columns.size(), rows.at(0).size());
    EXPECT_TRUE(rows.at(4).tip.startsWith(u"For the other crankshaft."_s));
    model.editPlugs(u"crankshaft"_s, [](auto& input) { input.crankshaft = Crankshaft::new_plugs; });
    EXPECT_TRUE(model.optionResults().rows.at(2).constFirst().text.startsWith(u"✓ "_s));
}

TEST_F(PlugsModelTest, HalfFilledSheetNamesWhatIsMissing) {
    PlugsModel model;
    // Nothing is known of the parts: no answer, and no option that would do.
    EXPECT_FALSE(model.plugs()->advice);
    EXPECT_TRUE(begins(model.adviceText(), u"Missing for the plugs: changes of mass"_s));
    EXPECT_FALSE(model.plugs()->option(OptionId::steel_machined));
    EXPECT_EQ(model.shiftText(), QString());
    EXPECT_FALSE(model.inputJson().at("plugs").contains("mass_changes_g"));
    EXPECT_FALSE(model.withheld().any()) << "a preset that nobody typed";
    // All parts may be nominal; that is something else.
    model.editPlugs(u"none"_s, [](auto& input) { input.changes_given = true; });
    EXPECT_TRUE(model.inputJson().at("plugs").contains("mass_changes_g"));
    // 4.25 l: the paper gives no nominal masses; options are known, bob weights are not.
    EXPECT_TRUE(model.plugs()->advice);
    EXPECT_FALSE(model.solution().bob_weight);
    EXPECT_TRUE(model.lineResults().rows.isEmpty());
    EXPECT_TRUE(has(model.headline(), u"reciprocating, one cylinder mⱼ"_s));
    EXPECT_TRUE(model.resultJson().contains("error"));
    model.chooseEngine(3);  // 8.32 l: only the crank radius
    EXPECT_FALSE(model.plugs()->advice);
    EXPECT_TRUE(begins(model.adviceText(), u"Missing for the plugs: plug radius rₚ"_s));
    EXPECT_TRUE(model.engineNote().contains(u"only the crank radius"_s));
    EXPECT_EQ(model.hangText(), QString());
    EXPECT_EQ(model.optionResults().rows.size(), 5);
    model.chooseEngine(0);
    EXPECT_TRUE(model.engineNote().contains(u"weigh the plugs"_s));
}

TEST_F(PlugsModelTest, RulesBetweenFieldsAreNamedNotLost) {
    PlugsModel model;
    model.editPlugs(u"limit"_s, [](auto& input) { input.engine.max_steel_reduction = 3 * gram; });
    EXPECT_EQ(
        model.troubles(),
        QStringList{
            u"Max. off one steel plug Δmₚₘ: must be less than the plug's mass, 2.790\u00A0g."_s});
    EXPECT_FALSE(model.plugs()->advice);
    model.editPlugs(u"mass"_s, [](auto& input) { input.engine.steel_plug_mass = 25 * gram; });
    EXPECT_TRUE(model.troubles().isEmpty());
}

TEST_F(PlugsModelTest, PresetsBringThePrintedSizes) {
    WorkshopModel model{QString()};
    model.setHasPlugs(true);
    EXPECT_EQ(*model.input().plugs->plug, printed_plug("4.25 l"));
    EXPECT_NEAR(model.input().plugs->plug->thread->diameter, 22e-3, 1e-12);
    // The printed masses do not fit the printed sizes: no fault of who has typed nothing.
    const auto isOfThePaper = [&] {
        return model.doubts().size() == 1 && model.doubts().front().rule->word == "paper-plug";
    };
    EXPECT_TRUE(isOfThePaper());
    EXPECT_TRUE(model.engineNote().contains(u"weigh the plugs"_s));
    const v8_plugs::Input printed = *model.input().plugs;
    model.editPlugs(u"mass"_s, [](auto& input) { input.engine.steel_plug_mass = 27.9e-3; });
    ASSERT_EQ(model.doubts().size(), 2U);
    const QString doubt = Words().message(model.doubts().front().text);
    EXPECT_TRUE(has(doubt, u"27.9"_s));
    EXPECT_EQ(model.doubts().back().rule->word, "paper-limit");
    model.editPlugs(u"printed"_s, [&](auto& input) { input = printed; });
    EXPECT_TRUE(isOfThePaper());
    EXPECT_FALSE(model.withheld().any()) << "there is no answer yet";
    model.editPlugs(u"none"_s, [](auto& input) { input.changes_given = true; });
    EXPECT_TRUE(model.withheld().bob_weight) << "no plug was weighed";
    EXPECT_EQ(model.adviceText(), QString());
    model.editPlugs(u"printed"_s, [&](auto& input) { input = printed; });
    model.chooseEngine(3);  // 8.32 l: none printed
    EXPECT_FALSE(model.input().plugs->plug.value_or(PlugSheet{}).thread);
}

TEST_F(PlugsModelTest, AGapInAColumnThatDoesNotCountBreaksNoRule) {
    PlugsModel model;
    model.loadInput(repairJob(), {});
    const QStringList before = model.troubles();
    model.editWeights(u"weigh"_s, [](shop::WeighIn& sheet) {
        sheet[Part::piston].mass.assign({560 * gram, 562 * gram});
        sheet.fit(8);
    });
    model.editPlugs(u"typed"_s, [](auto& input) { input.changes_from_weigh_in = false; });
    ASSERT_NE(model.plugs()->hung_weight(), nullptr);
    EXPECT_EQ(model.troubles(), before + model.notCounted());
}

TEST_F(PlugsModelTest, ColumnsHalfWeighedAreNamed) {
    PlugsModel model;
    model.editWeights(u"weigh"_s, [](shop::WeighIn& sheet) {
        sheet[Part::pin].nominal = 150 * gram;
        sheet[Part::pin].mass[0] = 151 * gram;
        sheet[Part::rings].mass.assign(8, 60 * gram);
    });
    model.editPlugs(u"typed"_s, [](auto& input) { input.changes_from_weigh_in = false; });
    // Typed changes count, and that is said.
    EXPECT_EQ(model.troubles(),
              QStringList{u"Weighed masses are not used: the typed changes are selected."_s});
    EXPECT_EQ(model.troubles(), model.notCounted());
    EXPECT_EQ(model.columnNote(Part::pin).texts[1], u"+1.00"_s);
    EXPECT_FALSE(model.columnNote(Part::pin).counts);
    model.editPlugs(u"source"_s, [](auto& input) { input.changes_from_weigh_in = true; });
    ASSERT_EQ(model.notCounted().size(), 2);
    EXPECT_EQ(model.notCounted().at(0),
              u"Pin: 1 of 8 weighed; nominal is used until all are weighed."_s);
    EXPECT_TRUE(
        model.notCounted().at(1).startsWith(u"Rings: weighed masses need a nominal mass"_s));
    EXPECT_EQ(model.troubles(), model.notCounted());
    EXPECT_FALSE(model.plugs()->advice) << "no column counts yet";
    model.editWeights(u"weigh"_s,
                      [](shop::WeighIn& sheet) { sheet[Part::pin].mass.assign(8, 151 * gram); });
    EXPECT_TRUE(model.columnNote(Part::pin).counts);
    EXPECT_TRUE(model.plugs()->advice);
    model.editPlugs(u"typed"_s, [](auto& input) { input.typed_changes.piston = 1 * gram; });
    EXPECT_EQ(model.notCounted().filter(u"Δmₚᵢ"_s), QStringList()) << "it is grey on its sheet";
    EXPECT_EQ(std::ranges::count(model.replacedInputs(), "/plugs/mass_changes_g/piston"), 1);
}

TEST_F(PlugsModelTest, WhatIsTypedBesideWeightsThatDoNotCountYetIsSaid) {
    PlugsModel model;
    model.loadInput(repairJob(), {});  // big end 0.5 g, shells 1.1 g
    model.editWeights(u"weigh"_s, [](shop::WeighIn& sheet) {
        sheet[Part::piston].mass.assign(8, 619.875 * gram);
    });
    ASSERT_TRUE(model.input().plugs->changes_from_weigh_in);
    EXPECT_FALSE(model.plugs()->advice);
    EXPECT_TRUE(begins(model.notCounted().at(0),
                       u"Big end of one rod: the typed 0.50\u00A0g is not used."_s));
}

TEST_F(PlugsModelTest, WeightsReplaceOnlyWhatIsWeighed) {
    PlugsModel model;
    model.loadInput(repairJob(), {});  // big end 0.5 g, shells 1.1 g
    model.editWeights(u"weigh"_s, [](shop::WeighIn& sheet) {
        sheet[Part::piston].nominal = 600 * gram;
        sheet[Part::piston].mass.assign(8, 619.875 * gram);
        sheet[Part::rod_big_end].nominal = 700 * gram;
        sheet[Part::rod_big_end].mass[0] = 705 * gram;
    });
    // 19.875 + (2 + 0.445) 0.5 + 1.1
    EXPECT_NEAR(*model.plugs()->unbalanced_mass, 22.1975 * gram, 1e-12);
    const QStringList said = model.notCounted();
    const QStringList expected{
        u"Big end of one rod: the typed 0.50\u00A0g is used with the weighed masses."_s,
        u"Repair shells of one crankpin Δmₛₕ: the typed 1.10\u00A0g is used with the weighed masses."_s,
        u"Rod, big end: 1 of 8 weighed; the typed change is used until all are weighed."_s};
    EXPECT_EQ(said, expected) << qPrintable(said.join(u'\n'));
    EXPECT_TRUE(model.plugsInput()->takes_typed(&MassChanges::rod_big_end));
    EXPECT_FALSE(model.plugsInput()->takes_typed(&MassChanges::repair_piston_and_rings));
    model.editWeights(u"weigh"_s, [](shop::WeighIn& sheet) {
        sheet[Part::rod_big_end].mass.assign(8, 700.25 * gram);
    });
    EXPECT_NEAR(*model.plugs()->unbalanced_mass, (19.875 + 2.445 * 0.25 + 1.1) * gram, 1e-12);
}

TEST_F(PlugsModelTest, WeightsCountFromTheFirstToTheLast) {
    PlugsModel model;
    const auto weigh = [&](std::optional<double> mass) {
        model.editWeights(u"weigh"_s,
                          [&](shop::WeighIn& sheet) { sheet[Part::pin].mass[3] = mass; });
    };
    model.editWeights(u"nominal"_s,
                      [](shop::WeighIn& sheet) { sheet[Part::pin].nominal = 150 * gram; });
    EXPECT_FALSE(model.input().plugs->changes_from_weigh_in) << "nothing is weighed yet";
    weigh(151 * gram);
    EXPECT_TRUE(model.input().plugs->changes_from_weigh_in);
    weigh(std::nullopt);
    EXPECT_FALSE(model.input().plugs->changes_from_weigh_in);
    weigh(151 * gram);
    model.editPlugs(u"off"_s, [](auto& input) { input.changes_from_weigh_in = false; });
    weigh(152 * gram);
    EXPECT_FALSE(model.input().plugs->changes_from_weigh_in) << "the user said so";
}

TEST_F(PlugsModelTest, JobsAreSavedOpenedChangedAndCopied) {
    PlugsModel model(path());
    ASSERT_TRUE(model.desk()->openJournal()) << qPrintable(model.desk()->journalTrouble());
    model.loadInput(repairJob(), {});
    model.edit(u"job"_s, [](auto& input) {
        input.job.engine_number = "53-11";
        input.job.customer = "Автобаза";
        input.job.date = "2024-05-31";
    });
    model.editReading(u"reading"_s, 0, 0, false, 3e-6);
    bool ok = false;
    EXPECT_TRUE(model.desk()->saveJob(&ok).contains(u"53-11"_s));
    ASSERT_TRUE(ok);
    const qint64 id = model.desk()->jobId();
    EXPECT_GT(id, 0);
    EXPECT_TRUE(model.history()->isClean());
    const auto row = model.desk()->journal()->job(id);
    ASSERT_TRUE(row);
    EXPECT_NEAR(*row->unbalancedMass, 4.3225, 1e-9);
    EXPECT_EQ(row->recommended, u"steel-machined"_s);
    EXPECT_NEAR(*row->bobWeight, 2326.5844, 1e-6);
    const workshop::Input saved = model.input();

    // Changed and saved again: the same job.
    number(model, "53-12");
    model.keepVariant();
    model.editText(model.title(), u"Ждать поршней"_s);
    model.desk()->saveJob(&ok);
    EXPECT_TRUE(ok);
    EXPECT_EQ(model.desk()->jobId(), id);
    EXPECT_EQ(model.desk()->journal()->search({}).size(), 1);

    model.newJob();
    EXPECT_EQ(model.desk()->jobId(), 0);
    EXPECT_TRUE(model.input().job.engine_number.empty());
    EXPECT_EQ(model.input().plugs->engine, saved.plugs->engine);
    EXPECT_FALSE(model.history()->canUndo());  // undo never mixes two jobs

    EXPECT_EQ(model.desk()->openJob(id), QString());
    EXPECT_EQ(model.desk()->jobId(), id);
    EXPECT_EQ(model.input().job.engine_number, "53-12");
    EXPECT_EQ(model.input().plugs->engine, saved.plugs->engine);
    EXPECT_EQ(model.variants().size(), 1);
    EXPECT_EQ(model.notes(), u"Ждать поршней"_s);

    EXPECT_EQ(model.desk()->openJob(id, true), QString());
    EXPECT_TRUE(model.variants().isEmpty());
    EXPECT_TRUE(model.notes().isEmpty());
    EXPECT_EQ(model.desk()->jobId(), 0);
    EXPECT_TRUE(model.input().job.engine_number.empty());
    // Other parts: nothing that was weighed, and no other's customer.
    EXPECT_EQ(model.input().job.customer, "");
    EXPECT_EQ(model.input().plugs->engine, saved.plugs->engine);
    EXPECT_EQ(model.input().plugs->tolerance, saved.plugs->tolerance);
    EXPECT_FALSE(model.plugsInput()->changes_known());
    EXPECT_FALSE(model.plugsInput()->has_typed_changes());
    EXPECT_EQ(model.input().job.date, QDate::currentDate().toString(Qt::ISODate).toStdString());
    EXPECT_FALSE(model.reading(0, 0).unbalance);
    number(model, "53-13");
    model.desk()->saveJob(&ok);
    EXPECT_NE(model.desk()->jobId(), id);
    EXPECT_EQ(model.desk()->journal()->search({}).size(), 2);
    EXPECT_FALSE(model.desk()->openJob(9999).isEmpty());
}

TEST_F(PlugsModelTest, WhatNoPlugCompensatesIsListedSo) {
    PlugsModel model(path());
    ASSERT_TRUE(model.desk()->openJournal()) << qPrintable(model.desk()->journalTrouble());
    Json input = repairJob();
    input["plugs"]["mass_changes_g"]["repair_piston_and_rings"] = 60.0;
    input["job"]["engine_number"] = "53-13";
    model.loadInput(input, {});
    ASSERT_TRUE(model.resultJson().at("plugs").at("recommended").is_null());
    bool ok = false;
    model.desk()->saveJob(&ok);
    ASSERT_TRUE(ok);
    const auto row = model.desk()->journal()->job(model.desk()->jobId());
    ASSERT_TRUE(row);
    EXPECT_EQ(row->recommended, u"not-compensated"_s);
    ASSERT_TRUE(row->bobWeight);
    EXPECT_NEAR(*row->bobWeight, *model.solution().bob_weight / gram, 1e-6);
}

TEST_F(PlugsModelTest, EnginesKeptByAnOlderVersionBecomeJobs) {
    ASSERT_TRUE(Journal(path()).open());
    {
        QSqlDatabase other = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"other"_s);
        other.setDatabaseName(path());
        ASSERT_TRUE(other.open());
        QSqlQuery query(other);
        ASSERT_TRUE(query.exec(
            u"INSERT INTO engine VALUES ('КамАЗ-740', '{"
            "\"engine\":{\"name\":\"КамАЗ-740\",\"crank_radius_mm\":60,"
            "\"steel_plug_mass_g\":22.75,\"new_steel_plug_mass_g\":null},"
            "\"plug\":{\"thread\":\"M30x1.5\"},"
            "\"weigh_in\":{\"piston\":{\"nominal_g\":600,\"permitted_spread_g\":3}}}'),"
            " ('old', '{\"crank_radius_mm\":40}'), ('broken', '{\"crank_radius_mm\":')"_s));
    }
    QSqlDatabase::removeDatabase(u"other"_s);
    for (int times = 0; times < 2; ++times) {
        PlugsModel model(path());
        ASSERT_TRUE(model.desk()->openJournal());
        ASSERT_EQ(model.desk()->journal()->search({}).size(), 2) << "the damaged one stays";
        ASSERT_EQ(model.desk()->journal()->engines().size(), 1);
        const auto found = model.desk()->journal()->search({.text = u"камаз"_s});
        ASSERT_EQ(found.size(), 1);
        EXPECT_FALSE(found.constFirst().isFinished);
        ASSERT_EQ(model.desk()->openJob(found.constFirst().id, true), QString());
        const v8_plugs::Input& plugs = *model.input().plugs;
        EXPECT_EQ(plugs.engine.name, "КамАЗ-740");
        EXPECT_DOUBLE_EQ(plugs.engine.steel_plug_mass.value(), 22.75 * gram);
        EXPECT_FALSE(plugs.engine.has_new_plug);
        EXPECT_TRUE(plugs.plug->thread);
        EXPECT_DOUBLE_EQ((*model.input().weigh_in)[shop::Part::piston].nominal.value(), 600 * gram);
    }
}

TEST_F(PlugsModelTest, WithoutAJournalNothingIsWritten) {
    PlugsModel model;
    EXPECT_FALSE(model.desk()->openJournal());
    number(model, "1");
    bool ok = true;
    EXPECT_FALSE(model.desk()->saveJob(&ok).isEmpty());
    EXPECT_FALSE(ok);
}

}  // namespace
}  // namespace ravnoves
