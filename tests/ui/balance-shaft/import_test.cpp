// Measured files on their way into a case: the model of the import window, and the window itself.

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <algorithm>

#include "../../core/balance-shaft/synthetic_engine.h"
#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/import_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "case-file/decimal.h"
#include "case-file/text_file.h"
#include "import_file.h"
#include "model/background_job.h"
#include "page_fixture.h"
#include "pictures/file_dialogs.h"

namespace ravnoves {
namespace {

using balance_shaft::Measured;
using balance_shaft::TableReading;

constexpr double late = 1.3;  // °, of the dead centre in the file below

/// 13 columns with semicolons and decimal commas, −360…360, gauge pressure in the fifth.
std::string indicatorFile(const balance_shaft::test::SyntheticEngine& engine) {
    constexpr double step = 0.5;
    const auto pressure = engine.pressure(step);
    std::string text = "Indicated pressure;engine no. 7\n\ntime;crank angle";
    for (int column = 2; column < 13; ++column) {
        text += column == 4 ? ";p cyl 1 (g)" : ";channel " + std::to_string(column);
    }
    text += "\ns;deg;V;V;bar;V;V;V;V;V;V;V;V\n";
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const double place = static_cast<double>(i);
        std::string line =
            fixed_decimals(1e-4 * place, 4) + ";" + fixed_decimals(-360.0 + late + step * place, 1);
        for (int column = 2; column < 13; ++column) {
            line += ";" + fixed_decimals(column == 4 ? (pressure[i] - 101325.0) / 1e5
                                                     : 20.0 + std::sin(0.01 * place * column),
                                         5);
        }
        std::replace(line.begin(), line.end(), '.', ',');
        text += line + "\n";
    }
    return text;
}

class ImportTest : public test::PageTest<BalanceShaftPage> {
  protected:
    QString file(const std::string& text, const char* name = "trace.csv") const {
        const QString path = folder.filePath(QLatin1String(name));
        write_text_file(path.toStdString(), text);
        return path;
    }
    bool isRead() const {
        return test::comes([this] { return !import.job()->isRunning(); });
    }
    bool read(const QString& path) {
        import.open(path);
        return isRead();
    }
    /// The case as it is, saved beside the file and opened again.
    balance_shaft::Input reopened() const {
        Json input = model->inputJson();
        Json& csv = input["torque"]["pressure"]["csv"];
        csv = QFileInfo(QString::fromStdString(csv.get<std::string>())).fileName().toStdString();
        BalanceShaftModel other;
        other.loadCase(input, CaseContext{folder.path().toStdString()}, {});
        return other.input();
    }

