// Reports of cases, read by other programs: the text of the PDF, its pictures, the HTML as XML.

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <filesystem>

#include "case-file/json.h"
#include "events.h"
#include "examples.h"
#include "files.h"
#include "model/background_job.h"
#include "model/case_document.h"
#include "page/scene_page.h"
#include "painted.h"
#include "paper/paper.h"
#include "pictures/figure.h"
#include "pictures/file_dialogs.h"
#include "plot/plot_view.h"
#include "processor_time.h"
#include "report/case_report.h"
#include "report/figure_drawings.h"
#include "report/report_dialog.h"
#include "report/sections.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "studies/tolerance_bands.h"
#include "text/language.h"
#include "text/message_text.h"
#include "widgets/result_table.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// What a program of the machine says of a file.
QString said(const char* program, const QStringList& arguments) {
    QProcess process;
    process.start(QString::fromLatin1(program), arguments);
    EXPECT_TRUE(process.waitForFinished(60'000)) << program;
    EXPECT_EQ(process.exitCode(), 0) << program;
    return QString::fromUtf8(process.readAllStandardOutput());
}

/// All that is no letter between letters is a matter of line breaks.
QString squeezed(QString text) {
    static const QRegularExpression blanks(u"[\\s\u00a0\u202f]+"_s,
                                           QRegularExpression::UseUnicodePropertiesOption);
    return text.remove(blanks);
}

QString fileText(const QString& path) {
    return QString::fromUtf8(test::contentOf(path));
}

/// The text of an HTML file that is well-formed; what it refers to.
QString htmlText(const QString& path, QStringList& references) {
    QXmlStreamReader xml(fileText(path));
    QString text;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isCharacters()) {
            text += xml.text().toString() + u' ';
        }
        for (const QXmlStreamAttribute& attribute : xml.attributes()) {
            const QStringView name = attribute.name();
            if (name == u"src" || name == u"href" || name == u"data") {
                references << attribute.value().toString();
            }
        }
    }
    EXPECT_FALSE(xml.hasError()) << path.toStdString() << ": " << xml.errorString().toStdString()
                                 << " in line " << xml.lineNumber();
    return text;
}

/// A row of zeros and dashes, which no report has.
bool isBlank(const ResultTable& table, int row) {
    static const QRegularExpression something(u"[1-9]|\\w{2}"_s,
                                              QRegularExpression::UseUnicodePropertiesOption);
    for (int column = 1; column < table.columnCount(); ++column) {
        const QTableWidgetItem* cell = table.item(row, column);
        if (cell != nullptr && cell->text().contains(something)) {
            return false;
        }
    }
    return true;
}

class ReportTest : public ::testing::TestWithParam<std::string> {
  protected:
    ReportTest() {
        installLanguage(QString::fromStdString(GetParam()));
        window = std::make_unique<MainWindow>();
        test::showAt(*window, {1280, 800});
    }
    ~ReportTest() override {
        window.reset();
        installLanguage(u"en"_s);
    }

    QString file(const QString& name) const { return folder.filePath(name); }

    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
};

