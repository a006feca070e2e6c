#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QStatusBar>
#include <QTabWidget>
#include <QTemporaryDir>

#include "events.h"
#include "shell/main_window.h"
#include "shop/model/scale_reader.h"
#include "shop/scale_button.h"
#include "widgets/number_field.h"
#include "workshop/workshop_page.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

using test::comes;

/// Types in any alphabet, over what stands there.
void typeInto(QLineEdit* field, const QString& text) {
    field->selectAll();
    for (const QChar c : text) {
        QTest::sendKeyEvent(QTest::Click, field, Qt::Key_unknown, QString(c), Qt::NoModifier);
    }
    QTest::keyClick(field, Qt::Key_Return);
}

/// A scale: a pseudo-terminal under a name that stays when it is unplugged and plugged in again.
class Scale {
  public:
    Scale() { plug(); }
    ~Scale() { unplug(); }

    QString port() const { return folder_.filePath(u"ttyScale"_s); }
    void plug() {
        master_ = posix_openpt(O_RDWR | O_NOCTTY);
        ASSERT_GE(master_, 0);
        ASSERT_EQ(grantpt(master_), 0);
        ASSERT_EQ(unlockpt(master_), 0);
        ASSERT_TRUE(QFile::link(QString::fromLocal8Bit(ptsname(master_)), port()));
    }
    void unplug() {
        QFile::remove(port());
        close(master_);
    }
    void send(std::string_view bytes) {
        ASSERT_EQ(write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }

  private:
    QTemporaryDir folder_;
    int master_ = -1;
};

/// The program's window on the weigh-in sheet of the workshop, a scale beside it.
class ScaleTest : public ::testing::Test {
  protected:
    ScaleTest() {
        ScaleSettings settings;
        settings.port = scale.port();
        start(settings);
    }
    ~ScaleTest() override { QSettings().remove(u"scale"_s); }

    void start(const ScaleSettings& settings) {
        settings.save();
        window = std::make_unique<MainWindow>();
        window->showScene(u"workshop"_s);
        test::showAt(*window, {1280, 800});
        window->activateWindow();
        button = test::named<ScaleButton>(*window, "scale_button");
        page = static_cast<WorkshopPage*>(window->currentPage());
        QObject::connect(button->reader(), &ScaleReader::lineRead, [this] { ++lines; });
        sheets = test::named<QTabWidget>(*page, "sheets");
        sheets->setCurrentIndex(2);
        goTo("mass_piston_1");
    }
    NumberField* field(const char* name) { return test::named<NumberField>(*page, name); }
    double value(const char* name) { return field(name)->value().value_or(-1.0); }
    void goTo(const char* name) {
        field(name)->setFocus();
        ASSERT_EQ(focus(), name);
    }
    std::string focus() const {
        const QWidget* focus = QApplication::focusWidget();
        return focus != nullptr ? focus->objectName().toStdString() : std::string();
    }
    /// Sends lines that come at once, and waits until they are read.
    void send(const std::string& bytes) {
        const auto after = lines + std::count(bytes.begin(), bytes.end(), '\n');
        scale.send(bytes);
        EXPECT_TRUE(comes([&] { return lines == after; }));
    }
    /// Whether bytes are entered, so that another field has the focus.
    bool goesOn(std::string_view bytes, const char* next) {
        scale.send(bytes);
        return comes([&] { return focus() == next; });
    }
    bool shows(const QString& text) {
        return comes([&] { return button->text().contains(text); });
    }
    bool says(const QString& text) {
        return comes([&] { return window->statusBar()->currentMessage().contains(text); });
    }