    const QTemporaryDir folder;
    const balance_shaft::test::SyntheticEngine engine =
        balance_shaft::test::synthetic_engines().front();
    ImportModel import{Measured::pressure, engine.crank, 4};
    TorqueSourceEditor* source = page.findChild<TorqueSourceEditor*>();
};

TEST_F(ImportTest, AFileOfThirteenColumnsIsProposedWhole) {
    ASSERT_TRUE(read(file(indicatorFile(engine))));
    ASSERT_TRUE(import.isReady()) << qPrintable(import.troubleText());
    EXPECT_EQ(import.column(0), 1);
    EXPECT_EQ(import.column(1), 4);
    EXPECT_EQ(import.columns(), 13);
    EXPECT_EQ(import.headerLines(), 3);  // an empty one is none
    EXPECT_EQ(import.heading(1), QStringLiteral("crank angle deg"));
    EXPECT_EQ(import.reading().layout.separator, ';');
    EXPECT_EQ(import.decimalComma(), true);
    EXPECT_EQ(import.reading().unit, units::bar);
    EXPECT_EQ(import.reading().gauge, true);
    EXPECT_EQ(import.reading().strokes, 4);
    EXPECT_EQ(import.lines()[0][0], "Indicated pressure");
    EXPECT_EQ(import.doubtsText(), QString());
    EXPECT_TRUE(import.understoodText().contains(QStringLiteral("gauge pressure in bar")));

    // The firing dead centre, at 0° and somewhat late, is at 360° of a case.
    EXPECT_TRUE(import.deadCentreText().startsWith(QStringLiteral("Dead centre: shift by 35")))
        << qPrintable(import.deadCentreText());
    EXPECT_TRUE(import.isShifted());
    balance_shaft::Input input = model->input();
    import.putTraceInto(input);
    EXPECT_NEAR(input.torque.trace_shift / degree, 360.0 - late, 0.5);
    import.setShifted(false);
    import.putTraceInto(input);
    EXPECT_EQ(input.torque.trace_shift, 0.0);
    EXPECT_FALSE(import.needsOwnFile());
    EXPECT_EQ(input.torque.trace_file.reading.columns[1], "5");
}

TEST_F(ImportTest, ANegativePressureIsAskedAbout) {
    ASSERT_TRUE(read(file("deg;p\n0;-0.113\n90;0.02\n180;0.1\n360;40\n540;3\n720;-0.113\n")));
    EXPECT_TRUE(import.doubtsText().contains(QStringLiteral("gauge pressure?")))
        << qPrintable(import.doubtsText());
    EXPECT_TRUE(import.isReady());
    TableReading decided = import.decided();
    decided.gauge = false;
    import.decide(decided);
    EXPECT_FALSE(import.isReady());
    ASSERT_TRUE(isRead());
    EXPECT_FALSE(import.isReady());
    EXPECT_TRUE(import.troubleText().contains(QStringLiteral("line 2, column 2")))
        << qPrintable(import.troubleText());
}

// What is typed of the engine does not change in silence.
TEST_F(ImportTest, ACycleOfAnotherEngineIsAskedAbout) {
    const char* const rows[] = {"deg;bar\n0;1\n90;2\n180;40\n270;3\n360;1\n",
                                "deg;bar\n0;1\n180;2\n360;40\n540;3\n720;1\n"};
    for (const int strokes : {4, 2}) {
        const QString path = file(rows[strokes == 4 ? 0 : 1]);
        ImportModel of(Measured::pressure, engine.crank, strokes);
        of.open(path);
        const auto read = [&] { return test::comes([&] { return !of.job()->isRunning(); }); };
        ASSERT_TRUE(read());
        const auto names = [&](const char* text) {
            return of.doubtsText().contains(QString::fromUtf8(text));
        };
        EXPECT_FALSE(of.isReady());
        EXPECT_TRUE(names("360°") && names("720°") && names("four-stroke") && names("two-stroke"))
            << qPrintable(of.doubtsText());
        for (const int decided : {strokes, 6 - strokes}) {
            TableReading reading;
            reading.strokes = decided;
            of.decide(reading);
            ASSERT_TRUE(read());
            EXPECT_EQ(of.isReady(), decided != strokes);
        }
        EXPECT_EQ(of.doubtsText(), QString());
    }
    ASSERT_EQ(model->input().strokes, 4);
    const QString path = file(rows[0]);
    const auto imported = [&](bool isChosen) {
        test::importBy(
            page, [&] { source->importTrace(path); },
            [&](ImportDialog& dialog) {
                const auto* cycle = test::named<QComboBox>(dialog, "import_cycle");
                EXPECT_EQ(cycle->currentIndex(), -1);
                EXPECT_EQ(cycle->placeholderText(), QStringLiteral("choose"));
                if (isChosen) {
                    test::chooseCycle(dialog, 2);
                    EXPECT_EQ(cycle->currentText(), QStringLiteral("360° (two-stroke)"));
                }
            });
        return model->input().strokes;
    };
    EXPECT_EQ(imported(false), 4);
    EXPECT_NE(model->input().torque.kind, balance_shaft::TorqueSource::Kind::pressure);
    EXPECT_EQ(imported(true), 2);
}

TEST_F(ImportTest, SettingsThatACaseCannotHoldMakeAFileOfTheCycle) {
    ASSERT_TRUE(read(file("deg;bar\n0;1,013\n180;1\n360;40,125\n540;3,250\n720;1,013\n")));
    EXPECT_FALSE(import.isReady());  // thousands or decimals?
    EXPECT_FALSE(import.decimalComma());
    EXPECT_EQ(import.lines().size(), 6U);
    TableReading decided;
    decided.layout.decimal_comma = true;
    import.decide(decided);
    ASSERT_TRUE(isRead());
    ASSERT_TRUE(import.isReady()) << qPrintable(import.troubleText());
    EXPECT_TRUE(import.needsOwnFile());
    EXPECT_TRUE(import.doubtsText().contains(QStringLiteral("separate CSV file")));
    EXPECT_FALSE(import.writeOwnFile(QStringLiteral("/dev/null/cycle.csv")).isEmpty());
    EXPECT_EQ(import.writeOwnFile(folder.filePath(QStringLiteral("cycle.csv"))), QString());
    model->edit(QStringLiteral("Trace"),
                [&](balance_shaft::Input& input) { import.putTraceInto(input); });
    EXPECT_EQ(model->input().torque.trace.pressure.at(2), 40.125e5);
    EXPECT_EQ(reopened().torque.trace, model->input().torque.trace);
    EXPECT_FALSE(reopened().torque.has_changed());
}

TEST_F(ImportTest, WhatRemainsToTheDeadCentreIsANote) {
    ASSERT_TRUE(read(file(indicatorFile(engine))));
    const auto noteAt = [&](double shift) {
        model->edit(QStringLiteral("Shift"), [&](balance_shaft::Input& input) {
            import.putTraceInto(input);
            input.crank_radius = 0.046;  // the engine's
            input.cylinder.rod_length = 0.150;
            input.torque.trace_shift = shift * degree;
        });
        model->needPart("notes");
        const auto* job = model->findChild<BackgroundJob*>({}, Qt::FindDirectChildrenOnly);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !job->isRunning(); }, 60'000));
        return model->notesText().contains(QStringLiteral("The dead centre"));
    };
    EXPECT_TRUE(noteAt(360.0));  // a turn alone leaves what the file is late
    EXPECT_FALSE(noteAt(360.0 - late));
}