TEST_P(ReportTest, HoldsTitleInputsAndEveryResultOfEveryExample) {
    for (const auto& example : test::example_files()) {
        const QString path = QString::fromStdString(example.string());
        SCOPED_TRACE(path.toStdString());
        ASSERT_EQ(window->openCase(path), QString());
        ScenePage* page = window->currentPage();
        const QString pdf = file(u"report.pdf"_s);
        const QString html = file(u"report.html"_s);
        ASSERT_EQ(window->writeReport(pdf), QString());
        ASSERT_EQ(window->writeReport(html), QString());

        const QString onPaper = squeezed(said(RAVNOVES_PDFTOTEXT, {u"-layout"_s, pdf, u"-"_s}));
        QStringList references;
        const QString onScreen = squeezed(htmlText(html, references));
        for (const QString& each : references) {
            EXPECT_TRUE(each.startsWith(u"data:"_s) || each.startsWith(u'#'))
                << each.left(60).toStdString();
        }
        EXPECT_TRUE(onPaper.contains(squeezed(page->model()->title()).left(40)));
        EXPECT_TRUE(onScreen.contains(squeezed(page->model()->title())));
        EXPECT_TRUE(onPaper.contains(QStringLiteral("Ravnoves" RAVNOVES_VERSION)));
        // Every value of the tables that the page shows.
        int values = 0;
        page->resultsAsText();
        for (const ResultTable* table : page->findChildren<ResultTable*>()) {
            for (int row = 0; row < table->rowCount() && !table->isHidden(); ++row) {
                if (isBlank(*table, row)) {
                    continue;
                }
                for (int column = 0; column < table->columnCount(); ++column) {
                    const QTableWidgetItem* cell = table->item(row, column);
                    if (cell != nullptr && cell->text().contains(QRegularExpression(u"\\d"_s))) {
                        const QString text = squeezed(cell->text());
                        ++values;
                        EXPECT_TRUE(onScreen.contains(text)) << text.toStdString();
                        // Words that wrap are not looked for on paper.
                        if (!cell->text().contains(u' ')) {
                            EXPECT_TRUE(onPaper.contains(text)) << text.toStdString();
                        }
                    }
                }
            }
        }
        EXPECT_GT(values, 1);
        // What no cylinder gives is assumed once for all.
        const QVector<QStringList> assumed = leftOut(*page->model()).rows;
        EXPECT_EQ(QSet(assumed.begin(), assumed.end()).size(), assumed.size());
        // Inputs with their units, and the theory.
        const bool russian = GetParam() == "ru";
        const QString unit =
            path.contains(u"v8"_s) ? (russian ? u"г"_s : u"g"_s) : (russian ? u"мм"_s : u"mm"_s);
        EXPECT_TRUE(onPaper.contains(unit));
        EXPECT_TRUE(fileText(html).contains(
            u"<html lang=\"%1\">"_s.arg(QString::fromStdString(GetParam()))));
        EXPECT_FALSE(fileText(html).contains(u"<script"_s));
        // Powers of ten as science writes them, no share of nothing, units in the language.
        static const QRegularExpression raw(u"\\d[.,]\\d+[eE][-−+]?\\d|−\\d{4,}%"_s);
        EXPECT_FALSE(onScreen.contains(raw)) << raw.match(onScreen).captured().toStdString();
        EXPECT_FALSE(russian && fileText(html).contains(u"kg/m<sup>"_s));
        EXPECT_GE(fileText(html).count(u"<svg "_s), 1);
        // The map of the balance shaft's places is a picture of numbers by its nature.
        const QString list = said(RAVNOVES_PDFIMAGES, {u"-list"_s, pdf});
        EXPECT_FALSE(list.contains(u"jpeg"_s)) << list.toStdString();
        const bool map = window->currentScene() == u"balance-shaft"_s;
        EXPECT_LE(list.count(u'\n') - 2, map ? 2 : 0);
        const QString fonts = said(RAVNOVES_PDFFONTS, {pdf});
        EXPECT_GT(fonts.count(u"DejaVu"_s), 0);
        EXPECT_TRUE(fonts.contains(u"yes"_s));  // embedded
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, ReportTest, ::testing::Values("en", "ru"),
                         [](const auto& info) { return info.param; });

class ReportInWindow : public ::testing::Test {
  protected:
    ReportInWindow() { test::showAt(window, {1280, 800}); }
    QString example() const { return QStringLiteral(RAVNOVES_EXAMPLES "/tmz-650d.case.json"); }
    QString file(const QString& name) const { return folder.filePath(name); }
    /// The present case's report as HTML.
    QString report() {
        const QString html = file(u"report.html"_s);
        EXPECT_EQ(window.writeReport(html), QString());
        return fileText(html);
    }

    QTemporaryDir folder;
    MainWindow window;
};

TEST(ReportTable, HasAUnitBesideItsNumber) {
    const Results results{{u"Quantity"_s, u"Value"_s, u"Unit"_s},
                          {{{u"Speed"_s, ResultCell(5.0, u"5.0"_s), u"min⁻¹"_s}, {}}}};
    EXPECT_EQ(paper::tableOf(results).numbers, (QVector<bool>{false, true, false}));
}

TEST_F(ReportInWindow, PrintsTheTableOfTheTorqueAndNothingOfAnEmptyFieldBesideAValue) {
    ASSERT_EQ(window.openCase(example()), QString());
    SceneModel& model = *window.currentPage()->model();
    model.setByKey(u"cylinder/bore_mm"_s, u"95.5"_s);
    model.setByKey(u"counterweight_mass_kg"_s, u"0.7"_s);
    const QString text = report();
    EXPECT_TRUE(text.contains(u"95.5"_s));
    EXPECT_FALSE(text.contains(u">Empty"_s));
    for (const char* cells : {"<td class=\"number\">360</td><td class=\"number\">0</td>",
                              "<td class=\"number\">375</td><td class=\"number\">893</td>",
                              "<td class=\"number\">720</td><td class=\"number\">0</td>"}) {
        EXPECT_TRUE(text.contains(QLatin1String(cells))) << cells;
    }
}

TEST_F(ReportInWindow, PrintsARunOfTheMachineReadingByReading) {
    Json json = Json::parse(
        fileText(QStringLiteral(RAVNOVES_EXAMPLES "/bob-weights-v8.case.json")).toStdString());
    Json& correction = json["input"]["correction"];
    const auto reading = [](double unbalance, double angle) {
        return Json{{"unbalance_g_mm", unbalance}, {"angle_deg", angle}, {"bobweight_g", 1505.25}};
    };
    correction["earlier_runs"] = {{{"readings", {reading(411, 31.5), reading(622, 275)}}},
                                  {{"readings", {reading(133, 42), reading(144, 0)}}}};
    correction["earlier_runs"][1]["readings"][1].erase("bobweight_g");
    correction["earlier_runs"][1]["drilled"] = {{{"plane", "rear"},
                                                 {"diameter_mm", 12.5},
                                                 {"depth_mm", 11.25},
                                                 {"angle_deg", 66},
                                                 {"removed_g", 17.5}}};
    const QString path = file(u"runs.case.json"_s);
    test::writeFile(path, QByteArray::fromStdString(json.dump()));
    ASSERT_EQ(window.openCase(path), QString());
    const QString text = report();
    EXPECT_FALSE(text.contains(u"bobweight_g"_s));
    const auto number = [](const char* shown) {
        return u"<td class=\"number\">%1</td>"_s.arg(QLatin1String(shown));
    };
    const std::vector<std::vector<const char*>> lines{{"1.1", "411", "31.5", "1505.25"},
                                                      {"1.2", "622", "275", "1505.25"},
                                                      {"2.1", "133", "42", "1505.25"},
                                                      {"2.2", "144", "0", ""}};
    for (const auto& line : lines) {
        QString cells = u"<td>%1</td>"_s.arg(QLatin1String(line[0]));
        for (std::size_t i = 1; i < line.size(); ++i) {
            cells += number(line[i]);
        }
        EXPECT_TRUE(text.contains(cells)) << cells.toStdString();
    }
    EXPECT_FALSE(text.contains(u"diameter_mm"_s));
    EXPECT_TRUE(text.contains(u"<td>2.1</td>"_s + number("Rear") + number("12.5") +
                              number("11.25") + number("66") + number("17.5")))
        << "what was drilled after it is a table of its own";
    EXPECT_TRUE(text.contains(u"Rear plane: ⌀ 12.5\u00A0mm"_s)) << "and among the results";
}

TEST_F(ReportInWindow, CanBeCancelledAndLeavesNothing) {
    ASSERT_EQ(window.openCase(example()), QString());
    for (const int turns : {0, 7, 12}) {
        int left = turns;
        const QString html = file(u"cancelled.html"_s);
        EXPECT_NE(window.writeReport(html, Patience([&left] { return left-- == 0; })), QString());
        EXPECT_LT(left, 0);
        EXPECT_FALSE(QFile::exists(html));
    }
}

TEST_F(ReportInWindow, SolvesTheSamplesOfAllTabsOnce) {
    ASSERT_EQ(window.openCase(example()), QString());
    ScenePage* page = window.currentPage();
    ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
    const Json study = {{"vary", {{"/centre_distance_mm", {{"plus_minus", 2}}}}},
                        {"watch", Json::object()},
                        {"method", "sobol"},
                        {"samples", 64}};
    page->model()->changeStudy(u"tolerances"_s, study.dump());
    auto* bands = page->findChild<ToleranceBands*>();
    ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
    const QSignalSpy runs(bands->job(), &BackgroundJob::finished);
    ASSERT_EQ(window.writeReport(file(u"a.html"_s)), QString());
    EXPECT_EQ(runs.count(), 1);
    int spread = 0;
    for (const PlotView* plot : page->findChildren<PlotView*>()) {
        spread += !plot->isVisible() && plot->data().curves.size() > 1 &&
                          plot->data().curve(1).hasSpread()
                      ? 1
                      : 0;
    }
    EXPECT_GT(spread, 1);  // on other tabs
    QApplication::processEvents();
    EXPECT_FALSE(page->isBusy());
}

TEST_F(ReportInWindow, TheLettersOfPicturesAreAtLeastSixPoints) {
    int letters = 0;
    for (const QString& scene : {u"balance-shaft"_s, u"elastic-hinge"_s, u"inertia-moments"_s}) {
        ASSERT_TRUE(window.newCase(scene));
        for (QWidget* figure : window.currentPage()->findChildren<QWidget*>()) {
            if (!isFigure(figure) || qobject_cast<PlotView*>(figure) != nullptr) {
                continue;
            }
            const paper::Drawing drawing = drawingOf(figure);
            QPicture picture;
            QPainter painter(&picture);
            drawing.draw(painter);
            painter.end();
            for (const test::PaintedText& text : test::painted(picture, drawing.size).texts) {
                ++letters;
                EXPECT_GE(text.pixelSize, 8) << qPrintable(text.text + u" of "_s + drawing.caption);
            }
        }
    }
    EXPECT_GT(letters, 10);
}

TEST_F(ReportInWindow, SpeaksOfTheFileThatWasOpened) {
    const QString path = file(u"own.case.json"_s);
    ASSERT_TRUE(QFile::copy(example(), path));
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    ASSERT_EQ(window.openCase(path), QString());
    const auto sumOf = [](const QString& text) {
        return QString::fromLatin1(
            QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha256).toHex());
    };
    const QString opened = sumOf(fileText(path));
    EXPECT_TRUE(report().contains(u"own.case.json"_s));
    QFile other(path);
    ASSERT_TRUE(other.open(QIODevice::Append));
    other.write("\n");
    other.close();
    const QString changed = report();
    EXPECT_TRUE(changed.contains(opened));
    EXPECT_FALSE(changed.contains(sumOf(fileText(path))));
    EXPECT_TRUE(changed.contains(u"the file has changed"_s));
    // What is not saved yet has the sum of what would be saved.
    window.currentPage()->model()->setByKey(u"shaft_angle_deg"_s, u"50"_s);
    const QString unsaved = report();
    EXPECT_FALSE(unsaved.contains(opened));
    EXPECT_TRUE(unsaved.contains(u"not saved"_s));
    ASSERT_EQ(window.documents().current().document->saveTo(path), QString());
    EXPECT_TRUE(unsaved.contains(sumOf(fileText(path))));
}