    Scale scale;
    std::unique_ptr<MainWindow> window;
    ScaleButton* button = nullptr;
    WorkshopPage* page = nullptr;
    QTabWidget* sheets = nullptr;
    std::ptrdiff_t lines = 0;  ///< that were read
};

TEST_F(ScaleTest, WeightsGoDownTheSheet) {
    ASSERT_TRUE(button->isVisible());
    EXPECT_EQ(button->text(), u"Scale: ready"_s) << button->toolTip().toStdString();
    ASSERT_TRUE(goesOn("S S    568.50 g\r\n", "mass_piston_2"));
    EXPECT_EQ(value("mass_piston_1"), 568.5);
    EXPECT_TRUE(says(u"568.50"_s));

    // What has not settled, is garbled or too much is shown and not taken.
    scale.send("S D    570.10 g\r\n");
    EXPECT_TRUE(shows(u"570.10\u00A0g, not settled"_s));
    scale.send("S S    5x8.10 g\r\n");
    EXPECT_TRUE(shows(u"not understood"_s));
    scale.send("S +\r\n");
    EXPECT_TRUE(shows(u"too much on the pan"_s));
    EXPECT_EQ(focus(), "mass_piston_2");

    // A line comes in pieces; half a line that does not go on is no line, nor part of the next.
    scale.send("S S    5");
    QApplication::processEvents();
    ASSERT_TRUE(goesOn("67.25 g\r", "mass_piston_3"));
    EXPECT_EQ(value("mass_piston_2"), 567.25);
    scale.send("\nS S    56");
    EXPECT_TRUE(shows(u"not understood"_s));
    send("569.00 g\r\n");  // says less of itself than the lines before
    EXPECT_EQ(focus(), "mass_piston_3");

    // Other units, and other forms.
    ASSERT_TRUE(goesOn("ST,+0.5690 kg\r\n", "mass_piston_4"));
    EXPECT_EQ(value("mass_piston_3"), 569.0);
    ASSERT_TRUE(goesOn("ST,GS,+ 20.00 oz\r\n", "mass_piston_5"));
    EXPECT_NEAR(value("mass_piston_4"), 566.9904625, 1e-9);

    // A weight that the field rejects leaves it as it is.
    scale.send("S S      0.00 g\r\n");
    EXPECT_TRUE(says(u"not accepted"_s));
    EXPECT_EQ(field("mass_piston_5")->text(), QString());
    EXPECT_EQ(focus(), "mass_piston_5");

    // The same again within a moment is Print pressed twice, or a scale that sends all the time.
    send("S S    571.00 g\r\nS S    571.00 g\r\nS S    571.00 g\r\n");
    EXPECT_EQ(focus(), "mass_piston_6");
    EXPECT_TRUE(says(u"571.00\u00A0g not entered: sent again too soon"_s));

    // Another weight is another part, however alike, unless nobody presses a key as fast.
    QTest::qWait(450);
    send("S S    571.02 g\r\nS S    571.03 g\r\n");
    EXPECT_EQ(value("mass_piston_6"), 571.02);
    EXPECT_TRUE(says(u"571.03\u00A0g not entered"_s));
    EXPECT_EQ(focus(), "mass_piston_7");
    page->model()->undo();

    // One weight is one step to undo.
    page->model()->undo();
    EXPECT_FALSE(field("mass_piston_5")->value());
    EXPECT_EQ(value("mass_piston_4"), 566.9904625);
}

TEST_F(ScaleTest, FromOnePartToTheNextItPassesNominalAndRange) {
    sheets->setCurrentIndex(0);
    sheets->setCurrentIndex(2);
    EXPECT_EQ(focus(), "mass_piston_1");
    goTo("mass_piston_8");
    ASSERT_TRUE(goesOn("S S    568.50 g\r\n", "mass_pin_1"));
    ASSERT_TRUE(goesOn("S S    151.20 g\r\n", "mass_pin_2"));
    EXPECT_FALSE(field("nominal_pin")->value());
    EXPECT_FALSE(field("spread_pin")->value());
    // Where the user has gone there it is written, and goes no further.
    goTo("nominal_pin");
    scale.send("S S    150.00 g\r\n");
    ASSERT_TRUE(comes([&] { return value("nominal_pin") == 150.0; }));
    EXPECT_EQ(focus(), "nominal_pin");
    EXPECT_FALSE(field("spread_pin")->value());
    EXPECT_EQ(value("mass_pin_1"), 151.2);
}

TEST_F(ScaleTest, AWeightGoesIntoMassFieldsAlone) {
    sheets->setCurrentIndex(0);
    auto* number = test::named<QLineEdit>(*page, "engine_number");
    number->setFocus();
    scale.send("568.5 g\r\n");
    EXPECT_TRUE(says(u"click a mass field first"_s));
    EXPECT_EQ(number->text(), QString());
    sheets->setCurrentIndex(1);
    auto* factor = field("reciprocating_percent");
    factor->setFocus();
    const QString before = factor->text();
    send("569.5 g\r\n");
    EXPECT_EQ(factor->text(), before);

    // On other pages as well.
    window->showScene(u"balance-shaft"_s);
    NumberField* mass = nullptr;
    for (auto* each : window->currentPage()->findChildren<NumberField*>()) {
        mass = mass == nullptr && each->unit() == u"kg"_s && each->isVisible() ? each : mass;
    }
    ASSERT_NE(mass, nullptr);
    mass->setFocus();
    scale.send("412.5 g\r\n");
    EXPECT_TRUE(comes([&] { return mass->value() == 0.4125; }));
    EXPECT_FALSE(mass->hasFocus());
}

TEST_F(ScaleTest, UnpluggedInTheMiddleItIsTakenUpAgain) {
    ASSERT_TRUE(goesOn("S S    568.50 g\r\n", "mass_piston_2"));
    send("?\r\nS S    57");
    scale.unplug();
    EXPECT_TRUE(shows(u"not connected"_s));
    EXPECT_TRUE(says(u"unplugged"_s));
    EXPECT_FALSE(button->reader()->isConnected());
    QTest::qWait(1200);  // it is looked for
    EXPECT_TRUE(button->toolTip().contains(u"unplugged"_s));
    scale.plug();
    EXPECT_TRUE(shows(u"ready"_s));
    scale.send("0.25 g\r\n");  // the end of what was sent when it went
    EXPECT_TRUE(shows(u"not understood"_s));
    EXPECT_EQ(focus(), "mass_piston_2");
    ASSERT_TRUE(goesOn("S S    570.25 g\r\n", "mass_piston_3"));
    EXPECT_EQ(value("mass_piston_2"), 570.25);
}

TEST_F(ScaleTest, ThatSendsAllTheTimeGivesEachPartOnce) {
    ScaleSettings settings = button->reader()->settings();
    settings.taking = ScaleSettings::EachPart;
    window.reset();
    start(settings);
    const auto sendAll = [&](const char* line, int times) {
        for (int i = 0; i < times; ++i) {
            send(line);
        }
    };
    sendAll("ST,+0000.0 g\r\n", 5);
    sendAll("US,+0312.4 g\r\n", 3);
    sendAll("ST,+0568.5 g\r\n", 30);
    EXPECT_EQ(focus(), "mass_piston_2");
    sendAll("US,+0100.0 g\r\n", 2);
    sendAll("ST,+0000.1 g\r\n", 5);
    sendAll("ST,+0568.7 g\r\n", 30);
    EXPECT_EQ(focus(), "mass_piston_3");
    EXPECT_EQ(value("mass_piston_1"), 568.5);
    EXPECT_EQ(value("mass_piston_2"), 568.7);
}

TEST_F(ScaleTest, SettingsShowWhatItSendsAndHold) {
    test::actionNamed(*window, u"Scale…"_s)->trigger();
    auto* lines = test::named<QPlainTextEdit>(*window, "scale_lines");
    ASSERT_NE(lines, nullptr);
    EXPECT_TRUE(test::named<QLabel>(*window, "scale_state")->text().contains(scale.port()));
    auto* digit = test::named<NumberField>(*window, "scale_resolution");
    QWidget* dialog = lines->window();
    digit->setFocus();
    scale.send("S S  568.50 g\r\n\x02? g\r\n");
    EXPECT_TRUE(comes([&] { return lines->blockCount() == 2; }));
    EXPECT_EQ(lines->toPlainText(),
              u"S S  568.50 g  →  568.50 g, stable\n‹02›? g  →  not understood"_s);
    // The weight went nowhere; its last digit is known now.
    EXPECT_EQ(digit->value(), 0.01);
    EXPECT_EQ(value("mass_piston_1"), -1.0);
    auto* unit = test::named<QComboBox>(*window, "scale_unit");
    QTest::keyClick(unit, Qt::Key_Down);
    scale.send("0.5\r\n");
    EXPECT_TRUE(comes([&] { return lines->toPlainText().contains(u"0.5 kg, stable"_s); }));
    typeInto(digit, u"0,1 г"_s);
    auto* port = test::named<QComboBox>(*window, "scale_port");
    port->lineEdit()->setText(u"/dev/no-such-port"_s);
    QTest::keyClick(port->lineEdit(), Qt::Key_Return);
    EXPECT_TRUE(test::named<QLabel>(*window, "scale_state")->text().contains(u"does not exist"_s));
    dialog->close();
    const ScaleSettings kept = ScaleSettings::load();
    EXPECT_EQ(kept.port, u"/dev/no-such-port"_s);
    EXPECT_EQ(kept.usualUnit, ScaleSettings::Kilogram);
    EXPECT_DOUBLE_EQ(kept.resolution, 1e-4);

    // The page says what the last digit means for the bob weight.
    EXPECT_TRUE(comes([&] {
        window->activateWindow();
        return focus() == "mass_piston_1";
    }));
    EXPECT_EQ(window->openCase(QStringLiteral(RAVNOVES_EXAMPLES "/v8-4.25-repair.case.json")),
              QString());
    page = static_cast<WorkshopPage*>(window->currentPage());
    EXPECT_TRUE(test::named<QLabel>(*page, "limits")->text().contains(u"Weighed to 0.1\u00A0g"_s))
        << test::named<QLabel>(*page, "limits")->text().toStdString();
    EXPECT_TRUE(test::named<QLabel>(*page, "limits")->text().contains(u"too coarse"_s));
    // Without a crank radius nothing is said of its unbalance.
    EXPECT_EQ(window->openCase(QStringLiteral(RAVNOVES_EXAMPLES "/bob-weights-v8.case.json")),
              QString());
    page = static_cast<WorkshopPage*>(window->currentPage());
    EXPECT_TRUE(test::named<QLabel>(*page, "limits")
                    ->text()
                    .endsWith(u"is accurate to ±0.22\u00A0g (95\u00A0%)."_s))
        << test::named<QLabel>(*page, "limits")->text().toStdString();
}

TEST_F(ScaleTest, AKeyboardScaleIsUnderstood) {
    const auto type = [&](const char* name, const QString& text) {
        goTo(name);
        typeInto(field(name), text);
        return value(name);
    };
    EXPECT_EQ(type("mass_piston_1", u"568.5g"_s), 568.5);
    EXPECT_EQ(focus(), "mass_piston_2");
    EXPECT_EQ(type("mass_piston_2", u"568,5 г"_s), 568.5);
    EXPECT_EQ(type("mass_piston_3", u"1.2 kg"_s), 1200.0);
    EXPECT_EQ(type("mass_piston_4", u"0,5685КГ"_s), 568.5);
    EXPECT_NEAR(type("mass_piston_5", u"20 oz"_s), 566.9904625, 1e-9);
    EXPECT_NEAR(type("mass_piston_6", u"1.25lb"_s), 566.9904625, 1e-9);
    EXPECT_EQ(type("mass_piston_6", u"568ю5п"_s), 568.5);  // its keys in the Russian layout
    type("mass_piston_7", u"80 mm"_s);
    EXPECT_EQ(field("mass_piston_7")->trouble(), u"“mm” is not a unit of this value (g)."_s);
    QTest::keyClick(field("mass_piston_7"), Qt::Key_Escape);
    type("mass_piston_7", u"568.5 ct"_s);
    EXPECT_EQ(field("mass_piston_7")->trouble(), u"“568.5 ct” is not a number."_s);
    QTest::keyClick(field("mass_piston_7"), Qt::Key_Escape);
}

/// One scale after another at the same port, and what is made of their lines.
class OtherScaleTest : public ::testing::Test {
  protected:
    OtherScaleTest() {
        ScaleSettings settings;
        settings.port = scale.port();
        settings.resolution = 1e-5;
        settings.save();
        QObject::connect(reader(), &ScaleReader::weighed,
                         [this](const shop::ScaleLine& line) { weights << line.number; });
        QObject::connect(reader(), &ScaleReader::lineRead, [this] { ++lines; });
        QObject::connect(&button, &ScaleButton::status,
                         [this](const QString& text) { said = text; });
        reader()->use(settings);
    }
    ~OtherScaleTest() override { QSettings().remove(u"scale"_s); }

