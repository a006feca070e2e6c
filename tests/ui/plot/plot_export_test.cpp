// What leaves a plot: pictures, drawings, data.

#include <gtest/gtest.h>

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFile>
#include <QMainWindow>
#include <QMenu>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>

#include "difference.h"
#include "events.h"
#include "files.h"
#include "full_disk.h"
#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "text/csv_format.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class PlotExportTest : public ::testing::Test {
  protected:
    PlotExportTest() {
        figure.add("1", {.name = u"first"_s}, {0.0, 360.0, 720.0}, {1.5, 2.5, 1.5});
        figure.add("2", {.name = u"second"_s, .role = Role::Sum}, {0.0, 180.0, 360.0},
                   {-1.0, -2.0, 1e-3});
        plot.showFigure(figure);
        test::showAt(plot, {600, 360});
    }
    QString file(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
    QString write(const QString& path) {
        return plot.findChild<FigureMenu*>()->write(path, plot.title());
    }
    QImage drawn() {
        QImage image(plot.size(), QImage::Format_RGB32);
        QPainter painter(&image);
        plot.renderTo(painter, QRectF(QPointF(), QSizeF(plot.size())));
        return image;
    }
    /// Chooses an entry of the context menu.
    void chooseInMenu(const char* text) {
        QTimer::singleShot(30, &plot, [text] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            ASSERT_NE(menu, nullptr);
            for (QAction* action : menu->actions()) {
                if (action->text() == QString::fromUtf8(text)) {
                    menu->setActiveAction(action);
                    QTest::keyClick(menu, Qt::Key_Return);
                    return;
                }
            }
            ADD_FAILURE() << text;
            menu->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Keyboard, {}, {});
        QApplication::sendEvent(&plot, &event);
        QApplication::processEvents();
    }

    QTemporaryDir folder;
    Figure figure{.title = u"Torque"_s, .x = {u"φ, °"_s, 0.0, 720.0, true}, .left = {u"M, N·m"_s}};
    PlotView plot;
};

/// The numbers are painted by the steps that the lines were laid out for.
TEST_F(PlotExportTest, AFileHasItsNumbersWhereTheWindowHasItsLines) {
    for (int width = 300; width <= 700; width += 7) {
        plot.resize(width, 360);
        plot.grab();
        const double across = plot.data().x.step;
        const double up = plot.data().left.step;
        drawn();
        EXPECT_EQ(plot.data().x.step, across) << width;
        EXPECT_EQ(plot.data().left.step, up) << width;
    }
}

TEST_F(PlotExportTest, EveryFileIsWhatItsEndingSays) {
    for (const char* name : {"график.pdf", "график.png", "график.SVG", "график.csv"}) {
        ASSERT_EQ(write(file(name)), QString()) << name;
    }
    EXPECT_TRUE(test::contentOf(file("график.pdf")).startsWith("%PDF-"));
    EXPECT_TRUE(test::contentOf(file("график.png")).startsWith("\x89PNG\r\n"));
    EXPECT_TRUE(test::contentOf(file("график.SVG")).startsWith("<?xml"));
    EXPECT_TRUE(
        test::contentOf(file("график.csv")).startsWith("\xEF\xBB\xBF\"φ, °\",\"first, N·m\","));
    for (const char* name : {"plot.jpg", "plot.eps", "plot"}) {
        EXPECT_TRUE(write(file(name)).contains(QStringLiteral(".svg"))) << name;
        EXPECT_FALSE(QFile::exists(file(name))) << name;
    }
    for (const char* name :
         {"/dev/null/x.pdf", "/dev/null/x.svg", "/dev/null/x.png", "/dev/null/x.csv"}) {
        EXPECT_NE(write(QString::fromUtf8(name)), QString()) << name;
    }
}

TEST_F(PlotExportTest, AFailedWriteIsSaidAndTheOldFileStays) {
    for (const char* name : {"old.svg", "old.pdf", "old.png", "old.csv"}) {
        test::writeFile(file(name), "old");
        const QString trouble = [&] {
            const test::FullDisk full(16);
            return write(file(name));
        }();
        EXPECT_TRUE(trouble.contains(QString::fromUtf8(name))) << trouble.toStdString();
        EXPECT_EQ(test::contentOf(file(name)), "old") << name;
    }
}