TEST_F(ReportInWindow, WritesOverNoCaseAndOverNothingThatOneReads) {
    const QString path = file(u"self.html"_s);
    const QString table = file(u"torque.html"_s);
    Json json = Json::parse(fileText(example()).toStdString());
    test::writeFile(table, "0;1\n360;3\n720;1\n");
    json["input"]["torque"] = Json{{"csv", "torque.html"}};
    test::writeFile(path, QByteArray::fromStdString(json.dump()));
    const QString before = fileText(path) + fileText(table);
    const QString trouble = window.openCase(path);
    ASSERT_EQ(trouble, QString());
    const QString soft = file(u"soft.html"_s);
    const QString hard = file(u"hard.pdf"_s);
    ASSERT_TRUE(QFile::link(path, soft));
    std::filesystem::create_hard_link(table.toStdString(), hard.toStdString());
    for (const QString& each : {path, table, soft, hard}) {
        const QString why = window.writeReport(each);
        EXPECT_TRUE(why.contains(each)) << each.toStdString();
        EXPECT_TRUE(why.contains(u"open case"_s)) << why.toStdString();
    }
    EXPECT_EQ(fileText(path) + fileText(table), before);
}

TEST_F(ReportInWindow, HasTheAnswerAndTheVariantsFirst) {
    ASSERT_EQ(window.openCase(example()), QString());
    SceneModel* model = window.currentPage()->model();
    model->keepVariant(u"As drawn"_s);
    model->setByKey(u"shaft_angle_deg"_s, u"60"_s);
    model->keepVariant(u"turned"_s);
    model->chooseReference(0);
    model->setByKey(u"shaft_angle_deg"_s, u"51.25"_s);
    const QString pdf = file(u"report.pdf"_s);
    ASSERT_EQ(window.writeReport(pdf), QString());
    const QStringList pages =
        said(RAVNOVES_PDFTOTEXT, {u"-layout"_s, pdf, u"-"_s}).split(u'\f', Qt::SkipEmptyParts);
    const QString front = pages.constFirst().simplified();
    for (const QString& each :
         {u"Shaft angle 51.25°"_s, u"Centre distance l 100.15"_s, u"Counterweight radius ρ₁ 46"_s,
          messageText(model->verdictShown()->text).left(40), u"Variants"_s,
          u"As drawn (reference)"_s, u"turned"_s, u"51.25 (+6.25)"_s}) {
        // "fi" is one letter on paper.
        EXPECT_TRUE(squeezed(front)
                        .normalized(QString::NormalizationForm_KC)
                        .contains(squeezed(each).normalized(QString::NormalizationForm_KC)))
            << each.toStdString();
    }
    // What is equal in all of them is left out; the best is marked of those without a warning.
    const QString all = pages.join(u' ');
    EXPECT_EQ(all.count(u'★'), 1) << "the legend: the torque fits neither";
    EXPECT_FALSE(all.contains(u"range · Mᵤₚ, "_s));
    EXPECT_TRUE(all.contains(u"range · Mᵤₚₛ, "_s));
    EXPECT_FALSE(all.contains(u"Δ 0"_s));
    EXPECT_TRUE(all.simplified().contains(u"curves of As drawn are dimmed"_s));
}