    ScaleReader* reader() { return button.reader(); }
    void plugAnother() {
        scale.unplug();
        ASSERT_TRUE(comes([&] { return !reader()->isConnected(); }));
        scale.plug();
        ASSERT_TRUE(comes([&] { return reader()->isConnected(); }));
    }
    /// @return false where no line comes of it
    bool send(std::string_view bytes) {
        const int before = lines;
        scale.send(bytes);
        return comes([&] { return lines > before; });
    }

    Scale scale;
    ScaleButton button;
    QList<double> weights;
    int lines = 0;
    QString said;
};

TEST_F(OtherScaleTest, IsTakenAtOnceAfterTheFirstWasUnplugged) {
    ASSERT_TRUE(send("S S    568.50 g\r\n"));
    plugAnother();
    ASSERT_TRUE(send("570.25 g\r\n"));
    EXPECT_EQ(weights, QList<double>({568.5, 570.25})) << said.toStdString();
    // It has a form of its own now.
    ASSERT_TRUE(send("0.25\r\n"));
    EXPECT_EQ(weights.size(), 2);
    plugAnother();
    ASSERT_TRUE(send("580\r\n"));
    EXPECT_EQ(weights.constLast(), 580.0);
    EXPECT_EQ(reader()->rejection(), QString());
}

TEST_F(OtherScaleTest, SaysWhichLinesAreAwaited) {
    ASSERT_TRUE(send("S S    568.50 g\r\n"));
    said.clear();
    ASSERT_TRUE(
        send("\x02"
             "569.00 g\r\n"));
    EXPECT_EQ(weights.size(), 1);
    EXPECT_EQ(
        said,
        u"Expected lines such as “S S    568.50 g”, got “‹02›569.00 g”. For another scale open Edit ▸ Scale…."_s);
    // A line of its form is taken as before, and the reason is gone.
    ASSERT_TRUE(send("S S    570.00 g\r\n"));
    EXPECT_EQ(weights.constLast(), 570.0);
    EXPECT_EQ(reader()->rejection(), QString());
    ASSERT_TRUE(send("569.00 g\r\n"));
    EXPECT_TRUE(said.contains(u"“S S    570.00 g”"_s)) << said.toStdString();

    // Whoever looks into the settings may have another scale.
    button.openSettings();
    auto* shown = test::named<QPlainTextEdit>(button, "scale_lines");
    ASSERT_TRUE(send("571.00 g\r\n"));
    EXPECT_EQ(weights.constLast(), 571.0);
    ASSERT_TRUE(send("572.00\r\n"));
    EXPECT_EQ(weights.constLast(), 571.0);
    EXPECT_TRUE(shown->toPlainText().endsWith(reader()->rejection())) << "the list says why";
    EXPECT_FALSE(reader()->rejection().isEmpty());
    shown->window()->close();
}

}  // namespace
}  // namespace ravnoves
