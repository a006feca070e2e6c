// The job card as a reader of the PDF finds it: its text is extracted and every number compared
// with what the command line computes from the same case.

#include "v8-plugs/plugs_card.h"
#include "v8-plugs/scene.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <cmath>
#include <random>

#include "case-file/json.h"
#include "case-file/text_file.h"
#include "painted.h"
#include "scenes/scenes.h"
#include "text/preferences.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using v8_plugs::Input;

class JobCardTest : public ::testing::Test {
  protected:
    static QByteArray run(const QString& program, const QStringList& arguments) {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(60000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().data();
        return process.readAllStandardOutput();
    }

    QString path(const QString& name) const { return QDir(folder_.path()).filePath(name); }

    /// What the command line says of the case.
    Json commandLine(const Json& input) {
        const CaseFile file{"v8-plugs", "card", input};
        write_text_file(path(u"card.case.json"_s).toStdString(), write_case(file).dump());
        return parse_json(run(QStringLiteral(RAVNOVES_CLI), {u"solve"_s, path(u"card.case.json"_s)})
                              .toStdString())
            .at("result");
    }

    /// The card of a case, as the page makes it.
    static PlugsCard card(const Json& input, const QString& language) {
        const Input read = v8_plugs::read_input(input, Completeness::as_is);
        return {read, V8PlugsScene{.dated = false}.solve(read), Words(language)};
    }

    /// The text of the card's PDF, in rows as they are printed.
    QStringList cardText(const Json& input, const QString& language, int sheets = 1) {
        const QString pdf = path(u"card.pdf"_s);
        EXPECT_EQ(card(input, language).writePdf(pdf), QString());
        const QByteArray text =
            run(QStringLiteral(PDFTOTEXT), {u"-layout"_s, u"-enc"_s, u"UTF-8"_s, pdf, u"-"_s});
        // A form feed ends each page.
        EXPECT_EQ(text.count('\f'), sheets);
        return QString::fromUtf8(text).split(u'\n');
    }

    /// The numbers of the row that begins with the text, after it.
    static std::vector<double> numbers(const QStringList& rows, const QString& start) {
        for (const QString& row : rows) {
            const qsizetype at = row.indexOf(start);
            // A title begins its row; a name in a sentence does not.
            if (at < 0 || !row.left(at).trimmed().isEmpty()) {
                continue;
            }
            std::vector<double> found;
            static const QRegularExpression number(u"(?<![\\w.,])[−-]?\\d+([.,]\\d+)?"_s);
            auto match = number.globalMatch(row.mid(at + start.size()));
            while (match.hasNext()) {
                QString text = match.next().captured();
                text.replace(u'−', u'-').replace(u',', u'.');
                found.push_back(text.toDouble());
            }
            return found;
        }
        ADD_FAILURE() << "no row begins with " << qPrintable(start) << " in\n"
                      << qPrintable(rows.join(u'\n'));
        return {};
    }

    struct Titles {
        QString options[4];
        QString sum, hang, excess, front, rear, reciprocating, shells;
    };
    static Titles titles(const QString& language) {
        if (language == u"ru"_s) {
            return {{u"Облегчить стальные пробки"_s, u"Алюминиевые пробки"_s,
                     u"Новый вал, стальные пробки"_s, u"Новый вал, алюминиевые пробки"_s},
                    u"Сумма: груз"_s,
                    u"Груз на каждую шейку:"_s,
                    u"Неуравновешенная масса на каждой шатунной шейке Δmᵤ ="_s,
                    u"Передняя (шкив)"_s,
                    u"Задняя (маховик)"_s,
                    u"Поступательная масса mⱼ"_s,
                    u"Рем. вкладыши"_s};
        }
        return {{u"Machine today's steel plugs"_s, u"Aluminium plugs"_s,
                 u"New crankshaft, today's steel plugs"_s, u"New crankshaft, aluminium plugs"_s},
                u"Sum: bob weight"_s,
                u"Hang"_s,
                u"Excess on each crankpin Δmᵤ ="_s,
                u"Front (pulley)"_s,
                u"Rear (flywheel)"_s,
                u"Reciprocating mass mⱼ"_s,
                u"Repair shells Δmₛₕ"_s};
    }

    /// Every number that both say.
    void compare(const Json& input, const QString& language, int sheets = 1) {
        const Json result = commandLine(input);
        const QStringList rows = cardText(input, language, sheets);
        const Titles title = titles(language);
        const double third = 0.5001e-3;  // printed with three decimals
        const auto at = [&](const char* pointer) {
            return result.at(Json::json_pointer(pointer)).get<double>();
        };
        const auto excess = numbers(rows, title.excess);
        ASSERT_GE(excess.size(), 2U);
        EXPECT_NEAR(excess[0], at("/unbalanced_mass_g"), third);
        EXPECT_NEAR(excess[1], at("/unbalance_g_mm"), 0.0501);

        constexpr const char* names[] = {"steel-machined", "steel-to-aluminium",
                                         "new-steel-to-steel", "new-steel-to-aluminium"};
        for (std::size_t i = 0; i < 4; ++i) {
            const Json& option = result.at("options").at(names[i]);
            const auto row = numbers(rows, title.options[i]);
            ASSERT_EQ(row.size(), 5U) << names[i];
            EXPECT_NEAR(row[0], option.at("constant_g").get<double>(), third);
            EXPECT_NEAR(row[1], option.at("maximum_g").get<double>(), third);
            EXPECT_NEAR(row[2], option.at("required_reduction_g").get<double>(), third);
            EXPECT_NEAR(row[4], option.at("residual_unbalance_g_mm").get<double>(), 0.0501);
        }

        const Json& recommended = result.at("recommended");
        const bool hasOption = recommended.is_string() && recommended != "none-needed";
        const auto sums = numbers(rows, title.sum);
        ASSERT_GE(sums.size(), hasOption ? 3U : 2U);
        EXPECT_NEAR(sums[0], at("/bobweight/nominal/sum_g"), third);
        EXPECT_NEAR(sums[1], at("/bobweight/before/sum_g"), third);
        if (hasOption) {
            const double after =
                result.at("options").at(recommended.get<std::string>()).at("bobweight_g");
            EXPECT_NEAR(sums[2], after, third);
            EXPECT_NEAR(numbers(rows, title.hang).at(0), after, 0.0501);
        }
        checkSum(rows, title, sums);

        if (result.contains("balancing")) {
            EXPECT_NEAR(numbers(rows, title.front).at(0), at("/balancing/front/permissible_g_mm"),
                        0.0501);
            EXPECT_NEAR(numbers(rows, title.rear).at(0), at("/balancing/rear/permissible_g_mm"),
                        0.0501);
        }
    }

    /// The lines printed between the first part and the sum add up to the printed sum.
    static void checkSum(const QStringList& rows, const Titles& title,
                         const std::vector<double>& sums) {
        std::vector<double> totals(sums.size(), 0.0);
        int lines = 0;
        bool inside = false;
        static const QRegularExpression product(u"(?<![\\w.,])[−-]?\\d+[.,]\\d{3}(?!\\d)"_s);
        for (const QString& row : rows) {
            const bool first =
                row.trimmed().startsWith(title.reciprocating) && product.match(row).hasMatch();
            inside = inside || first;
            if (!inside) {
                continue;
            }
            if (row.contains(title.sum)) {
                break;
            }
            std::vector<double> values;
            auto match = product.globalMatch(row);
            while (match.hasNext()) {
                QString text = match.next().captured();
                values.push_back(text.replace(u'−', u'-').replace(u',', u'.').toDouble());
            }
            // The last numbers with three decimals are the products; a factor may stand before.
            if (values.size() < totals.size()) {
                continue;
            }
            ++lines;
            const std::size_t skip = values.size() - totals.size();
            for (std::size_t i = 0; i < totals.size(); ++i) {
                totals[i] += values[i + skip];
            }
        }
        EXPECT_GE(lines, 6);
        for (std::size_t i = 0; i < totals.size(); ++i) {
            EXPECT_NEAR(totals[i], sums[i], 0.5e-3 * (lines + 1.01));
        }
    }

    static Json exampleInput(const char* name) {
        const QString file = QStringLiteral(RAVNOVES_EXAMPLES) + u'/' + QString::fromLatin1(name);
        return parse_case(read_text_file(file.toStdString())).input;
    }

    static Json workshopInput() {
        Json input = exampleInput("v8-4.25-repair.case.json");
        input["balancing"] = {{"grade_mm_s", 16},
                              {"rotor_mass_kg", 33.5},
                              {"service_speed_rpm", 3200},
                              {"front_reading_g_mm", 410},
                              {"rear_reading_g_mm", 900.5}};
        input["job"] = {{"engine_number", "53-11 № 0042817"},
                        {"crankshaft_number", "66-1005015"},
                        {"customer", "Автобаза № 3"},
                        {"technician", "Иванов А. П."},
                        {"date", "2024-05-31"},
                        {"notes", "Oversize pistons, second repair shells"}};
        return input;
    }

    QTemporaryDir folder_;
};

TEST_F(JobCardTest, EveryNumberIsTheCommandLines) {
    for (const char* name : {"v8-4.25-repair.case.json", "v8-6-manufacture.case.json"}) {
        for (const QString& language : {u"en"_s, u"ru"_s}) {
            compare(exampleInput(name), language);
        }
    }
    compare(workshopInput(), u"en"_s);
    compare(workshopInput(), u"ru"_s);
}

TEST_F(JobCardTest, EveryNumberIsTheCommandLinesForRandomJobs) {
    std::mt19937 generator(11);
    const auto between = [&](double low, double high) {
        return std::round(std::uniform_real_distribution<double>(low, high)(generator) * 1e3) / 1e3;
    };
    for (int round = 0; round < 12; ++round) {
        Json input = workshopInput();
        Json& engine = input["engine"];
        engine["crank_radius_mm"] = between(35, 75);
        engine["plug_radius_mm"] = between(40, 80);
        engine["new_plug_radius_mm"] = between(45, 90);
        engine["steel_plug_mass_g"] = between(2, 40);
        engine["max_steel_reduction_g"] = engine["steel_plug_mass_g"].get<double>() / 2;
        engine["new_steel_plug_mass_g"] = between(3, 50);
        engine["rod_coefficient"] = between(0, 1);
        for (const char* key :
             {"piston", "rod_big_end", "repair_piston_and_rings", "repair_bearing"}) {
            input["mass_changes_g"][key] = between(-3, 12);
        }
        input["process"] = round % 3 == 0 ? "manufacture" : "repair";
        if (round % 4 == 1) {
            input["crankshaft"] = "new-plugs";
        }
        compare(input, round % 2 == 0 ? u"en"_s : u"ru"_s);
    }
}

TEST_F(JobCardTest, HasTheHeadTheAnswerAndRoomForSignatures) {
    const QString english = cardText(workshopInput(), u"en"_s).join(u'\n');
    for (const QString& text :
         {u"53-11 № 0042817"_s, u"66-1005015"_s, u"Автобаза № 3"_s, u"Иванов А. П."_s,
          u"2024-05-31"_s, u"Machine all 8 steel plugs by 1.83 g each."_s,
          u"Oversize pistons, second repair shells"_s, u"Technician, signature"_s, u"passes"_s,
          u"fails"_s, u"After equals nominal: balanced."_s}) {
        EXPECT_TRUE(english.contains(text)) << qPrintable(text);
    }
    const QString russian = cardText(workshopInput(), u"ru"_s).join(u'\n');
    for (const QString& text :
         {u"Снять с каждой из 8 стальных пробок 1,83 г."_s, u"31.05.2024"_s,
          u"Исполнитель, подпись"_s, u"Балансировочный станок"_s, u"1000,000"_s}) {
        EXPECT_TRUE(russian.contains(text)) << qPrintable(text);
    }
    // No text of the card stays in English.
    static const QRegularExpression english4(u"[a-z]{4,}"_s);
    auto match = english4.globalMatch(russian);
    while (match.hasNext()) {
        const QString word = match.next().captured();
        EXPECT_TRUE(u"Oversize pistons, second repair shells Ravnoves"_s.contains(word))
            << qPrintable(word);
    }
}

TEST_F(JobCardTest, NothingIsLeftOutWhenThereIsMuchToSay) {
    Json input = workshopInput();
    input["mass_changes_g"]["rod_big_end"] = 2.2;  // needs the other crankshaft
    input["weigh_in"] = parse_json(R"({"piston": {"nominal_g": 600, "mass_g":
        [601.5, 602.1, 602.3, 603.0, 600.9, 602.2, 601.9, 602.4]}})");
    input["mass_changes_from"] = "typed";
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 6, "cutter_diameter_mm": 14, "minimum_wall_mm": 1.5,
        "minimum_bottom_mm": 2})");
    const QStringList rows = cardText(input, u"ru"_s);
    const QString text = rows.join(u' ').simplified();
    EXPECT_TRUE(text.contains(u"Ближе всего «Алюминиевые пробки»"_s));
    EXPECT_FALSE(text.contains(u'…') && text.contains(u"вместо допус…"_s));
    EXPECT_TRUE(text.contains(u"Массы деталей по цилиндрам"_s));
    EXPECT_TRUE(text.contains(u"Взвешенное не учитывается"_s)) << "typed changes count";
    EXPECT_TRUE(text.contains(u"M22×1,5"_s));
    EXPECT_TRUE(text.contains(u"Исполнитель, подпись"_s));
    // Nothing is cut off: an ellipsis stands only where there is room to write by hand.
    static const QRegularExpression cut(u"\\w…"_s);
    EXPECT_FALSE(cut.match(text).hasMatch()) << qPrintable(text);
}

