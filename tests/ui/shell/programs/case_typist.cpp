// Opens a case in the program's window and types into a field of it for ever, and says on standard
// output what it has typed and when: "typed VALUE MILLISECONDS". It is there to be killed.

#include <QApplication>
#include <QDateTime>
#include <QTest>
#include <cstdio>

#include "model/scene_model.h"
#include "shell/main_window.h"
#include "page/scene_page.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/number_field.h"

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Ravnoves"));
    QApplication::setOrganizationName(QStringLiteral("Ravnoves"));
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() != 3) {
        std::fprintf(stderr, "usage: case_typist CASE FIELD\n");
        return 2;
    }
    ravnoves::installLanguage(QStringLiteral("en"));
    ravnoves::Theme::instance().install(ravnoves::Theme::Mode::Light);
    ravnoves::MainWindow window;
    window.beginSession();
    const QString trouble = window.openCase(arguments.at(1));
    if (!trouble.isEmpty()) {
        std::fprintf(stderr, "%s\n", qPrintable(trouble));
        return 1;
    }
    window.show();
    window.activateWindow();
    auto* field = window.currentPage()->findChild<ravnoves::NumberField*>(arguments.at(2));
    if (field == nullptr) {
        std::fprintf(stderr, "no such field\n");
        return 1;
    }
    field->setFocus();
    for (int value = 100; value < 100000; ++value) {
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, QString::number(value / 10.0));
        std::printf("typed %d %lld\n", value,
                    static_cast<long long>(QDateTime::currentMSecsSinceEpoch()));
        std::fflush(stdout);
        QTest::qWait(20);
    }
    return 0;
}