TEST_F(ReportInWindow, SaysOfWhichVariantsAFileHasChanged) {
    Json json = Json::parse(fileText(example()).toStdString());
    Json variant = json["input"];
    variant["torque"] = Json{{"csv", "ind.csv"}, {"csv_sha256", std::string(64, '0')}};
    json["variants"] = Json::array({Json{{"name", "C"}, {"input", variant}}});
    const auto write = [&](const QString& name, const std::string& text) {
        test::writeFile(file(name), QByteArray::fromStdString(text));
    };
    write(u"ind.csv"_s, "0;1\n360;3\n720;1\n");
    write(u"x.case.json"_s, json.dump());
    ASSERT_EQ(window.openCase(file(u"x.case.json"_s)), QString());
    EXPECT_TRUE(report().contains(u"C: ind.csv has changed since"_s));
}

TEST_F(ReportInWindow, ALongTitleIsCut) {
    ASSERT_EQ(window.openCase(example()), QString());
    window.currentPage()->model()->setTitle(QString(1'000'000, u'W'));
    const test::ProcessorTime time;
    EXPECT_EQ(window.writeReport(file(u"report.pdf"_s)), QString());
    EXPECT_LT(time.seconds(), 5.0);
}

TEST_F(ReportInWindow, TheMenuAsksWhereAndAddsTheSuffix) {
    ASSERT_EQ(window.openCase(example()), QString());
    QString filters;
    const auto before = fileChoosers();
    fileChoosers().save = [&](QWidget*, const QString&, const QString& suggestion,
                              const QString& offered, QString* filter) {
        EXPECT_TRUE(suggestion.contains(u"/tmz-650d"_s)) << suggestion.toStdString();
        filters = offered;
        *filter = offered.split(u";;"_s).constLast();
        return file(u"handed-over"_s);
    };
    test::whenModal<ReportDialog>(&window, [](ReportDialog* dialog) {
        test::named<QCheckBox>(*dialog, "report_formulas")->setChecked(false);
        dialog->accept();
    });
    QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier);
    fileChoosers() = before;
    EXPECT_TRUE(filters.contains(u"*.pdf"_s));
    EXPECT_TRUE(QFile::exists(file(u"handed-over.html"_s)));
    // What was not wanted is left out, of the next report too.
    EXPECT_FALSE(fileText(file(u"handed-over.html"_s)).contains(u">Formulas<"_s));
    EXPECT_FALSE(ReportChoice().formulas);
    QSettings().remove(u"report"_s);
}