TEST_F(JobCardTest, LongTextsAndAllSheetsGoOnOnASecondSheet) {
    Json input = workshopInput();
    input["job"]["engine_number"] = std::string(60, '8') + "-end1";
    input["job"]["crankshaft_number"] = std::string(60, '0') + "-end2";
    std::string customer;
    std::string notes;
    for (int i = 0; i < 8; ++i) {
        customer += "Workshop № ";
    }
    for (int i = 0; i < 20; ++i) {
        notes += "Oversize ";
    }
    input["job"]["customer"] = customer + "end3";
    input["job"]["technician"] =
        "Ivanov-Petrov-Sidorov Alexander Konstantinovich, second shift end4";
    input["job"]["notes"] = notes + "end5";
    Json weighIn = Json::object();
    for (const char* part : {"piston", "pin", "rings", "rod_big_end", "rod_small_end", "shells"}) {
        weighIn[part] = {
            {"nominal_g", 600},
            {"permitted_spread_g", 1},
            {"mass_g", {601.11, 602.22, 603.33, 604.44, 605.55, 606.66, 607.77, 608.88}}};
    }
    input["weigh_in"] = weighIn;
    input["mass_changes_from"] = "typed";
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 6, "cutter_diameter_mm": 14, "minimum_wall_mm": 1.5,
        "minimum_bottom_mm": 2})");
    for (const QString& language : {u"en"_s, u"ru"_s}) {
        const QString text = cardText(input, language, 2).join(u' ').simplified();
        for (const QString& end :
             {language == u"ru"_s ? u"Метод пренебрегает"_s : u"Neglected by the method"_s,
              u"end1"_s, u"end2"_s, u"end3"_s, u"end4"_s, u"end5"_s,
              language == u"ru"_s ? u"608,88"_s : u"608.88"_s,
              language == u"ru"_s ? u"605,00"_s : u"605.00"_s,
              language == u"ru"_s ? u"7,77 !"_s : u"7.77 !"_s}) {
            EXPECT_TRUE(text.contains(end)) << qPrintable(end) << " in " << qPrintable(text);
        }
        // What to take off, of each of the six.
        EXPECT_GE(text.count(language == u"ru"_s ? u"снять"_s : u"take off"_s), 6);
        EXPECT_TRUE(text.contains(language == u"ru"_s ? u"Страница 2 из 2"_s : u"Page 2 of 2"_s));
    }
    compare(input, u"en"_s, 2);
}

