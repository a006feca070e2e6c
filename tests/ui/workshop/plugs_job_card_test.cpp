// The job card as a reader of the PDF finds it: its text is extracted and its numbers compared
// with what the command line computes from the same case.

#include <QSettings>
#include <cmath>
#include <random>

#include "job_page_test.h"
#include "text/preferences.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

Json eight(double first, double step) {
    Json masses = Json::array();
    for (int i = 0; i < 8; ++i) {
        masses.push_back(first + i * step);
    }
    return masses;
}

/// Plugs that weigh what their sizes say, with a bore that is to be made deeper.
void bore(Json& input) {
    input["plugs"]["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14,
        "bore_diameter_mm": 14, "bore_depth_mm": 8, "cutter_diameter_mm": 14,
        "minimum_wall_mm": 1.5, "minimum_bottom_mm": 2})");
    input["plugs"]["engine"].update(parse_json(R"({"steel_plug_mass_g": 28.5,
        "aluminium_plug_mass_g": 9.8, "new_steel_plug_mass_g": 30,
        "new_aluminium_plug_mass_g": 10.3, "max_steel_reduction_g": 6,
        "max_aluminium_reduction_g": 2})"));
    input["plugs"]["tolerance_g_mm"] = 30;
}

class JobCardTest : public ::testing::Test {
  protected:
    QString path(const QString& name) const { return QDir(folder_.path()).filePath(name); }

