#include <QApplication>
#include <QCommandLineParser>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <optional>

#include "case-file/process_state.h"
#include "report/case_report.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shell/scene_list.h"
#include "shell/screenshot.h"
#include "shop/model/journal.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/preferences.h"
#include "theme/theme.h"

namespace {

using namespace Qt::StringLiterals;

/// As the other program says it: with the minus that a terminal's user types.
int fail(QString text) {
    std::fprintf(stderr, "%s\n", qPrintable(text.replace(QChar(0x2212), QLatin1Char('-'))));
    return 2;
}

/// Says what was asked for. @return the status to end with
int say(const QString& text) {
    std::fputs(qPrintable(text), stdout);
    return std::fflush(stdout) == 0 ? 0 : fail(u"ravnoves: standard output cannot be written"_s);
}

}  // namespace

int main(int argc, char** argv) {
    ravnoves::prepare_process();
    QCommandLineParser parser;
    parser.setApplicationDescription(u"The engine-balancing workbench."_s);
    const QCommandLineOption helpOption = parser.addHelpOption();
    const QCommandLineOption versionOption = parser.addVersionOption();
    parser.addPositionalArgument(u"case"_s, u"Case files to open."_s, u"[case…]"_s);
    const QCommandLineOption sceneOption(
        u"scene"_s, u"Open this module (balance-shaft, elastic-hinge, …)."_s, u"name"_s);
    const QCommandLineOption caseOption(u"case"_s, u"Open this case file; may be repeated."_s,
                                        u"file"_s);
    const QCommandLineOption setOption(
        u"set"_s, u"Set a value of the case or of the page; may be repeated."_s, u"key=value"_s);
    const QCommandLineOption screenshotOption(
        u"screenshot"_s, u"Write the window as a PNG picture and exit."_s, u"file.png"_s);
    const QCommandLineOption reportOption(
        u"report"_s, u"Write a report of the case as PDF or HTML, by the suffix, and exit."_s,
        u"file.pdf"_s);
    const QCommandLineOption sizeOption(u"size"_s, u"Size of the window, for example 1280x800."_s,
                                        u"WxH"_s, u"1280x800"_s);
    const QCommandLineOption themeOption(u"theme"_s, u"light, dark or system."_s, u"name"_s);
    const QCommandLineOption scaleOption(
        u"scale"_s, u"With --screenshot: pixels of the picture for one of the window, 1 or 2."_s,
        u"factor"_s, u"1"_s);
    const QCommandLineOption languageOption(u"language"_s, u"Language of the program: en, ru."_s,
                                            u"code"_s);
    const QCommandLineOption textOption(u"text"_s, u"Size of the text in percent, 80 to 200."_s,
                                        u"percent"_s);
    parser.addOptions({sceneOption, caseOption, setOption, screenshotOption, reportOption,
                       sizeOption, themeOption, languageOption, textOption, scaleOption});
    // Before Qt starts: what some options say. What is wrong with any is said below.
    QStringList words;
    for (int i = 0; i < argc; ++i) {
        words << QString::fromLocal8Bit(argv[i]);
    }
    parser.parse(words);
    const bool screenshot = parser.isSet(screenshotOption);
    const bool report = parser.isSet(reportOption);
    const bool isSilent = screenshot || report;
    if (isSilent) {
        ravnoves::namePlacesByPointer();
        // The same pixels everywhere: no scaling.
        qunsetenv("QT_FONT_DPI");
        parser.value(scaleOption) == u"2" ? qputenv("QT_SCALE_FACTOR", "2")
                                          : qunsetenv("QT_SCALE_FACTOR");
    }
    const bool hasPlatform = words.contains(u"-platform"_s);
    if (report && !hasPlatform) {
        qputenv("QT_QPA_PLATFORM", "offscreen");  // no window flashes up
    }
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && qEnvironmentVariableIsEmpty("DISPLAY") &&
        qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") && !hasPlatform) {
        if (!screenshot && !parser.isSet(helpOption) && !parser.isSet(versionOption) &&
            !parser.isSet(u"help-all"_s)) {
            return fail(
                u"There is no display. --screenshot FILE.png renders a page without one, "
                "--report FILE.pdf writes a report; ravnoves-cli solves case files."_s);
        }
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication app(argc, argv);
    QApplication::setApplicationName(u"Ravnoves"_s);
    QApplication::setOrganizationName(u"Ravnoves"_s);
    QApplication::setApplicationVersion(QStringLiteral(RAVNOVES_VERSION));
    QGuiApplication::setDesktopFileName(u"org.ravnoves.ravnoves"_s);  // packaging/desktop

    if (!parser.parse(QApplication::arguments())) {
        return fail(parser.errorText());
    }
    if (parser.isSet(helpOption)) {
        return say(parser.helpText());
    }
    if (parser.isSet(versionOption)) {
        return say(QApplication::applicationName() + QLatin1Char(' ') +
                   QApplication::applicationVersion() + QLatin1Char('\n'));
    }
    parser.process(app);  // --help-all

    // The others say what they allow.
    for (const QCommandLineOption& option :
         {sceneOption, caseOption, setOption, screenshotOption, reportOption, languageOption}) {
        if (parser.values(option).contains(QString())) {
            return fail(u"--%1: must not be empty"_s.arg(option.names().front()));
        }
    }
    if (parser.positionalArguments().contains(QString())) {
        return fail(u"case: must not be empty"_s);
    }
    if (screenshot && report) {
        return fail(u"--report: excludes --screenshot"_s);
    }
    if (parser.isSet(scaleOption) && !screenshot) {
        return fail(u"--scale: needs --screenshot"_s);
    }
    if (const QString scale = parser.value(scaleOption); scale != u"1" && scale != u"2") {
        return fail(u"--scale: must be 1 or 2, got %1"_s.arg(scale));
    }

    std::optional<QTemporaryDir> noSettings;
    if (isSilent) {
        // Nothing of the user's settings may change the picture.
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                           noSettings.emplace().path());
    }
    if (isSilent) {
        ravnoves::Journal::setKept(false);
    }
    if (const QString code = parser.value(languageOption); parser.isSet(languageOption)) {
        QStringList codes;
        for (const ravnoves::Language& language : ravnoves::availableLanguages()) {
            codes << language.code;
        }
        if (!codes.contains(code)) {
            return fail(u"--language: must be one of %1, got %2"_s.arg(codes.join(u", "_s), code));
        }
    }
    ravnoves::installLanguage(parser.isSet(languageOption) ? parser.value(languageOption)
                              : isSilent                   ? u"en"_s
                                                           : QString());
    ravnoves::Preferences::instance().load();
    auto mode = static_cast<ravnoves::Theme::Mode>(QSettings().value(u"view/theme"_s, 0).toInt());
    if (parser.isSet(themeOption) || isSilent) {
        const QString name = parser.value(themeOption);
        if (name == "dark"_L1) {
            mode = ravnoves::Theme::Mode::Dark;
        } else if (name == "system"_L1) {
            mode = ravnoves::Theme::Mode::System;
        } else if (name == "light"_L1 || !parser.isSet(themeOption)) {
            mode = ravnoves::Theme::Mode::Light;
        } else {
            return fail(u"--theme: must be light, dark or system, got %1"_s.arg(name));
        }
    }
    const auto fits = [](int percent) { return percent >= 80 && percent <= 200; };
    int percent = QSettings().value(u"view/text"_s, 100).toInt();
    if (parser.isSet(textOption)) {
        percent = parser.value(textOption).toInt();
        if (!fits(percent)) {
            return fail(u"--text: must be from 80 to 200, got %1"_s.arg(parser.value(textOption)));
        }
    }
    // What is in the settings keeps nobody from starting.
    ravnoves::Theme::instance().setTextScale(fits(percent) ? percent / 100.0 : 1.0);
    ravnoves::Theme::instance().install(mode);

    const QString reportPath = parser.value(reportOption);
    if (report && !ravnoves::isReportName(reportPath)) {
        return fail(u"--report: must end in .pdf or .html, got %1"_s.arg(reportPath));
    }
    ravnoves::MainWindow window(ravnoves::MainWindow::First::Nothing);
    if (!isSilent) {
        window.beginSession();
    }
    const QString scene = parser.value(sceneOption);
    const QString start = u"start"_s;
    const QStringList paths = parser.values(caseOption) + parser.positionalArguments();
    if (scene == start || (scene.isEmpty() && paths.isEmpty() && !screenshot)) {
        window.showStart();
    } else if (!scene.isEmpty() && !window.showScene(scene)) {
        QStringList names{start};
        for (const ravnoves::SceneInfo& info : ravnoves::sceneList()) {
            names << info.name;
        }
        return fail(u"--scene: must be one of %1, got %2"_s.arg(names.join(u", "_s), scene));
    } else if (scene.isEmpty() && paths.isEmpty() && !window.documents().hasCurrent()) {
        window.showScene(ravnoves::sceneList().front().name);
    }
    QStringList left;  ///< to the window, once it is there
    const bool isMeantAtOnce = isSilent || parser.isSet(setOption) || !scene.isEmpty();
    for (qsizetype i = 0; i < paths.size(); ++i) {
        const QString trouble = window.openCase(paths[i]);
        if (!trouble.isEmpty()) {
            const int status = fail(trouble);
            if (isSilent || parser.isSet(setOption)) {
                return status;
            }
            left << paths[i];  // the window says it, too: nobody may be at the terminal
            continue;
        }
        if (!isMeantAtOnce) {
            left << paths.mid(i + 1);
            break;
        }
        if (!scene.isEmpty() && scene != start && window.currentScene() != scene) {
            return fail(
                u"--scene %1 does not match the case (%2)"_s.arg(scene, window.currentScene()));
        }
    }
    if (!left.isEmpty() && !window.documents().hasCurrent()) {
        window.showStart();
    }
    if (report && paths.size() != 1) {
        return fail(u"--report: needs one case, --case FILE"_s);
    }
    for (const QString& pair : parser.values(setOption)) {
        const QString trouble = ravnoves::applySetting(window, pair);
        if (!trouble.isEmpty()) {
            return fail(trouble);
        }
    }
    if (screenshot || parser.isSet(sizeOption)) {
        const QString trouble = ravnoves::setWindowSize(window, parser.value(sizeOption));
        if (!trouble.isEmpty()) {
            return fail(trouble);
        }
    }
    if (screenshot) {
        const QString trouble = ravnoves::writeScreenshot(window, parser.value(screenshotOption));
        return trouble.isEmpty() ? 0 : fail(trouble);
    }
    if (!window.isMaximized() && !window.isFullScreen()) {
        // With its frame and title it fits the screen, which may be another than last time.
        const QSize room = window.screen()->availableSize() - QSize(16, 48);
        window.resize(window.size().boundedTo(room));
    }
    window.show();
    if (report) {
        const QString trouble = window.writeReport(reportPath);
        return trouble.isEmpty() ? 0 : fail(trouble);
    }
    // After the first picture: a folder full of what crashes have left keeps nobody from starting.
    QTimer::singleShot(100, &window, [&window, left] {
        window.offerRecovered();
        window.openOrSayWhy(left);
    });
    return QApplication::exec();
}