TEST_F(ImportTest, WhatIsCancelledChangesNothing) {
    const QString path = file(indicatorFile(engine));
    import.open(path);
    import.job()->cancel();
    QTest::qWait(200);
    EXPECT_TRUE(import.lines().empty());
    EXPECT_FALSE(import.isReady());
    import.open(path);
    ASSERT_TRUE(isRead());
    EXPECT_TRUE(import.isReady());
    import.open(folder.filePath(QStringLiteral("none.csv")));
}

TEST_F(ImportTest, TheWindowShowsAndChangesHowAFileIsRead) {
    const QString path = file(indicatorFile(engine));
    const Json before = model->inputJson();
    const QString said = test::importBy(
        page, [&] { source->importTrace(path); },
        [&](ImportDialog& dialog) {
            const auto* preview = test::named<QTableWidget>(dialog, "import_preview");
            EXPECT_EQ(preview->columnCount(), 13);
            EXPECT_EQ(preview->horizontalHeaderItem(4)->text(), QStringLiteral("5\npressure"));
            EXPECT_EQ(preview->item(2, 4)->text(), QStringLiteral("bar"));
            auto* value = test::named<QComboBox>(dialog, "import_value");
            EXPECT_EQ(value->currentText(), QStringLiteral("5: p cyl 1 (g) bar"));
            // The next column is none of pressures near an engine's; this one is.
            value->setFocus();
            QTest::keyClick(value, Qt::Key_Down);
            EXPECT_TRUE(test::isRead(dialog));
            EXPECT_EQ(preview->horizontalHeaderItem(5)->text(), QStringLiteral("6\npressure"));
            EXPECT_FALSE(test::named<QCheckBox>(dialog, "import_shift")->isVisible());
            QTest::keyClick(value, Qt::Key_Up);
            EXPECT_TRUE(test::isRead(dialog));
            auto* header = test::named<QSpinBox>(dialog, "import_header_lines");
            header->setFocus();
            QTest::keyClick(header, Qt::Key_Down);  // the units as a row
            EXPECT_TRUE(test::isRead(dialog));
            EXPECT_TRUE(test::named<QLabel>(dialog, "import_understood")
                            ->text()
                            .contains(QStringLiteral("must be a finite number")));
            EXPECT_FALSE(test::named<QPushButton>(dialog, "import_accept")->isEnabled());
            QTest::keyClick(header, Qt::Key_Up);
            EXPECT_TRUE(test::isRead(dialog));
            auto* gauge = test::named<QComboBox>(dialog, "import_gauge");
            EXPECT_EQ(gauge->currentIndex(), 1);
            auto* shift = test::named<QCheckBox>(dialog, "import_shift");
            EXPECT_TRUE(shift->isVisible());
            EXPECT_TRUE(shift->isChecked());
        });
    EXPECT_TRUE(said.startsWith(QStringLiteral("1440 rows"))) << qPrintable(said);
    ASSERT_EQ(model->input().torque.kind, balance_shaft::TorqueSource::Kind::pressure);
    EXPECT_NEAR(model->input().torque.trace_shift / degree, 360.0 - late, 0.5);
    EXPECT_TRUE(model->result().doubts.empty());
    EXPECT_EQ(find<QLabel>("trace_file")->text(), QStringLiteral("Pressure trace: trace.csv."));
    const balance_shaft::Input again = reopened();
    EXPECT_EQ(again.torque.trace, model->input().torque.trace);
    EXPECT_EQ(again.torque.trace_file.reading, model->input().torque.trace_file.reading);
    model->undo();
    EXPECT_EQ(model->inputJson(), before);
}