TEST_F(JobCardTest, WarningsOfThePlugAreThereHoweverFullItIs) {
    Json input = workshopInput();
    Json weighIn = Json::object();
    for (const char* part : {"piston", "pin", "rings", "rod_big_end", "rod_small_end", "shells"}) {
        weighIn[part] = {
            {"nominal_g", 600},
            {"permitted_spread_g", 1},
            {"mass_g", {601.11, 602.22, 603.33, 604.44, 605.55, 606.66, 607.77, 608.88}}};
    }
    input["weigh_in"] = weighIn;
    input["mass_changes_from"] = "typed";
    input["job"]["notes"] = std::string(400, 'n');
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 14.5})");
    const QString text = cardText(input, u"en"_s, 2).join(u' ').simplified();
    EXPECT_TRUE(text.contains(u"there is no bottom"_s)) << qPrintable(text);
    EXPECT_TRUE(text.contains(u"cannot be made so"_s)) << qPrintable(text);
}

TEST_F(JobCardTest, NoTextIsDroppedHoweverMuchThereIsToSay) {
    Json input = workshopInput();
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 6, "cutter_diameter_mm": 14, "minimum_wall_mm": 1.5,
        "minimum_bottom_mm": 2})");
    input["balancing"]["front_bobweight_g"] = 1000;  // not the one that there is now
    for (const char* part : {"piston", "pin", "rings", "rod_big_end", "rod_small_end", "shells"}) {
        input["weigh_in"][part] = {{"nominal_g", 600},
                                   {"permitted_spread_g", 1},
                                   {"mass_g", {601, 602, 603, 604, 605, 606, 607, 608}}};
    }
    input["mass_changes_from"] = "typed";
    input["job"]["customer"] = std::string(300, 'c') + " end1";
    for (const QString& language : {u"en"_s, u"ru"_s}) {
        for (const int words : {1, 100, 2000}) {
            QString notes;
            for (int i = 0; i < words; ++i) {
                notes += u"note%1 "_s.arg(i);
            }
            input["job"]["notes"] = notes.toStdString();
            const int sheets = words == 2000 ? 3 : 2;
            const QString text = cardText(input, language, sheets).join(u' ').simplified();
            const Input read = v8_plugs::read_input(input, Completeness::as_is);
            const v8_plugs::Result solution = V8PlugsScene{.dated = false}.solve(read);
            QStringList said = notes.split(u' ', Qt::SkipEmptyParts);
            const Words in(language);
            said << v8_text::shiftText(in, read, solution) << v8_text::otherReadings(in, solution)
                 << v8_text::machineLimits(in, read, solution)
                 << v8_text::plugsWhileHung(in, solution)
                 << (language == u"ru"_s ? u"Примечания"_s : u"Notes"_s) << u"end1"_s;
            for (const QString& each : said) {
                EXPECT_TRUE(text.contains(each.simplified())) << qPrintable(each);
            }
            static const QRegularExpression cut(u"\\w…"_s);
            EXPECT_FALSE(cut.match(text).hasMatch());
        }
    }
}

