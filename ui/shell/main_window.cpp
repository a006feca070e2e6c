#include "shell/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>
#include <functional>

#include "model/recovery.h"
#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "pictures/figure.h"
#include "pictures/file_dialogs.h"
#include "report/case_report.h"
#include "report/report_dialog.h"
#include "shell/documents.h"
#include "shell/help_window.h"
#include "shell/new_cases.h"
#include "shell/recovery_dialog.h"
#include "shell/start_page.h"
#include "shell/variant_menu.h"
#include "shop/scale_button.h"
#include "studies/tolerance_window.h"
#include "text/plain_title.h"
#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "workshop/workshop_page.h"

namespace ravnoves {

using namespace std::chrono_literals;

MainWindow::MainWindow(First first) {
    setWindowIcon(themedIcon(QStringLiteral("ravnoves")));
    setMinimumSize(800, 500);
    resize(1280, 800);
    setAcceptDrops(true);
    setAnimated(false);  // a toolbar lays out nothing while it moves, nor when it has arrived
    documents_ = new Documents(this);
    scale_ = new ScaleButton(this);
    statusBar()->addPermanentWidget(scale_);
    connect(scale_, &ScaleButton::status, this, [this](const QString& text) { say(text, 10s); });
    connect(scale_, &ScaleButton::clicked, this, [this] {
        if (mayRenew(tr("Scale"))) {
            scale_->openSettings();
        }
    });
    buildNavigation();
    buildMenus();
    hint_ = new QLabel(this);
    statusBar()->addWidget(hint_, 1);
    statusBar()->setSizeGripEnabled(false);
    connect(documents_, &Documents::currentChanged, this, [this] {
        if (!documents_->hasCurrent()) {
            showStart();
        } else {
            isAtStart() ? leaveStart() : showCurrent();
        }
    });
    connect(documents_, &Documents::historyChanged, this, [this] {
        updateHistoryActions();
        if (!isAtStart()) {
            showHint(documents_->currentScene().summary);  // what was said is of before
        }
    });
    connect(documents_, &Documents::changed, this, [this] {
        updateCaseActions();
        updateTitle();
    });
    connect(documents_, &Documents::status, this, [this](const QString& text) {
        showHint(text.isEmpty() ? documents_->currentScene().summary : text);
        say(text);
    });
    connect(documents_, &Documents::saved, this,
            [this](const QString& path) { say(tr("Saved %1").arg(path)); });
    if (first == First::Scene) {
        documents_->showScene(documents_->scenes().front().name);
    }
    // Not at once: what the user chose in may be part of what is made again.
    connect(&Preferences::instance(), &Preferences::changed, this, &MainWindow::renew,
            Qt::QueuedConnection);

    const QSettings settings;
    if (settings.contains(QStringLiteral("window/geometry"))) {
        restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    }
}

MainWindow::~MainWindow() {
    // The field with the focus reports what was typed, and the title follows: while there is one.
    hide();
}

bool MainWindow::mayRenew(const QString& title) {
    const auto& documents = documents_->all();
    if (!std::ranges::all_of(documents, [&](const auto& each) {
            return saveWithoutRejected(each->page, title, documents_->nameOf(*each));
        })) {
        return false;
    }
    for (const auto& each : documents) {
        each->page->model()->leaveOutRejected();  // a page that is made again does not know them
    }
    return true;
}

void MainWindow::renew() {
    const QWidget* at = focusWidget();
    const QString field =
        at != nullptr && documents_->isAncestorOf(at) ? at->objectName() : QString();
    std::vector<std::pair<const OpenDocument*, QRect>> tolerances;  // open, to be open again
    for (const auto* open : findChildren<ToleranceWindow*>()) {
        for (const auto& each : documents_->all()) {
            if (open->isVisible() && open->page() == each->page) {
                tolerances.emplace_back(each.get(), open->geometry());
            }
        }
    }
    unsetLocale();
    {
        const QSignalBlocker quiet(documents_);
        documents_->renewPages();
    }
    const bool atStart = isAtStart();
    start_ = nullptr;
    documents_->setParent(this);
    delete takeCentralWidget();
    delete variants_;
    delete toolBar_;
    setMenuBar(new QMenuBar(this));
    scenes_.clear();
    sceneActions_.clear();
    caseActions_.clear();
    pageActions_.clear();
    qDeleteAll(findChildren<QActionGroup*>(QString(), Qt::FindDirectChildrenOnly));
    qDeleteAll(findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly));
    buildNavigation();
    buildMenus();
    documents_->show();
    for (const auto& [document, place] : tolerances) {
        openTolerances(document->page)->setGeometry(place);
    }
    if (atStart) {
        showStart();
        return;
    }
    showCurrent();
    // One goes on where one was. Only a field that is seen keeps the focus; Qt would show it later.
    centralWidget()->show();
    if (auto* again = field.isEmpty() ? nullptr : currentPage()->findChild<QWidget*>(field)) {
        again->setFocus();
    }
}