TEST_F(ImportTest, EscapeAndAFileThatIsNotThereChangeNothing) {
    const Json before = model->inputJson();
    const QString path = file(indicatorFile(engine));
    test::whenModal<ImportDialog>(
        &page, [](ImportDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
    source->importTrace(path);  // perhaps while it is being read
    EXPECT_EQ(model->inputJson(), before);
    const QString said =
        test::importBy(page, [&] { source->importTrace(folder.filePath(QStringLiteral("none"))); });
    EXPECT_FALSE(said.isEmpty());
    EXPECT_EQ(model->inputJson(), before);
}

TEST_F(ImportTest, TheCycleIsSavedWhereItIsAskedFor) {
    const QString path = file("deg;bar\n0;1,013\n180;1\n360;40,125\n540;3,250\n720;1,013\n");
    const FileChoosers usual = fileChoosers();
    fileChoosers().save = [](QWidget*, const QString&, const QString& suggestion, const QString&,
                             QString*) { return suggestion; };
    test::importBy(
        page, [&] { source->importTrace(path); },
        [](ImportDialog& dialog) {
            auto* decimal = test::named<QComboBox>(dialog, "import_decimal");
            EXPECT_EQ(decimal->currentIndex(), -1);
            decimal->setFocus();
            QTest::keyClick(decimal, Qt::Key_End);
        });
    fileChoosers() = usual;
    EXPECT_EQ(model->input().torque.trace_file.name,
              folder.filePath(QStringLiteral("trace-cycle.csv")).toStdString());
    EXPECT_EQ(reopened().torque.trace, model->input().torque.trace);
}

TEST_F(ImportTest, ATorqueFileOfThreeColumnsBecomesTheTable) {
    const QString path =
        file("sample,angle,torque (lbf-ft)\n1,0,10\n2,180,-20\n3,360,30\n4,720,10\n", "m.csv");
    test::importBy(page, [&] { page.findChild<TorqueTableEditor*>()->importFile(path); });
    ASSERT_EQ(model->input().torque.table.size(), 4U);
    EXPECT_NEAR(model->input().torque.table.torque[2], 30 * units::lbf_ft, 1e-9);
    EXPECT_EQ(model->input().torque.kind, balance_shaft::TorqueSource::Kind::table);
}

}  // namespace
}  // namespace ravnoves