TEST_F(PlotExportTest, ThePdfHoldsTextAndLinesRatherThanPixels) {
    ASSERT_EQ(write(file("plot.pdf")), QString());
    EXPECT_FALSE(test::contentOf(file("plot.pdf")).contains("/Subtype /Image"));
    const QString program = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
    if (program.isEmpty()) {
        GTEST_SKIP() << "pdftotext is not installed";
    }
    QProcess reader;
    reader.start(program, {file("plot.pdf"), QStringLiteral("-")});
    ASSERT_TRUE(reader.waitForFinished());
    // With ligatures taken apart.
    const QString text =
        QString::fromUtf8(reader.readAllStandardOutput()).normalized(QString::NormalizationForm_KC);
    for (const char* word : {"Torque", "first", "second", "φ, °", "M, N·m", "360"}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(word))) << word << "\n" << text.toStdString();
    }
}

TEST_F(PlotExportTest, NothingOfTheMouseIsInAnyPicture) {
    const QImage before = drawn();
    const QString lines = plot.dataAsCsv();
    write(file("before.svg"));
    plot.setCursorX(200.0);
    EXPECT_EQ(drawn(), before);
    write(file("after.svg"));
    EXPECT_EQ(test::contentOf(file("before.svg")), test::contentOf(file("after.svg")));
    EXPECT_EQ(plot.dataAsCsv(), lines);
    // Nor the line that goes with it, which a value of its own keeps.
    plot.setPresentX(90.0);
    EXPECT_NE(drawn(), before);
    QObject::connect(&plot, &PlotView::cursorMoved, &plot,
                     [this](double x) { plot.setPresentX(x); });
    EXPECT_EQ(drawn(), before);
    plot.setPresentX(std::nullopt);
    // On the screen it is still there.
    const QImage shown = plot.grab().toImage();
    plot.setCursorX(std::nullopt);
    EXPECT_NE(plot.grab().toImage(), shown);
}

TEST_F(PlotExportTest, TheDataAreOneTableOverOneX) {
    EXPECT_EQ(plot.csv(CsvFormat(QLocale::c())),
              QStringLiteral("\"φ, °\",\"first, N·m\",\"second, N·m\"\n"
                             "0,1.5,-1\n"
                             "180,,-2\n"
                             "360,2.5,0.001\n"
                             "720,1.5,\n"));
    EXPECT_TRUE(plot.csv(CsvFormat(QLocale(QLocale::Russian)))
                    .startsWith(QStringLiteral("\"φ, °\";\"first, N·m\"")));
    plot.setCurveShown(0, false);
    EXPECT_EQ(plot.csv(CsvFormat(QLocale::c())).count(QLatin1Char('\n')), 4);
}

TEST_F(PlotExportTest, ACurveThatComesBackHasAnXOfItsOwn) {
    figure.add("3", {.name = u"round"_s}, {0.0, 1.0, 0.0}, {0.0, 1.0, 2.0});
    plot.showFigure(figure);
    const QStringList lines =
        plot.csv(CsvFormat(QLocale::c())).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 5);
    EXPECT_TRUE(lines[0].endsWith(QStringLiteral(",\"round: φ, °\",\"round, N·m\"")))
        << lines[0].toStdString();
    EXPECT_TRUE(lines[2].endsWith(QStringLiteral(",1,1")));
    EXPECT_TRUE(lines[4].endsWith(QStringLiteral(",,")));
}

TEST_F(PlotExportTest, PictureAndDataAreCopiedFromTheMenu) {
    chooseInMenu("Copy data");
    const QString text = QApplication::clipboard()->text();
    EXPECT_TRUE(text.startsWith(QStringLiteral("\"φ, °\"\t\"first, N·m\"\t")))
        << text.toStdString();
    chooseInMenu("Copy picture");
    EXPECT_EQ(QApplication::clipboard()->image().size(), plot.size() * 2);
}