void MainWindow::showTolerances() {
    for (auto* open : findChildren<ToleranceWindow*>()) {
        if (open->page() == currentPage() && open->isVisible()) {
            open->raise();
            open->activateWindow();
            return;
        }
    }
    openTolerances(currentPage());
}

ToleranceWindow* MainWindow::openTolerances(ScenePage* page) {
    auto* window = new ToleranceWindow(page, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    connect(window, &ToleranceWindow::saveWanted, this, [this, page] {
        for (const auto& each : documents_->all()) {
            if (each->page == page) {
                documents_->save(*each);
            }
        }
    });
    window->show();
    return window;
}

bool MainWindow::showScene(const QString& name) {
    return documents_->showScene(name);
}

bool MainWindow::isAtStart() const {
    return start_ != nullptr;
}

void MainWindow::showStart() {
    if (isAtStart()) {
        return;
    }
    start_ = new StartPage(front_);
    front_->addWidget(start_);
    connect(start_, &StartPage::sceneRequested, this, &MainWindow::goToScene);
    connect(start_, &StartPage::newRequested, this, &MainWindow::beginOrSayWhy);
    connect(start_, &StartPage::openRequested, this,
            [this](const QString& path) { openOrSayWhy({path}); });
    connect(start_, &StartPage::openDialogRequested, this, &MainWindow::openWithDialog);
    connect(start_, &StartPage::journalRequested, this, [this] { showWorkshop()->showJournal(); });
    connect(start_, &StartPage::jobRequested, this,
            [this](qint64 id) { showWorkshop()->openJob(id); });
    if (documents_->hasCurrent()) {
        currentPage()->setActive(false);
    }
    front_->setCurrentWidget(start_);
    start_->setFocus();
    showCurrent();
}

void MainWindow::leaveStart() {
    if (isAtStart()) {
        front_->setCurrentWidget(documents_);
        std::exchange(start_, nullptr)->deleteLater();  // a button of it may be what was pressed
        if (QWidget* field = currentPage()->focusWidget()) {
            field->setFocus(Qt::OtherFocusReason);
        }
        currentPage()->setActive(true);
        showCurrent();
    }
}

WorkshopPage* MainWindow::showWorkshop() {
    showScene(QStringLiteral("workshop"));
    return static_cast<WorkshopPage*>(currentPage());
}

QString MainWindow::currentScene() const {
    return documents_->currentScene().name;
}

ScenePage* MainWindow::currentPage() const {
    return documents_->current().page;
}

QString MainWindow::openCase(const QString& path) {
    return documents_->open(path);
}

void MainWindow::goToScene(const QString& scene) {
    const bool isOpen = std::ranges::any_of(documents_->all(), [&](const auto& each) {
        return each->page->model()->sceneName() == scene;
    });
    if (isOpen || !newCase(scene, true)) {
        showScene(scene);
    }
}

bool MainWindow::newCase(const QString& scene, bool isFirst) {
    const std::vector<NewCase> cases = newCases();
    const auto first = std::ranges::find(cases, scene, &NewCase::scene);
    return first != cases.end() && documents_->begin(first->make(), isFirst).isEmpty();
}

void MainWindow::beginOrSayWhy(const CaseFile& file) {
    const QString trouble = documents_->begin(file);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("New case"), trouble);
    }
}

void MainWindow::beginSession() {
    recovery_ = new Recovery(Recovery::defaultFolder(), this);
    connect(recovery_, &Recovery::failed, this, [this](const QString& why) { say(why, 10s); });
    documents_->keepIn(recovery_);
}

void MainWindow::offerRecovered() {
    ravnoves::offerRecovered(this, recovery_->leftBehind(),
                             std::bind_front(&Documents::restore, documents_));
}

void MainWindow::showCurrent() {
    const bool atStart = isAtStart();
    (atStart ? startAction_ : scenes_[documents_->current().scene])->setChecked(true);
    showHint(atStart ? QString() : documents_->currentScene().summary);
    for (QAction* action : pageActions_) {
        action->setEnabled(!atStart);
    }
    updateCaseActions();
    updateHistoryActions();
    updateSceneActions();
    updateTitle();
}

void MainWindow::showHint(const QString& text) {
    hint_->setText(text);
    hint_->setToolTip(text);  // a narrow window cuts it
}

