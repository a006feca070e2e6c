// Works in the program's window and saves for ever all that it saves: a case by its file, a job in
// the journal with the settings that go with it, a case without a file as the copy for a crash. It
// says on standard output what was saved: "case N", "job N", and before it is typed "next N". It is
// there to be killed.

#include <QApplication>
#include <QTest>
#include <cstdio>
#include <cstdlib>

#include "comes.h"
#include "shell/main_window.h"
#include "shell/screenshot.h"
#include "text/language.h"
#include "theme/theme.h"
#include "workshop/model/job_desk.h"

int main(int argc, char** argv) {
    using namespace Qt::StringLiterals;
    using namespace ravnoves;
    QApplication app(argc, argv);
    QApplication::setApplicationName(u"Ravnoves"_s);
    QApplication::setOrganizationName(u"Ravnoves"_s);
    if (argc != 3) {
        std::fprintf(stderr, "usage: window_saver CASE FIRST\n");
        return 2;
    }
    installLanguage(u"en"_s);
    Theme::instance().install(Theme::Mode::Light);
    MainWindow window;
    window.beginSession();
    const QString trouble = window.openCase(QString::fromLocal8Bit(argv[1]));
    if (!trouble.isEmpty()) {
        std::fprintf(stderr, "%s\n", qPrintable(trouble));
        return 1;
    }
    window.show();
    if (!test::becomesActive(window)) {
        std::fprintf(stderr, "the window is not active\n");
        return 1;
    }
    const auto type = [&](const char* name, const QString& text) {
        auto* field = window.findChild<QWidget*>(QString::fromLatin1(name));
        if (field == nullptr) {
            std::fprintf(stderr, "no field %s\n", name);
            std::exit(1);
        }
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    };
    const auto said = [](const char* what, int number) {
        std::printf("%s %d\n", what, number);
        std::fflush(stdout);
    };
    for (int i = std::atoi(argv[2]);; ++i) {
        said("next", i);
        window.showScene(u"elastic-hinge"_s);
        applySetting(window, u"lambda=%1"_s.arg(0.2 + i % 100 * 1e-4));
        window.showScene(u"balance-shaft"_s);
        type("centre_distance_mm", QString::number(100.0 + i * 1e-3, 'f', 3));
        QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
        said("case", i);
        window.showScene(u"workshop"_s);
        auto* desk = window.findChild<JobDesk*>();
        // Without a name nothing is kept, and of one that the journal has it would ask.
        type("engine_number", u"53-%1"_s.arg(QString::fromLocal8Bit(argv[2])));
        type("technician", QString::number(i));
        const int before = desk->jobRevision();
        QTest::keyClick(&window, Qt::Key_F2);
        if (!test::comes([&] { return desk->jobRevision() != before; })) {
            std::fprintf(stderr, "the job is not saved\n");
            return 1;
        }
        said("job", i);
        QTest::qWait(1);
    }
}