/// The program's own word: status and standard error.
std::pair<int, QString> run(const QStringList& arguments, const QString& output = {}) {
    QProcess process;
    if (!output.isEmpty()) {
        process.setStandardOutputFile(output);
    }
    const QTemporaryDir runtime;  // or Qt tells where it takes one
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"XDG_RUNTIME_DIR"_s, runtime.path());
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RAVNOVES_PROGRAM), arguments);
    EXPECT_TRUE(process.waitForFinished(120'000));
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardError())};
}

TEST_F(ReportInWindow, TheProgramWritesItWithoutAWindow) {
    const QString pdf = file(u"report.pdf"_s);
    const auto [status, error] = run({u"--report"_s, pdf, u"--case"_s, example(), u"--set"_s,
                                      u"shaft_angle_deg=123.4"_s, u"--language"_s, u"ru"_s});
    EXPECT_EQ(status, 0) << error.toStdString();
    EXPECT_EQ(error, QString());
    const QString text = said(RAVNOVES_PDFTOTEXT, {pdf, u"-"_s});
    EXPECT_TRUE(text.contains(u"123,4"_s));
    EXPECT_TRUE(text.contains(u"мм"_s));
}

TEST_F(ReportInWindow, TheProgramSaysWhyItWritesNone) {
    const auto rejected = [&](const QStringList& arguments, const QString& word) {
        const auto [status, error] = run(arguments);
        EXPECT_EQ(status, 2) << arguments.join(u' ').toStdString();
        EXPECT_TRUE(error.contains(word)) << error.toStdString();
        EXPECT_EQ(error.count(u'\n'), 1) << error.toStdString();
    };
    rejected({u"--report"_s, file(u"a.txt"_s), u"--case"_s, example()}, u".pdf or .html"_s);
    rejected({u"--report"_s, file(u"a.pdf"_s)}, u"--case"_s);
    rejected({u"--screenshot"_s, file(u"a.case.json"_s), u"--case"_s, example()}, u".png"_s);
    rejected({u"--report"_s, file(u"a.pdf"_s), u"--case"_s, file(u"none.json"_s)}, u"none.json"_s);
    rejected({u"--report"_s, u"/proc/a.pdf"_s, u"--case"_s, example()}, u"/proc/a.pdf"_s);
    if (QFile::exists(u"/dev/full"_s)) {
        QFile::link(u"/dev/full"_s, file(u"full.pdf"_s));
        rejected({u"--report"_s, file(u"full.pdf"_s), u"--case"_s, example()}, u"full.pdf"_s);
        QFile::remove(file(u"full.pdf"_s));
        for (const QString& asked : {u"--help"_s, u"--version"_s}) {
            const auto [status, error] = run({asked}, u"/dev/full"_s);
            EXPECT_EQ(status, 2) << asked.toStdString();
            EXPECT_TRUE(error.contains(u"cannot be written"_s)) << error.toStdString();
            EXPECT_EQ(run({asked}).first, 0) << asked.toStdString();
        }
    }
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

/// The text of its pages.
QStringList pagesOf(Paper report, QPageSize::PageSizeId size = QPageSize::A4) {
    report.pageOf = u"Page %1 of %2"_s;
    QTemporaryDir folder;
    const QString path = folder.filePath(u"report.pdf"_s);
    test::writeFile(path, paperAsPdf(report, QPageSize(size)));
    return said(RAVNOVES_PDFTOTEXT, {path, u"-"_s}).split(u'\f', Qt::SkipEmptyParts);
}

TEST(ReportPages, WhatIsSaidBeforeAFigureStaysWithIt) {
    for (int height = 300; height < 900; height += 100) {
        Paper report;
        const auto draw = [](QPainter& painter) { painter.drawText(20, 30, u"DRAWN"_s); };
        report.body = report.figure({{}, u"space"_s, {400, height}, [](QPainter&) {}}) +
                      paper::heading(u"HEADING"_s, 2) +
                      paper::paragraph(u"WORDS"_s, paper::Tone::Muted) +
                      report.figure({{}, u"a figure"_s, {400, 400}, draw});
        bool isSeen = false;
        for (const QString& page : pagesOf(report)) {
            isSeen = isSeen || page.contains(u"DRAWN"_s);
            EXPECT_EQ(page.contains(u"HEADING"_s), page.contains(u"DRAWN"_s)) << height;
            EXPECT_EQ(page.contains(u"WORDS"_s), page.contains(u"DRAWN"_s)) << height;
        }
        EXPECT_TRUE(isSeen) << height;
    }
}

TEST(ReportPages, LetterHasPagesOfItsOwn) {
    Paper report;
    for (int i = 0; i < 200; ++i) {
        report.say(u"a line"_s);
    }
    const auto lines = [&](QPageSize::PageSizeId size) {
        return pagesOf(report, size).front().count(u"a line"_s);
    };
    EXPECT_LT(lines(QPageSize::Letter), lines(QPageSize::A4));
}

TEST(ReportPages, RowsStayWholeAndHeadsReturn) {
    Paper report;
    paper::Table table;
    table.headings = {u"HEAD"_s, u"second"_s};
    for (int i = 0; i < 120; ++i) {
        table.rows << QStringList{
            u"begin%1 and words that go on and on until the cell needs more "
            "than one line, and then still go on for another while end%1"_s.arg(i),
            u"a longer text, so that both columns have to share, value%1"_s.arg(i)};
    }
    report.body = paper::table(table);
    const QStringList pages = pagesOf(report);
    ASSERT_GT(pages.size(), 2);
    int rows = 0;
    for (const QString& page : pages) {
        EXPECT_EQ(page.count(u"HEAD"_s), 1);
        EXPECT_EQ(page.count(QRegularExpression(u"begin\\d"_s)),
                  page.count(QRegularExpression(u"end\\d"_s)));
        rows += static_cast<int>(page.count(QRegularExpression(u"begin\\d"_s)));
    }
    EXPECT_EQ(rows, 120);
    EXPECT_TRUE(pages.constLast().contains(u"Page %1 of %1"_s.arg(pages.size())));
}

}  // namespace
}  // namespace ravnoves
