#include "shell/screenshot.h"

#include <QApplication>
#include <QBuffer>
#include <QRegularExpression>
#include <QTabWidget>

#include "case-file/input_error.h"
#include "model/case_document.h"
#include "page/scene_page.h"
#include "report/patience.h"
#include "shell/main_window.h"
#include "text/write_file.h"
#include "widgets/page_columns.h"

namespace ravnoves {

namespace {

constexpr const char* shownTab = "shownTab";  ///< of a page: the tab that a picture shall show

/// Brings any tab of the page to the front by its object name, also where it is folded into
/// another one.
/// @return false where there is none; `names` are those that there are
bool showTab(ScenePage* page, const QString& wanted, QStringList& names) {
    for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
        for (int i = 0; i < tabs->count(); ++i) {
            const QString name = tabs->widget(i)->objectName();
            if (name == wanted) {
                showTabOf(tabs->widget(i));
                return true;
            }
            if (!name.isEmpty()) {
                names << name;
            }
        }
    }
    return false;
}

}  // namespace

QString applySetting(MainWindow& window, const QString& pair) {
    const qsizetype equals = pair.indexOf(QLatin1Char('='));
    if (equals <= 0) {
        return QStringLiteral("--set: must be key=value, got %1").arg(pair);
    }
    ScenePage* page = window.currentPage();
    if (pair.startsWith(QLatin1String("tab="))) {
        const QString wanted = pair.mid(4);
        QStringList names;
        if (showTab(page, wanted, names)) {
            page->setProperty(shownTab, wanted);
            return {};
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

QString setWindowSize(MainWindow& window, const QString& size) {
    static const QRegularExpression form(QStringLiteral("^(\\d{3,4})[xX×](\\d{3,4})$"));
    const QRegularExpressionMatch match = form.match(size);
    if (!match.hasMatch()) {
        return QStringLiteral("--size: must be like 1280x800, got %1").arg(size);
    }
    window.setWindowState(window.windowState() & ~Qt::WindowMaximized);  // as it was left
    window.resize(match.captured(1).toInt(), match.captured(2).toInt());
    return {};
}

QString writeScreenshot(MainWindow& window, const QString& path) {
    if (!path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
        return QStringLiteral("--screenshot: must end in .png, got %1").arg(path);
    }
    QString source = sourceTrouble(path);
    if (!source.isEmpty()) {
        return source;
    }
    window.show();
    // Layout, then the plots' first drawing, are done when the queue is empty.
    for (int turn = 0; turn < 3; ++turn) {
        QApplication::processEvents();
    }
    // At this size it may be folded into a tab of the page.
    const QString tab = window.currentPage()->property(shownTab).toString();
    if (QStringList names; !tab.isEmpty()) {
        showTab(window.currentPage(), tab, names);
    }
    QApplication::processEvents();
    // What is computed in the background belongs in the picture.
    constexpr int longest = 60'000;  // ms
    Patience().waitWhile([&window] { return window.currentPage()->isBusy(); }, longest);
    if (QWidget* focus = QApplication::focusWidget()) {
        focus->clearFocus();  // no blinking text cursor in the picture
    }
    QApplication::processEvents();
    // Drawn before the file is begun: an old picture stays whole when that fails.
    QBuffer picture;
    picture.open(QIODevice::WriteOnly);
    if (!window.grab().save(&picture, "PNG")) {
        return path + QStringLiteral(": cannot be written");
    }
    return writeFile(path, [&] { return picture.data().toStdString(); });
}

}  // namespace ravnoves