TEST_F(JobCardTest, IsInTheUnitsChosen) {
    Json input = workshopInput();
    input["engine"].erase("name");
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 6, "cutter_diameter_mm": 14})");
    Preferences::instance().setUnits(Preferences::Mass, Preferences::Units::Imperial);
    Preferences::instance().setUnits(Preferences::Length, Preferences::Units::Imperial);
    const QString text = cardText(input, u"en"_s).join(u' ').simplified();
    test::Painted painted;
    test::Recorder recorder({2100, 2970}, painted);
    QPainter painter(&recorder);
    card(input, u"en"_s).paint(painter, {0, 0, 2100, 2970});
    painter.end();
    QSettings().clear();
    Preferences::instance().load();
    EXPECT_TRUE(text.contains(u"V-8 engine: other"_s)) << "as on the page";
    EXPECT_FALSE(text.contains(u"grams"_s));
    EXPECT_FALSE(text.contains(u"millimetres"_s));
    const QString depth = u"0.2959 in"_s;
    EXPECT_TRUE(text.contains(u"Bore 0.0597 in deeper with a cutter of 0.5512 in, to "_s + depth))
        << qPrintable(text);
    EXPECT_EQ(text.count(depth), 2) << "the same on the drawing";
    // The sizes of the drawing stand within the margin, and apart from its lines and each other.
    QVector<QRectF> sizes;
    for (const test::PaintedText& each : painted.texts) {
        const QString size = QString(each.text).replace(QChar(0x00A0), u' ');
        static const QRegularExpression inches(u"^⌀?0\\.\\d+ in$"_s);
        if (inches.match(size).hasMatch()) {
            EXPECT_LE(each.ink.right(), 1980.0) << qPrintable(size);
            for (const QRectF& other : sizes) {
                EXPECT_FALSE(other.intersects(each.ink)) << qPrintable(size);
            }
            for (const QPolygonF& line : painted.polygons) {
                const QRectF stroke = line.boundingRect();
                const bool isUpright = std::min(stroke.width(), stroke.height()) < 0.01;
                EXPECT_FALSE(isUpright &&
                             stroke.adjusted(-0.5, -0.5, 0.5, 0.5).intersects(each.ink))
                    << qPrintable(size);
            }
            sizes << each.ink;
        }
    }
    EXPECT_GE(sizes.size(), 5) << "height, bore, its depth, the new depth, the bottom";
    // The bottom is no size of the bore: it stands beside the section, under the depths.
    const auto placeOf = [&](const QString& size) {
        for (const test::PaintedText& each : painted.texts) {
            if (QString(each.text).replace(QChar(0x00A0), u' ') == size) {
                return each.ink;
            }
        }
        return QRectF();
    };
    EXPECT_GT(placeOf(u"0.2553 in"_s).left(), placeOf(u"⌀0.5512 in"_s).right());
    EXPECT_GT(placeOf(u"0.2553 in"_s).top(), placeOf(depth).bottom());
}