void MainWindow::say(const QString& text, std::chrono::milliseconds during) {
    said_.setRemainingTime(text.isEmpty() ? 0ms : during);
    statusBar()->showMessage(text, static_cast<int>(during.count()));
}

bool MainWindow::event(QEvent* event) {
    // A tip, or that the pointer has left what had one.
    const bool isPassed = event->type() == QEvent::StatusTip && !said_.hasExpired();
    return isPassed || QMainWindow::event(event);
}

void MainWindow::updateCaseActions() {
    const bool hasCase = !documents_->hasCurrent() || currentPage()->model()->hasCaseFile();
    for (QAction* action : caseActions_) {
        action->setEnabled(hasCase && !isAtStart());
        action->setToolTip(hasCase ? action->data().toString()
                                   : tr("This page has no case file: its numbers are measured each "
                                        "time. Copy or export them."));
    }
    if (hasCase && documents_->hasCurrent()) {
        const QString file = documents_->current().document->path();
        const QString where =
            file.isEmpty() ? currentPage()->savingTip() : tr("Save %1").arg(plainTitle(file));
        if (!where.isEmpty()) {
            save_->setToolTip(where + QStringLiteral(" (%1)").arg(
                                          save_->shortcut().toString(QKeySequence::NativeText)));
        }
    }
    save_->setStatusTip(save_->toolTip());
    nextTab_->setEnabled(documents_->hasSeveralTabs());
    previousTab_->setEnabled(documents_->hasSeveralTabs());
}

void MainWindow::updateHistoryActions() {
    const SceneModel* model = documents_->hasCurrent() ? currentPage()->model() : nullptr;
    const auto show = [this](QAction* action, bool enabled, const QString& name,
                             const QString& step) {
        action->setEnabled(enabled && !isAtStart());
        action->setText(step.isEmpty() ? name : name + QLatin1Char(' ') + step);
    };
    const QUndoStack none;
    const QUndoStack& history = model != nullptr ? *model->history() : none;
    // What is rejected is in no history; undo takes it back.
    const bool isRejected = model != nullptr && model->hasRejected();
    show(undo_, isRejected || history.canUndo(), tr("&Undo"),
         isRejected ? QString() : history.undoText());
    show(redo_, history.canRedo(), tr("&Redo"), history.redoText());
}

void MainWindow::updateSceneActions() {
    variants_->setPage(isAtStart() ? nullptr : currentPage());
    for (QAction* action : sceneActions_) {
        toolBar_->removeAction(action);
    }
    sceneActions_.clear();
    sceneMenu_->clear();
    const QList<QAction*> actions = isAtStart() ? QList<QAction*>() : currentPage()->sceneActions();
    for (QAction* action : actions) {
        if (action == nullptr) {
            sceneMenu_->addSeparator();
            continue;
        }
        sceneMenu_->addAction(action);
        if (!action->icon().isNull()) {
            toolBar_->addAction(action);
            sceneActions_ << action;
        }
    }
    const QString title = isAtStart() ? QString() : documents_->currentScene().title;
    sceneMenu_->setTitle(title);
    sceneMenu_->menuAction()->setVisible(!actions.isEmpty());
}

void MainWindow::updateTitle() {
    if (isAtStart() || !documents_->hasCurrent()) {
        setWindowTitle(QStringLiteral("Ravnoves"));
        setWindowModified(false);
        return;
    }
    const CaseDocument& document = *documents_->current().document;
    const QString scene = documents_->currentScene().title;
    const QString name = document.name();
    // A file, then what the case calls itself where its file does not say so.
    const QString title = document.model()->titleShown();
    const bool isNamed = !title.isEmpty() && !name.startsWith(title);
    const auto literally = [](QString text) {  // "[*]" is where Qt marks what is not saved
        return text.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
    };
    setWindowTitle((name.isEmpty()
                        ? scene + QStringLiteral("[*]")
                        : literally(name) + QStringLiteral("[*] – ") +
                              (isNamed ? literally(title) + QStringLiteral(" – ") : QString()) +
                              scene) +
                   QStringLiteral(" – Ravnoves"));
    setWindowModified(document.needsSaving());
}

void MainWindow::openOrSayWhy(const QStringList& paths) {
    constexpr qsizetype maximum = 20;  // each has a page
    QStringList troubles;
    for (const QString& path : paths.mid(0, maximum)) {
        troubles << documents_->open(path, paths.size() == 1);
    }
    troubles.removeAll(QString());
    if (paths.size() > maximum) {
        troubles << Documents::tr("Too many files; not opened: %1").arg(paths.size() - maximum);
    }
    if (!troubles.isEmpty()) {
        QMessageBox::warning(this, tr("Open case"), troubles.join(QLatin1Char('\n')));
    }
}

