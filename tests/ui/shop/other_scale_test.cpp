// One scale after another at the same port.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <QFile>
#include <QPlainTextEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "events.h"
#include "shop/model/scale_reader.h"
#include "shop/scale_button.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// Scales at a port, and what is made of their lines.
class OtherScaleTest : public ::testing::Test {
  protected:
    OtherScaleTest() {
        plug();
        ScaleSettings settings;
        settings.port = port();
        settings.resolution = 1e-5;
        settings.save();
        QObject::connect(reader(), &ScaleReader::weighed,
                         [this](const shop::ScaleLine& line) { weights << line.number; });
        QObject::connect(reader(), &ScaleReader::lineRead, [this] { ++lines; });
        QObject::connect(&button, &ScaleButton::status,
                         [this](const QString& text) { said = text; });
        reader()->use(settings);
    }
    ~OtherScaleTest() override {
        unplug();
        QSettings().remove(u"scale"_s);
    }

    static bool waitFor(const std::function<bool()>& what) { return QTest::qWaitFor(what, 5000); }
    ScaleReader* reader() { return button.reader(); }
    QString port() const { return folder.filePath(u"ttyScale"_s); }
    void plug() {
        master = posix_openpt(O_RDWR | O_NOCTTY);
        ASSERT_GE(master, 0);
        ASSERT_EQ(grantpt(master), 0);
        ASSERT_EQ(unlockpt(master), 0);
        ASSERT_TRUE(QFile::link(QString::fromLocal8Bit(ptsname(master)), port()));
    }
    void unplug() {
        QFile::remove(port());
        close(master);
    }
    void plugAnother() {
        unplug();
        ASSERT_TRUE(waitFor([&] { return !reader()->isConnected(); }));
        plug();
        ASSERT_TRUE(waitFor([&] { return reader()->isConnected(); }));
    }
    /// @return false where no line comes of it
    bool send(std::string_view bytes) {
        const int before = lines;
        return write(master, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()) &&
               waitFor([&] { return lines > before; });
    }

    QTemporaryDir folder;
    int master = -1;
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
    EXPECT_EQ(reader()->refusal(), QString());
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
    EXPECT_EQ(reader()->refusal(), QString());
    ASSERT_TRUE(send("569.00 g\r\n"));
    EXPECT_TRUE(said.contains(u"“S S    570.00 g”"_s)) << said.toStdString();

    // Whoever looks into the settings may have another scale.
    button.openSettings();
    auto* shown = test::named<QPlainTextEdit>(button, "scale_lines");
    ASSERT_TRUE(send("571.00 g\r\n"));
    EXPECT_EQ(weights.constLast(), 571.0);
    ASSERT_TRUE(send("572.00\r\n"));
    EXPECT_EQ(weights.constLast(), 571.0);
    EXPECT_TRUE(shown->toPlainText().endsWith(reader()->refusal())) << "the list says why";
    EXPECT_FALSE(reader()->refusal().isEmpty());
    shown->window()->close();
}

TEST_F(OtherScaleTest, TheEndOfALineThatWasLostIsNoWeight) {
    ASSERT_TRUE(send("S S    568.50 g\r\n"));
    ASSERT_EQ(write(master, "S S    57", 9), 9);
    QTest::qWait(20);
    plugAnother();
    ASSERT_TRUE(send("0.25 g\r\n"));
    EXPECT_EQ(weights.size(), 1);
    EXPECT_FALSE(said.isEmpty());
    ASSERT_TRUE(send("570.25 g\r\n"));
    EXPECT_EQ(weights, QList<double>({568.5, 570.25})) << "the next line is whole";
}

}  // namespace
}  // namespace ravnoves