TEST_F(JobCardTest, SaysWhatMustNotBeOverlooked) {
    Json input = workshopInput();
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14})");
    const QString text = cardText(input, u"en"_s).join(u' ').simplified();
    EXPECT_TRUE(text.contains(u"Steel plug: solid it weighs 38.2"_s));
    EXPECT_TRUE(text.contains(u"Neglected by the method"_s));
}

TEST_F(JobCardTest, AnAnswerByTheMethodAloneIsNoFact) {
    Json input = exampleInput("v8-4.25-repair.case.json");
    input["engine"]["steel_plug_mass_g"] = 30;  // the shift of so heavy a plug is worth 49 g·mm
    input["engine"]["max_steel_reduction_g"] = 12;
    input["mass_changes_g"]["repair_piston_and_rings"] = 20;
    for (const bool bored : {false, true}) {
        if (bored) {
            input["plug"] =
                parse_json(R"({"thread": "M30x1.5", "height_mm": 14, "cutter_diameter_mm": 20})");
        }
        const Json result = commandLine(input);
        ASSERT_EQ(result.at("state"), "warning");
        const QStringList rows = cardText(input, u"en"_s);
        const QString text = rows.join(u' ').simplified();
        // What can be done is the headline, what the method would have the small print.
        const auto box = text.indexOf(bored ? u"Machine all 8 steel plugs by 8.51 g each."_s
                                            : u"Machine all 8 steel plugs by 8.92…9.10 g each."_s);
        EXPECT_GE(box, 0) << qPrintable(text);
        EXPECT_EQ(text.count(u"Machine all 8"_s), 1) << qPrintable(text);
        EXPECT_EQ(text.count(u"instead"_s), 0) << qPrintable(text);
        const QString neglects =
            u"By the method alone it would be 9.46 g each. The method neglects"_s;
        EXPECT_EQ(text.count(neglects), 1) << qPrintable(text);
        EXPECT_FALSE(text.contains(u"Neglected by the method"_s));
        EXPECT_GT(text.indexOf(neglects), box);
        EXPECT_LT(text.indexOf(neglects), text.indexOf(u"Options, in the order of cost"_s));
        EXPECT_FALSE(text.contains(u"balanced"_s));
        if (bored) {  // to 3.84 mm by the method alone: who bores is told the depth that is right
            EXPECT_EQ(text.count(u"3.84"_s), 0) << qPrintable(text);
            EXPECT_TRUE(text.contains(u"10.55"_s)) << qPrintable(text);  // 14 − 3.45 stay
            EXPECT_TRUE(text.contains(u"cutter of 20 mm to 3.45 mm from the face."_s))
                << qPrintable(text);
        }
        for (const QString& row : rows) {
            if (row.trimmed().startsWith(u"Machine today's steel plugs"_s)) {
                EXPECT_TRUE(row.trimmed().endsWith(u"check: see above"_s)) << qPrintable(row);
            }
        }
        compare(input, u"en"_s);
    }
}