void MainWindow::openWithDialog() {
    const QString file =
        documents_->hasCurrent() ? documents_->current().document->path() : QString();
    const QString path =
        askOpenPath(this, tr("Open case"), file.isEmpty() ? file : QFileInfo(file).absolutePath(),
                    tr("Ravnoves cases (*.case.json *.json);;All files (*)"));
    if (!path.isEmpty()) {
        openOrSayWhy({path});
    }
}

void MainWindow::exportPicture() {
    ScenePage* page = currentPage();
    const auto draw = [page](QPainter& painter, double scale) {
        constexpr double dots = 3.125;  // 300 to the inch, in every format
        QImage picture(page->size() * dots, QImage::Format_RGB32);
        picture.setDevicePixelRatio(dots);
        page->render(&picture);
        painter.scale(scale, scale);
        painter.drawImage(0, 0, picture);
    };
    savePictureWithDialog(this, tr("Save page as picture"), currentScene() + QStringLiteral(".png"),
                          {}, [&](const QString& path) {
                              return writePicture(path, page->size(),
                                                  documents_->current().document->name(), draw);
                          });
}

void MainWindow::copyResults(QString (ScenePage::*results)() const, const QString& said) {
    if (continueWithoutRejected(currentPage(), tr("Copy results"))) {
        QApplication::clipboard()->setText((currentPage()->*results)());
        say(said);
    }
}

QString MainWindow::writeReport(const QString& path, const Patience& patience) {
    return ravnoves::writeReport(*currentPage(), *documents_->current().document, path, patience);
}

void MainWindow::exportReport() {
    if (!continueWithoutRejected(currentPage(), tr("Report"))) {
        return;
    }
    if (ReportDialog(this).exec() != QDialog::Accepted) {
        return;
    }
    const QFileInfo file(documents_->current().document->path());
    const QString name = file.filePath().isEmpty()
                             ? currentScene()
                             : file.absolutePath() + QLatin1Char('/') +
                                   file.fileName().section(QLatin1Char('.'), 0, 0);
    const QString path = askSavePath(this, tr("Report"), name + QStringLiteral(".pdf"),
                                     {pdfFormat(), {QStringLiteral("html"), tr("Web page")}});
    if (path.isEmpty()) {
        return;
    }
    // Tolerances take up to a minute.
    QProgressDialog progress(tr("Writing the report…"), tr("Cancel"), 0, 0, this);
    progress.setWindowTitle(tr("Report"));
    progress.setWindowModality(Qt::ApplicationModal);
    // The Return that ended the dialog before, or one more, cancels nothing: Space and Escape do.
    progress.findChild<QPushButton*>()->setAutoDefault(false);
    progress.show();
    // That, and what the file dialog lay over: nothing of this window is painted while its tabs are
    // gone through.
    QApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    const QString trouble =
        writeReport(path, Patience([&progress] { return progress.wasCanceled(); }));
    progress.hide();
    if (progress.wasCanceled()) {
        say(tr("Cancelled: the report was not written."), 10s);
    } else if (trouble.isEmpty()) {
        say(tr("Report written: %1").arg(path));
    } else {
        QMessageBox::warning(this, tr("Report"), trouble);
    }
}

void MainWindow::showHelp(const QString& topic) {
    if (auto* open = findChild<HelpWindow*>(QString(), Qt::FindDirectChildrenOnly)) {
        open->goTo(topic);
        return;
    }
    auto* window = new HelpWindow(topic, this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->show();
}

void MainWindow::showAbout() {
    QMessageBox box(this);
    box.setWindowTitle(tr("About Ravnoves"));
    box.setIconPixmap(windowIcon().pixmap(Theme::withText(64)));
    box.setTextFormat(Qt::RichText);
    box.setText(tr("<h3>Ravnoves %1</h3>"
                   "<p>The engine-balancing workbench.</p>"
                   "<p>Free software under the GNU General Public License, version 3 or later; "
                   "it comes without any warranty.</p>")
                    .arg(QStringLiteral(RAVNOVES_VERSION)));
    box.exec();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!documents_->canClose()) {
        event->ignore();
        return;
    }
    if (recovery_ != nullptr) {
        recovery_->releaseAll();
    }
    QSettings().setValue(QStringLiteral("window/geometry"), saveGeometry());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) {
        paths << url.toLocalFile();
    }
    openOrSayWhy(paths);
}

}  // namespace ravnoves