TEST_F(PlotExportTest, TheMenuSavesForPrintAndTheStatusBarNamesTheFile) {
    QMainWindow window;
    plot.setParent(&window);
    test::showAt(window, {600, 400});
    const QSignalSpy said(window.statusBar(), &QStatusBar::messageChanged);
    const FileChoosers before = fileChoosers();
    QString filters;
    fileChoosers().save = [&](QWidget*, const QString&, const QString&, const QString& offered,
                              QString*) {
        filters = offered;
        return file("Вариант");
    };
    chooseInMenu("Save picture or data…");
    const QImage printed(file("Вариант.png"));
    EXPECT_EQ(printed.size(), QSize(1875, 1125));
    EXPECT_NEAR(printed.dotsPerMeterX() * 0.0254, 300.0, 0.1);
    for (const char* suffix : {"*.png", "*.svg", "*.pdf", "*.csv"}) {
        EXPECT_TRUE(filters.contains(QString::fromUtf8(suffix))) << filters.toStdString();
    }
    EXPECT_TRUE(said.contains(QVariantList{QStringLiteral("Written: Вариант.png")}));
    fileChoosers() = before;
    plot.setParent(nullptr);
}

class Square final : public QWidget {
  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter(this).fillRect(rect().adjusted(20, 20, -20, -20), Qt::black);
    }
};

/// The entries of the menu that a key opens.
QStringList entriesByKey(QWidget& figure) {
    QStringList entries;
    QTimer::singleShot(0, &figure, [&] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_NE(menu, nullptr);
        for (const QAction* action : menu->actions()) {
            entries << action->text();
        }
        menu->close();
    });
    QTest::keyClick(&figure, Qt::Key_F10, Qt::ShiftModifier);
    return entries;
}

TEST_F(PlotExportTest, EveryFigureHasTheMenuAndTheKeyboardReachesIt) {
    EXPECT_TRUE(entriesByKey(plot).contains(QStringLiteral("Save picture or data…")));
    Square square;
    makeFigure(&square);
    test::showAt(square, {100, 80});
    EXPECT_TRUE(isFigure(&square));
    EXPECT_EQ(square.focusPolicy(), Qt::TabFocus);
    EXPECT_EQ(entriesByKey(square),
              QStringList({QStringLiteral("Copy picture"), QStringLiteral("Save picture…")}));
    makeFigure(&square, [](const CsvFormat& format) {
        return format.line({QStringLiteral("a"), format.number(1.5)});
    });
    EXPECT_EQ(entriesByKey(square).size(), 3);
    // The focus is seen on the screen, not in a picture.
    square.clearFocus();
    const QImage without = square.grab().toImage();
    square.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&square));
    square.setFocus();
    ASSERT_TRUE(square.hasFocus());
    EXPECT_NE(square.grab().toImage(), without);
    const auto* menu = square.findChild<FigureMenu*>();
    for (const char* name : {"a.svg", "a.pdf", "a.png", "a.csv"}) {
        EXPECT_EQ(menu->write(file(name), {}), QString()) << name;
    }
    EXPECT_EQ(test::contentOf(file("a.csv")),
              "\xEF\xBB\xBF"
              "a,1.5\n");
    const QImage picture(file("a.png"));
    EXPECT_EQ(picture.width(), qRound(square.width() * 300.0 / 96.0));
    EXPECT_EQ(picture.pixelColor(0, 0), picture.pixelColor(15, 15));
    EXPECT_EQ(picture.pixelColor(picture.rect().center()), QColor(Qt::black));
    EXPECT_FALSE(test::contentOf(file("a.svg")).contains("<polyline"));
}

/// A page that is written larger than it is on the screen holds its plots drawn again.
TEST_F(PlotExportTest, InAnEnlargedPictureOfItsPageAPlotIsSharp) {
    constexpr int times = 3;
    QImage ofPage(plot.size() * times, QImage::Format_RGB32);
    QImage own(ofPage.size(), ofPage.format());
    QImage blown = plot.grab().toImage().scaled(ofPage.size()).convertToFormat(ofPage.format());
    {
        QPainter painter(&ofPage);
        painter.scale(times, times);
        plot.render(&painter);
        QPainter direct(&own);
        plot.renderTo(direct, QRectF(QPointF(), QSizeF(own.size())));
    }
    EXPECT_LT(test::differenceOf(ofPage, own).grey, 0.2 * test::differenceOf(blown, own).grey);
}

}  // namespace
}  // namespace ravnoves