TEST_F(JobCardTest, AFullCardWithAWarningKeepsTheNotes) {
    Json input = exampleInput("v8-4.25-repair.case.json");
    input["engine"]["steel_plug_mass_g"] = 30;
    input["engine"]["max_steel_reduction_g"] = 12;
    input["mass_changes_g"]["repair_piston_and_rings"] = 20;
    input["plug"] =
        parse_json(R"({"thread": "M30x1.5", "height_mm": 14, "cutter_diameter_mm": 20})");
    for (const char* part : {"piston", "pin", "rings", "rod_big_end", "rod_small_end", "shells"}) {
        input["weigh_in"][part] = {{"nominal_g", 600},
                                   {"permitted_spread_g", 1},
                                   {"mass_g", {601, 602, 603, 604, 605, 606, 607, 608}}};
    }
    input["mass_changes_from"] = "typed";
    input["job"]["notes"] = "Oversize pistons end5";
    for (const QString& language : {u"en"_s, u"ru"_s}) {
        const QString text = cardText(input, language, 2).join(u' ').simplified();
        EXPECT_TRUE(text.contains(u"end5"_s)) << qPrintable(language) << qPrintable(text);
    }
}

TEST_F(JobCardTest, HalfFilledJobSaysWhatIsMissing) {
    Json input = {{"engine", "8.32 l"}, {"process", "repair"}};
    const QString text = cardText(input, u"en"_s).join(u' ').simplified();
    EXPECT_TRUE(text.contains(u"The data are not complete"_s));
    EXPECT_TRUE(text.contains(u"Not known without:"_s));
    EXPECT_FALSE(text.contains(u"nan"_s));
}

TEST_F(JobCardTest, AFileThatCannotBeWrittenIsSaid) {
    const QString trouble = card(workshopInput(), u"en"_s).writePdf(path(u"nowhere/card.pdf"_s));
    EXPECT_TRUE(trouble.contains(u"nowhere/card.pdf"_s));
}

}  // namespace
}  // namespace ravnoves
