#include "shell/screenshot.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QRegularExpression>
#include <QTabWidget>

#include "case-file/input_error.h"
#include "model/case_sources.h"
#include "shell/main_window.h"
#include "shell/scene_page.h"

namespace ravnoves {

QString applySetting(MainWindow& window, const QString& pair) {
    const qsizetype equals = pair.indexOf(QLatin1Char('='));
    if (equals <= 0) {
        return QStringLiteral("--set: must be key=value, got %1").arg(pair);
    }
    ScenePage* page = window.currentPage();
    if (pair.startsWith(QLatin1String("tab="))) {
        // Any tab of the page by its object name, so that a picture can show it.
        const QString wanted = pair.mid(4);
        QStringList names;
        for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                const QString name = tabs->widget(i)->objectName();
                if (name == wanted) {
                    tabs->setCurrentIndex(i);
                    return {};
                }
                if (!name.isEmpty()) {
                    names << name;
                }
            }
        }
        if (names.isEmpty()) {
            return QStringLiteral("--set: this page has no tabs to choose");
        }
        return QStringLiteral("--set: tab must be one of %1, got %2")
            .arg(names.join(QLatin1String(", ")), wanted);
    }
    try {
        page->model()->setByKey(pair.left(equals), pair.mid(equals + 1));
    } catch (const InputError& error) {
        return QStringLiteral("--set: ") + QString::fromUtf8(error.what());
    }
    return {};
}

QString writeScreenshot(MainWindow& window, const QString& path, const QString& size) {
    static const QRegularExpression form(QStringLiteral("^(\\d{3,4})[xX×](\\d{3,4})$"));
    const QRegularExpressionMatch match = form.match(size);
    if (!match.hasMatch()) {
        return QStringLiteral("--size: must be like 1280x800, got %1").arg(size);
    }
    if (!path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
        return QStringLiteral("--screenshot: must end in .png, got %1").arg(path);
    }
    const QString source = sourceTrouble(path);
    if (!source.isEmpty()) {
        return source;
    }
    window.resize(match.captured(1).toInt(), match.captured(2).toInt());
    window.show();
    // Layout, then the plots' first drawing, are done when the queue is empty.
    for (int turn = 0; turn < 3; ++turn) {
        QApplication::processEvents();
    }
    // What is computed in the background belongs in the picture.
    QElapsedTimer waited;
    waited.start();
    const auto busy = [&window] { return window.currentPage()->isBusy(); };
    constexpr int patience = 60'000;  // ms
    while (busy() && waited.elapsed() < patience) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    }
    QApplication::processEvents();
    if (QWidget* focus = QApplication::focusWidget()) {
        focus->clearFocus();  // no blinking text cursor in the picture
    }
    QApplication::processEvents();
    if (!window.grab().save(path, "PNG")) {
        return path + QStringLiteral(": cannot be written");
    }
    return {};
}

}  // namespace ravnoves
