// What versions before this one wrote is opened: cases, journals, copies kept for a crash,
// settings.

#include "fixtures.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <map>
#include <memory>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "files.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "model/case_document.h"
#include "model/recovery.h"
#include "scenes/scenes.h"
#include "shop/model/journal.h"
#include "shop/model/scale_settings.h"
#include "text/language.h"
#include "text/preferences.h"
#include "workshop/model/workshop_model.h"
#include "workshop/older_formats.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using test::Difference;

/// "CASE/POINTER" of a case that was opened and saved again: what the window does not keep as it
/// was. Whoever takes a key out adds it here and says why.
const std::vector<Difference> differences_of_saved_cases{
    {"*/relieved_shaft/elastic_modulus_GPa", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/bearing_span_mm", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/allowable_stress_MPa", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/permitted_sag_mm", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/speed_margin", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/bearing_load_limit_N", "bending of the relieved shaft is not computed"},
    {"*/input/rod_length_mm", "the engine's sizes stand once, in cylinder"},
    {"*/input/offset_mm", "the engine's sizes stand once, in cylinder"},
    {"*/torque/cycle/*_mm", "the engine's sizes stand once, in cylinder"},
    {"*/torque/pressure/*_mm", "the engine's sizes stand once, in cylinder"},
    {"*/envelope/cylinder_bore_mm", "the engine's sizes stand once, in cylinder"},
    {"interrupted/input/envelope", "it had the bore alone, which stands in cylinder"},
    {"two-stroke/input/envelope", "it had the bore alone, which stands in cylinder"},
};
/// "JOURNAL/jobs/ID/COLUMN", the same of what the journal lists.
const std::vector<Difference> differences_of_journals{};

QString inFixtures(const QString& name) {
    return QDir(QFile::decodeName(test::fixture_folder().c_str())).filePath(name);
}

std::unique_ptr<SceneModel> modelOf(const std::string& scene, const QString& journal = {}) {
    if (scene == "balance-shaft") {
        return std::make_unique<BalanceShaftModel>();
    }
    if (scene == "elastic-hinge") {
        return std::make_unique<ElasticHingeModel>();
    }
    if (scene == "inertia-moments") {
        return std::make_unique<InertiaMomentsModel>();
    }
    return std::make_unique<WorkshopModel>(journal);
}

/// "SCENE/POINTER" of what a job does not say as the scene did that it came from.
const std::vector<Difference> differences_of_jobs{
    {"*/verdict*", "a job is judged as a whole"},
};
/// The same of one with a doubt.
const std::vector<Difference> differences_of_doubted_jobs{
    {"*/verdict*", "a job is judged as a whole"},
    {"*/within_tolerance", "what is doubted has no verdict"},
    {"*/passes", "what is doubted has no verdict"},
};

/// A result with the lines of the bob weight by their parts, whatever their order.
Json byPart(Json result) {
    if (result.contains("lines")) {
        Json lines = Json::object();
        for (const Json& line : result.at("lines")) {
            lines[line.at("part").get<std::string>()] = line;
        }
        result["lines"] = lines;
    }
    return result;
}

/// A job has the numbers of the scene that it came from, doubted or not.
void expectNumbersOf(const std::string& scene, const Json& input, Json job) {
    Json result;
    try {
        result = scene_solver(scene).solve(input, {}, {});
    } catch (const InputError&) {
        return;  // it is half filled
    }
    const bool isDoubted = job.at("doubtful").is_object();
    if (isDoubted) {
        job.merge_patch(Json(job.at("doubtful")));
    }
    const auto found = test::differences(
        scene, byPart(result), byPart(scene == "v8-plugs" ? job.at("plugs") : job),
        isDoubted ? differences_of_doubted_jobs : differences_of_jobs);
    EXPECT_TRUE(found.empty()) << test::first_of(found);
}

class FixtureOfWindow : public ::testing::TestWithParam<std::string> {
  protected:
    QString copy(const QString& name) const {
        const QString to = folder.filePath(name);
        EXPECT_TRUE(QFile::copy(inFixtures(name), to));
        QFile(to).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        return to;
    }

    QTemporaryDir folder;
};

TEST_P(FixtureOfWindow, IsOpenedAndSavedAsItWas) {
    const QString path = inFixtures(QString::fromStdString(GetParam()) + u".case.json"_s);
    const Json was = test::fixture(GetParam() + ".saved.json");  // as that window saved it
    const CaseFile file = CaseDocument::read(path);
    // Plugs and bob weights are jobs of the workshop now.
    const CaseFile job = workshop::as_job(parse_case(was.dump()));
    EXPECT_EQ(file.scene, job.scene);
    const auto model = modelOf(file.scene);
    CaseDocument document(model.get());
    ASSERT_NO_THROW(document.open(file, path));
    EXPECT_FALSE(document.needsSaving());
    EXPECT_EQ(model->variants().size(),
              static_cast<qsizetype>(was.value("variants", Json::array()).size()));
    const Json saved = parse_json(document.asText(path));
    for (const char* text : {"title", "notes", "reference"}) {
        EXPECT_EQ(saved.value(text, ""), was.value(text, ""));
    }
    const bool isJob = job.scene != was.at("scene").get<std::string>();
    const auto found = test::differences(GetParam(), isJob ? write_case(job) : was, saved,
                                         differences_of_saved_cases);
    EXPECT_TRUE(found.empty()) << test::first_of(found);
    const auto isSolvedAs = [&](const Json& input) {
        const Json result = model->resultJson();
        EXPECT_FALSE(result.contains("error")) << result.dump();
        if (isJob) {
            expectNumbersOf(was.at("scene"), input, result);
        }
    };
    isSolvedAs(was.at("input"));
    for (int i = 0; i < model->variants().size(); ++i) {
        EXPECT_EQ(model->takeVariant(i), QString()) << i;
        isSolvedAs(was.at("variants").at(static_cast<std::size_t>(i)).at("input"));
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, FixtureOfWindow,
                         ::testing::ValuesIn(test::fixtures_with(".case.json")),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

class FixtureJournal : public FixtureOfWindow {};

TEST_P(FixtureJournal, ListsAndOpensItsJobs) {
    const QString path = copy(QString::fromStdString(GetParam()) + u".sqlite"_s);
    Journal journal(path);
    ASSERT_TRUE(journal.open()) << journal.lastError().toStdString();
    EXPECT_EQ(journal.openMessage(), QString());
    const auto number = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    Json is{{"jobs", Json::object()}, {"drafts", Json::object()}, {"engines", Json::array()}};
    const QList<JournalJob> jobs = journal.search({});
    for (const JournalJob& job : jobs) {
        is["jobs"][std::to_string(job.id)] = {
            {"revision", job.revision},
            {"scene", job.scene.toStdString()},
            {"engine_number", job.engineNumber.toStdString()},
            {"crankshaft_number", job.crankshaftNumber.toStdString()},
            {"customer", job.customer.toStdString()},
            {"technician", job.technician.toStdString()},
            {"engine", job.engine.toStdString()},
            {"job_date", job.date.toString(Qt::ISODate).toStdString()},
            {"process", job.process.toStdString()},
            {"unbalanced_mass_g", number(job.unbalancedMass)},
            {"recommended", job.recommended.toStdString()},
            {"reduction_g", number(job.reduction)},
            {"bob_weight_g", number(job.bobWeight)},
            {"front_reading_g_mm", number(job.frontReading)},
            {"rear_reading_g_mm", number(job.rearReading)},
            {"verdict", job.verdict.toStdString()},
            {"is_finished", job.isFinished ? 1 : 0}};
    }
    const QList<JournalDraft> drafts = journal.orphanedDrafts();
    for (const JournalDraft& draft : drafts) {
        is["drafts"][draft.session.toStdString()] = {
            {"job_id", draft.jobId},
            {"engine_number", draft.engineNumber.toStdString()},
            {"scene", draft.scene.toStdString()}};
    }
    for (const JournalEngine& engine : journal.engines()) {
        is["engines"].push_back(engine.name.toStdString());
    }
    const Json was = test::fixture("journals.json").at(GetParam());
    EXPECT_EQ(is.at("jobs").size(), was.at("jobs").size());
    EXPECT_EQ(is.at("drafts").size(), was.at("drafts").size());
    const auto found = test::differences(GetParam(), was, is, differences_of_journals);
    EXPECT_TRUE(found.empty()) << test::first_of(found);

    // Each of them is opened as a job with what it had.
    for (const JournalJob& job : jobs) {
        WorkshopModel model(path);
        ASSERT_TRUE(model.desk()->openJournal());
        EXPECT_EQ(model.desk()->openJob(job.id), QString());
        const CaseFile kept = parse_case(journal.job(job.id)->form.toStdString());
        const auto changed = test::differences(GetParam() + "/form", workshop::as_job(kept).input,
                                               model.inputJson(), differences_of_journals);
        EXPECT_TRUE(changed.empty()) << test::first_of(changed);
        expectNumbersOf(kept.scene, kept.input, model.resultJson());
        // Saved again it is the same row, and no other engine's.
        model.edit(u"note"_s, [](workshop::Input& input) { input.job.notes += " again"; });
        EXPECT_EQ(model.desk()->otherEngine(), QString());
        bool isSaved = false;
        model.desk()->saveJob(&isSaved, job.isFinished);
        EXPECT_TRUE(isSaved);
        EXPECT_EQ(model.desk()->jobId(), job.id);
        const JournalJob saved = journal.job(job.id).value();
        EXPECT_EQ(saved.scene, u"workshop"_s);
        EXPECT_EQ(saved.bobWeight.has_value(),
                  job.bobWeight.has_value() && !model.withheld().bob_weight)
            << job.id;
    }
    // An engine of the user's own is a job since there is no store of them.
    EXPECT_EQ(journal.search({}).size(),
              jobs.size() + static_cast<qsizetype>(is.at("engines").size()));
    EXPECT_TRUE(journal.engines().isEmpty());
    // Opening the journal puts the drafts among the unsaved cases.
    ASSERT_TRUE(WorkshopModel(path).desk()->openJournal());
    EXPECT_TRUE(journal.orphanedDrafts().isEmpty());
    Recovery recovery;
    const QList<RecoveredCase> left = recovery.leftBehind().cases;
    EXPECT_EQ(left.size(), drafts.size());
    for (const RecoveredCase& each : left) {
        const auto draft = std::find_if(drafts.begin(), drafts.end(), [&](const JournalDraft& one) {
            return parse_shown_case(one.form.toStdString()).input == each.content.input;
        });
        ASSERT_NE(draft, drafts.end());
        const auto model = modelOf(each.content.scene, path);
        CaseDocument document(model.get());
        document.restore(each.content, each);
        EXPECT_EQ(model->findChild<JobDesk*>()->jobId(), draft->jobId);
        EXPECT_TRUE(document.needsSaving());
        recovery.discard(each);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, FixtureJournal, ::testing::Values("journal", "drafts"));

using FixtureRecovery = FixtureOfWindow;

TEST_F(FixtureRecovery, IsOfferedAndRestored) {
    // The copies name the folder in which the cases lay.
    const QDir kept(inFixtures(u"recovery"_s));
    for (const QString& name : kept.entryList(QDir::Files)) {
        test::writeFile(
            folder.filePath(name),
            test::contentOf(kept.filePath(name)).replace("/tmp/engines", inFixtures({}).toUtf8()));
    }
    Recovery recovery(folder.path());
    const Recovery::Found found = recovery.leftBehind();
    EXPECT_TRUE(found.damaged.isEmpty());
    std::map<std::string, Json> inputs;
    for (const RecoveredCase& each : found.cases) {
        const auto model = modelOf(each.content.scene);
        CaseDocument document(model.get());
        ASSERT_NO_THROW(document.restore(each.content, each));
        EXPECT_TRUE(document.needsSaving());
        EXPECT_EQ(document.path().isEmpty(), each.content.scene == "elastic-hinge");
        inputs[each.content.scene] = model->inputJson();
    }
    ASSERT_EQ(inputs.size(), 3U);
    EXPECT_EQ(inputs["balance-shaft"].at("shaft_angle_deg"), 77);
    EXPECT_EQ(inputs["elastic-hinge"].at("lambda"), 0.31);
    EXPECT_EQ(inputs["workshop"].at("job").at("notes"), "typed before the end");
}

TEST(FixtureSettings, AreTakenOver) {
    const QSettings was(inFixtures(u"settings.conf"_s), QSettings::IniFormat);
    QSettings settings;
    for (const QString& key : was.allKeys()) {
        settings.setValue(key, was.value(key));
    }
    Preferences& preferences = Preferences::instance();
    preferences.load();
    EXPECT_EQ(preferences.digits(), 6);
    EXPECT_EQ(preferences.units(Preferences::Length), Preferences::Units::Imperial);
    EXPECT_EQ(preferences.units(Preferences::Unbalance), Preferences::Units::OunceInch);
    EXPECT_EQ(wantedLanguage(), u"ru"_s);
    EXPECT_EQ(CaseDocument::recentPaths(),
              (QStringList{u"/tmp/engines/v8-plugs.case.json"_s,
                           u"/tmp/engines/balance-shaft.case.json"_s}));
    ScaleSettings scale;
    scale.port = u"/dev/ttyUSB0"_s;
    scale.baud = 4800;
    scale.parity = ScaleSettings::Even7;
    scale.usualUnit = ScaleSettings::Ounce;
    scale.taking = ScaleSettings::EachPart;
    scale.resolution = 1e-4;
    EXPECT_EQ(ScaleSettings::load(), scale);
    settings.clear();
    preferences.load();
}

}  // namespace
}  // namespace ravnoves