    /// What the command line says of the case.
    Json commandLine(const Json& input) {
        write_text_file(path(u"card.case.json"_s).toStdString(),
                        write_case({"workshop", "card", input}).dump());
        QProcess process;
        process.start(QStringLiteral(RAVNOVES_CLI), {u"solve"_s, path(u"card.case.json"_s)});
        EXPECT_TRUE(process.waitForFinished(60000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().data();
        return parse_json(process.readAllStandardOutput().toStdString()).at("result");
    }

    /// The text of the card's PDF, in rows as they are printed.
    QStringList cardRows(const Json& input, const QString& language) {
        const QString pdf = path(u"card.pdf"_s);
        model_.loadInput(input, {});
        test::writeFile(pdf, paperAsPdf(jobCard(model_, Words(language)), cardPaper()));
        return textOfPdf(pdf).split(u'\n');
    }
    QString cardText(const Json& input, const QString& language) {
        return cardRows(input, language).join(u' ').simplified();
    }

    /// The numbers of the first row that begins with the text and has as many, after it.
    static std::vector<double> numbers(const QStringList& rows, const QString& start,
                                       std::size_t minimum = 0) {
        for (const QString& row : rows) {
            const qsizetype at = row.indexOf(start);
            // A title begins its row; a name in a sentence does not.
            if (at < 0 || !row.left(at).trimmed().isEmpty()) {
                continue;
            }
            std::vector<double> found;
            static const QRegularExpression number(u"(?<![\\w.,])[−-]?\\d+([.,]\\d+)?"_s);
            const QString rest = row.mid(at + start.size()).trimmed();
            if (number.match(rest).capturedStart() != 0) {
                continue;  // a longer name
            }
            auto match = number.globalMatch(rest);
            while (match.hasNext()) {
                QString text = match.next().captured();
                text.replace(u'−', u'-').replace(u',', u'.');
                found.push_back(text.toDouble());
            }
            if (found.size() >= minimum) {
                return found;  // a warning may begin so, too
            }
        }
        ADD_FAILURE() << "no row begins with " << qPrintable(start) << " in\n"
                      << qPrintable(rows.join(u'\n'));
        return {};
    }

    /// Every number that both say.
    void compare(const Json& input, const QString& language) {
        const Json result = commandLine(input);
        const QStringList rows = cardRows(input, language);
        const Words words(language);
        for (const v8_plugs::OptionId id : v8_plugs::all_options) {
            const Word& word = v8_plugs::option_word(id);
            const Json& option = result.at("plugs").at("options").at(std::string(word.word));
            if (option.at("constant_g").is_null()) {
                continue;
            }
            const auto row = numbers(rows, words.text(word.label));
            ASSERT_EQ(row.size(), 3U) << word.word;
            EXPECT_NEAR(row[0], option.at("take_off_g").get<double>(), 0.5001e-3);
            EXPECT_NEAR(row[2], option.at("residual_unbalance_g_mm").get<double>(), 0.0501);
        }
        // The bob weight in large type, and its lines, which add up to it as printed.
        const double weight = result.at("bobweight_g");
        const QString large = words.number(weight * units::gram, units::gram, 1).simplified();
        EXPECT_TRUE(rows.join(u' ').simplified().contains(large)) << qPrintable(large);
        double sum = 0.0;
        WorkshopModel model({});
        model.loadInput(input, {});
        const ResultRows lines = model.lineResults(words).rows;
        const auto count = static_cast<qsizetype>(result.at("lines").size());
        ASSERT_EQ(lines.size(), count + 3) << "subtotals and sum";
        const auto printed = [&](qsizetype line, std::size_t column) {
            // Beside the last of them there may be a drawing of the plug.
            const auto row = numbers(rows, lines.at(line).at(0).text, column + 1);
            return row.size() > column ? row[column] : -1.0;
        };
        for (qsizetype i = 0; i < count; ++i) {
            sum += printed(i, 2);
        }
        EXPECT_NEAR(printed(count + 2, 0), weight, 0.0501);
        EXPECT_NEAR(printed(count + 2, 0), sum, 1e-9 * sum);
        EXPECT_NEAR(printed(count, 0) + printed(count + 1, 0), sum, 1e-9 * sum)
            << "reciprocating and rotating";
        if (result.contains("permissible_g_mm")) {
            const QString limit = model.limitText(words);
            EXPECT_TRUE(rows.join(u' ').simplified().contains(limit.simplified()))
                << qPrintable(limit);
        }
    }

    static Json shopsJob() {
        Json input = repairJob();
        input["tolerance"] = {
            {"grade_mm_s", 16}, {"rotor_mass_kg", 33.5}, {"service_speed_rpm", 3200}};
        input["correction"]["readings"] = {{{"unbalance_g_mm", 410}}, {{"unbalance_g_mm", 900.5}}};
        input["job"] = {{"engine_number", "53-11 № 0042817"},
                        {"crankshaft_number", "66-1005015"},
                        {"customer", "Автобаза № 3"},
                        {"technician", "Иванов А. П."},
                        {"date", "2024-05-31"},
                        {"notes", "Oversize pistons, second repair shells"}};
        return input;
    }
    static void weigh(Json& input, double first, double step) {
        for (const char* part :
             {"piston", "pin", "rings", "rod_big_end", "rod_small_end", "shells"}) {
            input["weigh_in"][part] = {
                {"nominal_g", first}, {"permitted_spread_g", 1}, {"mass_g", eight(first, step)}};
        }
        // Rods whose ends weigh alike are no doubt.
        input["weigh_in"]["rod_small_end"]["nominal_g"] = first / 2;
        input["weigh_in"]["rod_small_end"]["mass_g"] = eight(first / 2, step);
        input["plugs"]["mass_changes_from"] = "typed";
    }

    QTemporaryDir folder_;
    WorkshopModel model_{QString()};
};

TEST_F(JobCardTest, EveryNumberIsTheCommandLines) {
    for (const QString& language : {u"en"_s, u"ru"_s}) {
        compare(repairJob(), language);
        compare(plugsJob("v8-6-manufacture.case.json"), language);
        compare(shopsJob(), language);
    }
    std::mt19937 generator(11);
    const auto between = [&](double low, double high) {
        return std::round(std::uniform_real_distribution<double>(low, high)(generator) * 1e3) / 1e3;
    };
    for (int round = 0; round < 8; ++round) {
        Json input = shopsJob();
        Json& engine = input["plugs"]["engine"];
        engine["crank_radius_mm"] = between(35, 75);
        engine["plug_radius_mm"] = between(40, 80);
        engine["new_plug_radius_mm"] = between(45, 90);
        engine["steel_plug_mass_g"] = between(2, 40);
        engine["max_steel_reduction_g"] = engine["steel_plug_mass_g"].get<double>() / 2;
        engine["new_steel_plug_mass_g"] = between(3, 50);
        engine["rod_coefficient"] = between(0, 1);
        for (const char* key :
             {"piston", "rod_big_end", "repair_piston_and_rings", "repair_bearing"}) {
            input["plugs"]["mass_changes_g"][key] = between(-3, 12);
        }
        input["plugs"]["process"] = round % 3 == 0 ? "manufacture" : "repair";
        if (round % 4 == 1) {
            input["plugs"]["crankshaft"] = "new-plugs";
        }
        compare(input, round % 2 == 0 ? u"en"_s : u"ru"_s);
    }
}

TEST_F(JobCardTest, HasTheHeadTheAnswerAndRoomForSignatures) {
    const QString english = cardText(shopsJob(), u"en"_s);
    EXPECT_TRUE(hasAll(english,
                       {u"53-11 № 0042817"_s, u"66-1005015"_s, u"Автобаза № 3"_s, u"Иванов А. П."_s,
                        u"2024-05-31"_s, u"Take 1.83 g off each of the 8 steel plugs."_s,
                        u"Oversize pistons, second repair shells"_s, u"Technician, signature"_s,
                        u"FAIL"_s, u"410.0"_s, u"900.5"_s, u"Without plugs"_s}));
    const QString russian = cardText(shopsJob(), u"ru"_s);
    EXPECT_TRUE(hasAll(russian, {u"Снять с каждой из 8 стальных заглушек 1,83 г."_s,
                                 u"31.05.2024"_s, u"Исполнитель, подпись"_s, u"1000,0"_s}));
    // No text of the card stays in English.
    static const QRegularExpression english4(u"[a-z]{4,}"_s);
    auto match = english4.globalMatch(russian);
    while (match.hasNext()) {
        const QString word = match.next().captured();
        EXPECT_TRUE(u"Oversize pistons, second repair shells Ravnoves"_s.contains(word))
            << qPrintable(word);
    }
}

TEST_F(JobCardTest, NoTextIsDroppedHoweverMuchThereIsToSay) {
    Json input = shopsJob();
    bore(input);
    weigh(input, 600, 1.11);
    input["job"]["engine_number"] = std::string(60, '8') + "-end1";
    input["job"]["crankshaft_number"] = std::string(60, '0') + "-end2";
    input["job"]["customer"] = std::string(300, 'c') + " end3";
    input["job"]["technician"] =
        "Ivanov-Petrov-Sidorov Alexander Konstantinovich, second shift end4";
    for (const QString& language : {u"en"_s, u"ru"_s}) {
        for (const int count : {1, 100, 2000}) {
            QStringList said;
            for (int i = 0; i < count; ++i) {
                said << u"note%1"_s.arg(i);
            }
            input["job"]["notes"] = said.join(u' ').toStdString();
            const QString text = cardText(input, language);
            WorkshopModel model({});
            model.loadInput(input, {});
            const Words words(language);
            said << model.shiftText(words) << model.hangText(words)
                 << (language == u"ru"_s ? u"Примечания"_s : u"Notes"_s)
                 << (language == u"ru"_s ? u"607,77"_s : u"607.77"_s) << u"end1"_s << u"end2"_s
                 << u"end3"_s << u"end4"_s;
            for (const QString& each : said) {
                EXPECT_TRUE(text.contains(each.simplified())) << qPrintable(each);
            }
            // What to take off, of each of the six.
            EXPECT_TRUE(text.contains(language == u"ru"_s ? u"снять"_s : u"take off"_s));
            EXPECT_GE(text.count(language == u"ru"_s ? u"7,77"_s : u"7.77"_s), 6);
            static const QRegularExpression cut(u"\\w…"_s);
            EXPECT_FALSE(cut.match(text).hasMatch());
        }
    }
}

TEST_F(JobCardTest, IsInTheUnitsChosen) {
    Json input = shopsJob();
    bore(input);
    Preferences::instance().setUnits(Preferences::Mass, Preferences::Units::Imperial);
    Preferences::instance().setUnits(Preferences::Length, Preferences::Units::Imperial);
    const QString text = cardText(input, u"en"_s);
    WorkshopModel model({});
    model.loadInput(input, {});
    const Words english(u"en"_s);
    const auto& planned = *model.plugs()->chosen()->boring;
    const QString depth = english.plainWithUnit(planned.depth, units::mm, 2).simplified();
    const QString boring = model.boringText().simplified();
    QSettings().clear();
    Preferences::instance().load();
    EXPECT_TRUE(text.contains(u"V-8, 90°"_s)) << "as on the page";
    EXPECT_FALSE(text.contains(u"grams"_s));
    EXPECT_FALSE(text.contains(u"millimetres"_s));
    EXPECT_TRUE(has(text, boring));
    EXPECT_EQ(text.count(depth), 2) << "the same on the drawing";
}

TEST_F(JobCardTest, AnAnswerByTheMethodAloneIsNoFact) {
    Json input = repairJob();
    input["plugs"]["engine"]["steel_plug_mass_g"] = 30;  // its shift is worth 49 g·mm
    input["plugs"]["engine"]["max_steel_reduction_g"] = 12;
    input["plugs"]["mass_changes_g"]["repair_piston_and_rings"] = 20;
    for (const bool isBored : {false, true}) {
        if (isBored) {
            input["plugs"]["plug"] =
                parse_json(R"({"thread": "M30x1.5", "height_mm": 14, "cutter_diameter_mm": 20})");
        }
        ASSERT_EQ(commandLine(input).at("plugs").at("state"), "warning");
        const QString text = cardText(input, u"en"_s);
        // What can be done is the headline, what the method would have the small print.
        EXPECT_EQ(text.count(isBored ? u"Take 8.51 g off each of the 8 steel plugs."_s
                                     : u"Take 9.01 g off each of the 8 steel plugs."_s),
                  1)
            << qPrintable(text);
        EXPECT_TRUE(has(text, u"The method neglects"_s));
        EXPECT_FALSE(text.contains(u"9.46 g each"_s));
        EXPECT_FALSE(text.contains(u"balanced:"_s));
        EXPECT_TRUE(has(text, u"works, shift included"_s));
        WorkshopModel model({});
        model.loadInput(input, {});
        EXPECT_TRUE(has(model.checkText(),
                        isBored ? u"Matches nominal: balanced."_s : u"Matches nominal within"_s))
            << "by what is taken off";
        // Banner and result file say the same.
        const std::string reason = commandLine(input).at("plugs").at("reason").get<std::string>();
        EXPECT_EQ(reason.find(isBored ? "Take 8.51 g off" : "Take 9.01 g off"), 0U) << reason;
        EXPECT_EQ(reason.find("to 3.45 mm") != std::string::npos, isBored) << reason;
        if (isBored) {  // to 3.84 mm by the method alone: who bores is told the depth that is right
            EXPECT_EQ(text.count(u"3.84"_s), 0) << qPrintable(text);
            EXPECT_TRUE(has(text, u"cutter of 20 mm to 3.45 mm from the face."_s));
        }
        compare(input, u"en"_s);
    }
}

}  // namespace
}  // namespace ravnoves
