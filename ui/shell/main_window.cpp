#include "shell/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "model/recovery.h"
#include "plot/picture_file.h"
#include "report/case_report.h"
#include "shell/case_properties.h"
#include "shell/documents.h"
#include "shell/help_window.h"
#include "shell/new_case_dialog.h"
#include "shell/page_drawing.h"
#include "shell/recovery_dialog.h"
#include "shell/refused_entries.h"
#include "shell/scene_page.h"
#include "shell/settings_dialog.h"
#include "shell/start_page.h"
#include "shell/variant_menu.h"
#include "shell/whats_this.h"
#include "studies/band_progress.h"
#include "studies/tolerance_switch.h"
#include "studies/tolerance_window.h"
#include "text/language.h"
#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/file_dialogs.h"
#include "widgets/plain_text.h"
#include "workshop/scale_button.h"

namespace ravnoves {

namespace {

constexpr int navigationWidth = 104;

const QString restoreKey = QStringLiteral("session/restore");
const QString filesKey = QStringLiteral("session/files");
const QString currentKey = QStringLiteral("session/current");  ///< a file, or a scene

/// A title that is wider than `room`, broken at the last blank where the first line fits.
QString inTwoLines(QString title, const QFontMetrics& metrics, int room) {
    if (metrics.horizontalAdvance(title) <= room) {
        return title;
    }
    qsizetype at = title.lastIndexOf(QLatin1Char(' '));
    while (at > 0 && metrics.horizontalAdvance(title.left(at)) > room) {
        at = title.lastIndexOf(QLatin1Char(' '), at - 1);
    }
    return at > 0 ? title.replace(at, 1, QLatin1Char('\n')) : title;
}

}  // namespace

MainWindow::MainWindow(First first) {
    keepTextPlain();
    setWindowIcon(QIcon(QStringLiteral(":/icons/ravnoves.svg")));
    setMinimumSize(800, 500);
    resize(1280, 800);
    setAcceptDrops(true);
    documents_ = new Documents(this);
    scale_ = new ScaleButton(this);
    auto* bands = new BandProgress(this);
    statusBar()->addPermanentWidget(bands);
    connect(bands, &BandProgress::stopped, this,
            [this](const QString& what) { statusBar()->showMessage(what, 10'000); });
    statusBar()->addPermanentWidget(scale_);
    connect(scale_, &ScaleButton::status, this,
            [this](const QString& text) { statusBar()->showMessage(text, 10'000); });
    buildNavigation();
    buildMenus();
    hint_ = new QLabel(this);
    statusBar()->addWidget(hint_, 1);
    statusBar()->setSizeGripEnabled(false);
    connect(documents_, &Documents::currentChanged, this,
            [this] { isAtStart() ? leaveStart() : showCurrent(); });
    connect(documents_, &Documents::currentAsked, this, &MainWindow::leaveStart);
    connect(documents_, &Documents::titleChanged, this, &MainWindow::updateTitle);
    connect(documents_, &Documents::refusedInChanged, this, &MainWindow::updateHistoryActions);
    connect(documents_, &Documents::historyChanged, this, [this] {
        updateHistoryActions();
        if (!isAtStart()) {
            hint_->setText(documents_->currentScene().summary);  // what was said is of before
        }
    });
    connect(documents_, &Documents::changed, this, &MainWindow::updateCaseActions);
    connect(documents_, &Documents::status, this, [this](const QString& text) {
        hint_->setText(text.isEmpty() ? documents_->currentScene().summary : text);
    });
    connect(documents_, &Documents::saved, this, [this](const QString& path) {
        statusBar()->showMessage(tr("Saved %1").arg(path), 3000);
    });
    if (first == First::Scene) {
        documents_->showScene(documents_->scenes().front().name);
    }
    // Not at once: what the user chose in may be part of what is made anew.
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

void MainWindow::renew() {
    const QWidget* at = focusWidget();
    const QString field =
        at != nullptr && documents_->isAncestorOf(at) ? at->objectName() : QString();
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
    delete whatsThis_;
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

void MainWindow::buildNavigation() {
    auto* centre = new QWidget(this);
    auto* row = new QHBoxLayout(centre);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);

    startAction_ = new QAction(themedIcon(QStringLiteral("start")), tr("Start"), this);
    startAction_->setCheckable(true);
    startAction_->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Home));
    startAction_->setToolTip(
        tr("Scenes, recent files, examples") +
        QStringLiteral(" (%1)").arg(startAction_->shortcut().toString(QKeySequence::NativeText)));
    connect(startAction_, &QAction::toggled, this, [this](bool on) {
        if (on) {
            showStart();
        }
    });

    auto* navigation = new QWidget(centre);
    navigation->setFixedWidth(Theme::withText(navigationWidth));
    navigation->setAutoFillBackground(true);
    auto* column = new QVBoxLayout(navigation);
    column->setContentsMargins(Theme::gap, Theme::gap, Theme::gap, Theme::gap);
    column->setSpacing(2);  // all are seen in a window of 540 pixels
    sceneGroup_ = new QActionGroup(this);
    sceneGroup_->addAction(startAction_);
    // In a window that is too low for all of them they scroll; what is open or has the focus is
    // seen.
    auto* area = new QScrollArea(centre);
    const auto addButton = [&](QAction* action, int height) {
        auto* button = new QToolButton(navigation);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setIconSize(QSize(Theme::withText(28), Theme::withText(28)));
        button->setAutoRaise(true);
        button->setFont(Theme::font(Theme::smallSize));
        action->setIconText(
            inTwoLines(action->text(), button->fontMetrics(),
                       Theme::withText(navigationWidth) - 2 * Theme::gap - Theme::space));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setMinimumHeight(std::max(height, button->sizeHint().height()));
        button->setFocusPolicy(Qt::TabFocus);
        column->addWidget(button);
        connect(action, &QAction::toggled, area, [area, button](bool on) {
            if (on) {
                area->ensureWidgetVisible(button, 0, Theme::gap);
            }
        });
    };
    addButton(startAction_, 0);
    for (const SceneInfo& info : documents_->scenes()) {
        const int key = static_cast<int>(scenes_.size()) + 1;
        auto* action =
            new QAction(themedIcon(QStringLiteral("scene-") + info.name), info.title, this);
        action->setCheckable(true);
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + key)));
        action->setToolTip(info.summary + QStringLiteral(" (Ctrl+%1)").arg(key));
        action->setStatusTip(info.summary);
        sceneGroup_->addAction(action);
        // A screen reader toggles the button without a click.
        connect(action, &QAction::toggled, this, [this, name = info.name](bool on) {
            if (on) {
                showScene(name);
            }
        });
        addButton(action, Theme::withText(58));
        scenes_.push_back(action);
    }
    column->addStretch();
    area->setObjectName(QStringLiteral("navigation"));
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    area->setWidget(navigation);
    area->setFixedWidth(navigation->minimumWidth());
    QScrollBar* bar = area->verticalScrollBar();
    connect(bar, &QScrollBar::rangeChanged, area, [area, navigation, bar](int, int last) {
        area->setFixedWidth(navigation->minimumWidth() + (last > 0 ? bar->sizeHint().width() : 0));
    });
    const auto showChecked = [area, navigation, bar] {
        for (QToolButton* button : navigation->findChildren<QToolButton*>()) {
            if (button->isChecked()) {
                // From the top: the window was lower while it was laid out.
                bar->setValue(0);
                area->ensureWidgetVisible(button, 0, Theme::gap);
            }
        }
    };
    // Once the buttons are laid out.
    connect(bar, &QScrollBar::rangeChanged, area, showChecked, Qt::QueuedConnection);
    connect(qApp, &QApplication::focusChanged, area,
            [area, navigation](const QWidget* was, QWidget* now) {
                // Not where a window gets the focus that comes first.
                if (was != nullptr && now != nullptr && navigation->isAncestorOf(now)) {
                    area->ensureWidgetVisible(now, 0, Theme::gap);
                }
            });
    row->addWidget(area);
    auto* line = new QFrame(centre);
    line->setFrameShape(QFrame::VLine);
    line->setFrameShadow(QFrame::Plain);
    line->setForegroundRole(QPalette::Mid);
    line->setFixedWidth(1);
    row->addWidget(line);
    front_ = new QStackedWidget(centre);
    front_->addWidget(documents_);
    row->addWidget(front_, 1);
    setCentralWidget(centre);
}

void MainWindow::buildMenus() {
    const auto add = [this](QMenu* menu, const QString& icon, const QString& text,
                            const QKeySequence& keys, auto&& slot) {
        auto* action = new QAction(icon.isEmpty() ? QIcon() : themedIcon(icon), text, this);
        action->setShortcut(keys);
        QString tip = text;
        tip.remove(QLatin1Char('&')).remove(QChar(0x2026));
        if (!keys.isEmpty()) {
            tip += QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
        }
        action->setToolTip(tip);
        connect(action, &QAction::triggered, this, slot);
        menu->addAction(action);
        return action;
    };

    QMenu* file = menuBar()->addMenu(tr("&File"));
    QAction* fresh = add(file, QStringLiteral("new"), tr("&New case"), QKeySequence::New,
                         [this] { newCase(currentScene()); });
    newFrom_ = add(file, {}, tr("New case &from…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
                   [this] { beginWithDialog(); });
    QAction* open = add(file, QStringLiteral("open"), tr("&Open case…"), QKeySequence::Open,
                        [this] { openWithDialog(); });
    recentMenu_ = file->addMenu(tr("Open &recent"));
    connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::fillRecentFiles);
    examplesMenu_ = file->addMenu(tr("E&xamples"));
    connect(examplesMenu_, &QMenu::aboutToShow, this, &MainWindow::fillExamples);
    QAction* saveAction = add(file, QStringLiteral("save"), tr("&Save case"), QKeySequence::Save,
                              [this] { documents_->current().document->save(); });
    QAction* saveAsAction =
        add(file, {}, tr("Save case &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
            [this] { documents_->current().document->saveAs(); });
    file->addSeparator();
    QAction* picture = add(file, QStringLiteral("picture"), tr("Save page as &picture…"),
                           QKeySequence(Qt::CTRL | Qt::Key_E), [this] { exportPicture(); });
    QAction* report = add(file, QStringLiteral("pdf"), tr("Repor&t…"),
                          QKeySequence(Qt::CTRL | Qt::Key_R), [this] { exportReport(); });
    file->addSeparator();
    QAction* close = add(file, {}, tr("&Close case"), QKeySequence(Qt::CTRL | Qt::Key_W),
                         [this] { documents_->closeCurrent(); });
    file->addSeparator();
    QAction* restores = add(file, {}, tr("Open the same cases at the next s&tart"), {}, [] {});
    restores->setCheckable(true);
    restores->setChecked(QSettings().value(restoreKey, false).toBool());
    connect(restores, &QAction::toggled, this, [this](bool on) {
        QSettings().setValue(restoreKey, on);
        rememberSession();
    });
    add(file, {}, tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { this->close(); });

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    undo_ = add(edit, QStringLiteral("undo"), tr("&Undo"), QKeySequence::Undo, [this] {
        // What is refused is the newest of all, and in no history.
        if (SceneModel& model = *currentPage()->model(); !takeBackRefused(model)) {
            model.undo();
        }
    });
    redo_ = add(edit, QStringLiteral("redo"), tr("&Redo"), {},
                [this] { currentPage()->model()->redo(); });
    redo_->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::Key_Y), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
    edit->addSeparator();
    QAction* copyText = add(edit, QStringLiteral("copy"), tr("Copy results as &text"),
                            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C), [this] {
                                QApplication::clipboard()->setText(currentPage()->resultsAsText());
                                statusBar()->showMessage(tr("Results copied as text"), 3000);
                            });
    QAction* copyCsv = add(edit, {}, tr("Copy results as &CSV"), {}, [this] {
        QApplication::clipboard()->setText(currentPage()->resultsAsCsv());
        statusBar()->showMessage(tr("Results copied as CSV"), 3000);
    });

    edit->addSeparator();
    variants_ = new VariantMenu(this);
    edit->addMenu(variants_);
    QAction* tolerances =
        add(edit, QStringLiteral("tolerances"), tr("T&olerances…"),
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T), [this] { showTolerances(); });
    QAction* properties =
        add(edit, {}, tr("Title and &notes…"), QKeySequence(Qt::CTRL | Qt::Key_I), [this] {
            auto* dialog = new CaseProperties(currentPage()->model(), this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
        });
    add(edit, {}, tr("&Settings…"), QKeySequence(Qt::CTRL | Qt::Key_Comma), [this] {
        auto* dialog = new SettingsDialog(this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    add(edit, {}, tr("Sca&le…"), {}, [this] { scale_->openSettings(); });

    sceneMenu_ = menuBar()->addMenu(tr("&Scene"));

    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addAction(startAction_);
    view->addActions(QList<QAction*>(scenes_.begin(), scenes_.end()));
    view->addSeparator();
    nextTab_ = add(view, {}, tr("Ne&xt case"), QKeySequence(Qt::CTRL | Qt::Key_Tab),
                   [this] { documents_->step(1); });
    previousTab_ =
        add(view, {}, tr("Pre&vious case"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Tab),
            [this] { documents_->step(-1); });
    view->addSeparator();
    QAction* reset =
        add(view, QStringLiteral("reset-zoom"), tr("Reset &zoom of all plots"),
            QKeySequence(Qt::CTRL | Qt::Key_0), [this] { currentPage()->resetZoom(); });
    QAction* bands = add(view, {}, tr("Tolerance &bands"), {}, [] {});
    bands->setCheckable(true);
    bands->setChecked(ToleranceSwitch::instance().isOn());
    bands->setStatusTip(
        tr("Bands about the curves and ± beside the numbers, where the case has "
           "tolerances"));
    connect(bands, &QAction::toggled, &ToleranceSwitch::instance(), &ToleranceSwitch::setOn);
    connect(&ToleranceSwitch::instance(), &ToleranceSwitch::changed, bands, &QAction::setChecked);
    add(view, {}, tr("&Full screen"), QKeySequence(Qt::Key_F11),
        [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    view->addSeparator();
    QMenu* themes = view->addMenu(themedIcon(QStringLiteral("theme")), tr("&Theme"));
    auto* themeGroup = new QActionGroup(this);
    const std::vector<std::pair<Theme::Mode, QString>> modes{
        {Theme::Mode::System, tr("As the &desktop")},
        {Theme::Mode::Light, tr("&Light")},
        {Theme::Mode::Dark, tr("&Dark")}};
    for (const auto& [mode, text] : modes) {
        QAction* action = themes->addAction(text, this, [mode = mode] {
            Theme::instance().setMode(mode);
            QSettings().setValue(QStringLiteral("view/theme"), static_cast<int>(mode));
        });
        action->setCheckable(true);
        themeGroup->addAction(action);
        const auto check = [action, mode = mode] {
            action->setChecked(Theme::instance().mode() == mode);
        };
        check();
        connect(&Theme::instance(), &Theme::changed, action, check);
    }
    QMenu* languages = view->addMenu(tr("L&anguage"));
    auto* languageGroup = new QActionGroup(this);
    for (const Language& language : availableLanguages()) {
        QAction* action = languages->addAction(language.ownName, this, [language] {
            Preferences::instance().setLanguage(language.code);
        });
        action->setCheckable(true);
        action->setChecked(language.code == currentLanguage());
        languageGroup->addAction(action);
    }

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    add(help, QStringLiteral("help"), tr("&About this page: formulas and sources"),
        QKeySequence::HelpContents,
        [this] { showHelp(isAtStart() ? QStringLiteral("keys") : currentScene()); });
    add(help, {}, tr("&Case files and command line"), {},
        [this] { showHelp(QStringLiteral("case-files")); });
    add(help, {}, tr("&Variants: one design against another"), {},
        [this] { showHelp(QStringLiteral("variants")); });
    add(help, {}, tr("&Tolerances: how sure a result is"), {},
        [this] { showHelp(QStringLiteral("tolerances")); });
    add(help, {}, tr("&Keys and mouse"), {}, [this] { showHelp(QStringLiteral("keys")); });
    whatsThis_ = new WhatsThis(this);
    help->addAction(whatsThis_->action());
    help->addSeparator();
    add(help, {}, tr("About &Ravnoves"), {}, [this] { showAbout(); });

    toolBar_ = addToolBar(tr("Main toolbar"));
    toolBar_->setObjectName(QStringLiteral("main-toolbar"));
    toolBar_->setMovable(false);
    toolBar_->setIconSize(QSize(Theme::withText(20), Theme::withText(20)));
    toolBar_->addActions({fresh, open, saveAction});
    newMenu_ = new QMenu(toolBar_);
    connect(newMenu_, &QMenu::aboutToShow, this, &MainWindow::fillNewMenu);
    auto* newButton = qobject_cast<QToolButton*>(toolBar_->widgetForAction(fresh));
    newButton->setMenu(newMenu_);
    newButton->setPopupMode(QToolButton::MenuButtonPopup);
    toolBar_->addSeparator();
    toolBar_->addActions({undo_, redo_});
    toolBar_->addSeparator();
    toolBar_->addActions({copyText, picture, reset});
    toolBar_->addSeparator();
    toolBar_->addWidget(variants_->button());
    toolBar_->addAction(tolerances);
    toolBar_->addSeparator();
    pageActions_ = {close, copyText, copyCsv, picture, reset};
    caseActions_ = {fresh, saveAction, saveAsAction, tolerances, properties, report};
    for (QAction* action : caseActions_) {
        action->setData(action->toolTip());
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
    auto* window = new ToleranceWindow(currentPage(), this);
    window->setAttribute(Qt::WA_DeleteOnClose);
    connect(window, &ToleranceWindow::saveWanted, this, [this, page = currentPage()] {
        for (const auto& each : documents_->all()) {
            if (each->page == page) {
                each->document->save();
            }
        }
    });
    window->show();
}

bool MainWindow::showScene(const QString& name) {
    if (!documents_->showScene(name)) {
        return false;
    }
    leaveStart();
    return true;
}

bool MainWindow::isAtStart() const {
    return start_ != nullptr && front_->currentWidget() == start_;
}

void MainWindow::showStart() {
    if (start_ == nullptr) {
        start_ = new StartPage(front_);
        front_->addWidget(start_);
        connect(start_, &StartPage::sceneRequested, this, &MainWindow::showScene);
        connect(start_, &StartPage::newRequested, this, &MainWindow::beginOrSayWhy);
        connect(start_, &StartPage::openRequested, this, &MainWindow::openOrSayWhy);
        connect(start_, &StartPage::openDialogRequested, this, &MainWindow::openWithDialog);
        connect(start_, &StartPage::newDialogRequested, this, &MainWindow::beginWithDialog);
    }
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
        currentPage()->setActive(true);
        showCurrent();
    }
}

QString MainWindow::currentScene() const {
    return documents_->currentScene().name;
}

ScenePage* MainWindow::currentPage() const {
    return documents_->current().page;
}

ScenePage* MainWindow::page(const QString& name) {
    return documents_->page(name);
}

QString MainWindow::openCase(const QString& path) {
    const QString trouble = documents_->open(path);
    if (trouble.isEmpty()) {
        leaveStart();
    }
    return trouble;
}

bool MainWindow::newCase(const QString& scene) {
    if (!documents_->begin(scene)) {
        return false;
    }
    leaveStart();
    currentPage()->resetZoom();
    return true;
}

QString MainWindow::newCase(const CaseFile& file, const CaseContext& context) {
    const QString trouble = documents_->begin(file, context);
    if (trouble.isEmpty()) {
        leaveStart();
        currentPage()->resetZoom();
    }
    return trouble;
}

void MainWindow::beginOrSayWhy(const CaseFile& file) {
    const QString trouble = newCase(file);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("New case"), trouble);
    }
}

void MainWindow::beginWithDialog() {
    if (const auto file = NewCaseDialog::ask(currentScene(), this)) {
        beginOrSayWhy(*file);
    }
}

void MainWindow::fillNewMenu() {
    newMenu_->clear();
    for (const NewCase& each : newCases()) {
        if (each.scene == currentScene()) {
            newMenu_->addAction(listed(each), this, [this, each] { beginOrSayWhy(each.make()); });
        }
    }
    newMenu_->addSeparator();
    newMenu_->addAction(newFrom_);
}

void MainWindow::fillExamples() {
    examplesMenu_->clear();
    for (const NewCase& each : newCases()) {
        if (each.kind == NewCase::Kind::Example) {
            examplesMenu_->addAction(themedIcon(QStringLiteral("scene-") + each.scene), each.title,
                                     this, [this, each] { beginOrSayWhy(each.make()); });
        }
    }
}

QString MainWindow::saveCase(const QString& path) {
    return documents_->current().document->saveTo(path);
}

void MainWindow::beginSession() {
    recovery_ = new Recovery(Recovery::defaultFolder(), this);
    connect(recovery_, &Recovery::failed, this,
            [this](const QString& why) { statusBar()->showMessage(why, 10'000); });
    documents_->keepIn(recovery_);
    const QSettings settings;
    if (settings.value(restoreKey, false).toBool()) {
        QStringList missing;
        for (const QString& path : settings.value(filesKey).toStringList()) {
            if (!openCase(path).isEmpty()) {
                missing << path;
            }
        }
        const QString current = settings.value(currentKey).toString();
        if (!showScene(current) && documents_->paths().contains(current)) {
            openCase(current);
        }
        if (!missing.isEmpty()) {
            // What the status bar says of a window that is not shown yet lies over the hint.
            QMetaObject::invokeMethod(
                this,
                [this, missing] {
                    statusBar()->showMessage(
                        tr("Not opened again: %1").arg(missing.join(QStringLiteral(", "))), 10'000);
                },
                Qt::QueuedConnection);
        }
    }
    connect(documents_, &Documents::changed, this, &MainWindow::rememberSession);
}

void MainWindow::rememberSession() {
    QSettings settings;
    if (recovery_ == nullptr || !settings.value(restoreKey, false).toBool()) {
        return;  // nobody reads it
    }
    const auto keep = [&](const QString& key, const QVariant& value) {
        if (settings.value(key) != value) {  // every write goes to the disk
            settings.setValue(key, value);
        }
    };
    keep(filesKey, documents_->paths());
    if (!documents_->hasCurrent()) {
        return;
    }
    const QString path = documents_->current().document->path();
    keep(currentKey, path.isEmpty() ? currentScene() : path);
}

void MainWindow::offerRecovered() {
    const Recovery::Found found = recovery_->leftBehind();
    if (found.cases.isEmpty() && found.damaged.isEmpty() && found.newer.isEmpty()) {
        return;
    }
    auto* dialog = new RecoveryDialog(found, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RecoveryDialog::restored, this, [this](const RecoveredCase& recovered) {
        if (documents_->restore(recovered)) {
            recovery_->discard(recovered);
        }
    });
    connect(dialog, &RecoveryDialog::thrownAway, this, [this](const RecoveredCase& recovered) {
        documents_->drop(recovered);
        recovery_->discard(recovered);
    });
    dialog->open();
}

void MainWindow::showCurrent() {
    const bool atStart = isAtStart();
    (atStart ? startAction_ : scenes_[documents_->current().scene])->setChecked(true);
    hint_->setText(atStart ? QString() : documents_->currentScene().summary);
    statusBar()->findChild<BandProgress*>()->follow(atStart ? nullptr : currentPage());
    for (QAction* action : pageActions_) {
        action->setEnabled(!atStart);
    }
    updateCaseActions();
    updateHistoryActions();
    updateSceneActions();
    updateTitle();
}

void MainWindow::updateCaseActions() {
    const bool hasCase = !documents_->hasCurrent() || currentPage()->model()->hasCaseFile();
    for (QAction* action : caseActions_) {
        action->setEnabled(hasCase && !isAtStart());
        action->setToolTip(hasCase
                               ? action->data().toString()
                               : tr("This page has no case file: its numbers are measured anew. "
                                    "Copy or export them."));
    }
    nextTab_->setEnabled(documents_->hasSeveralTabs());
    previousTab_->setEnabled(documents_->hasSeveralTabs());
}

void MainWindow::updateHistoryActions() {
    const auto show = [this](QAction* action, bool enabled, const QString& name,
                             const QString& step) {
        action->setEnabled(enabled && !isAtStart());
        action->setText(step.isEmpty() ? name : name + QLatin1Char(' ') + step);
    };
    if (!documents_->hasCurrent()) {
        show(undo_, false, tr("&Undo"), {});
        show(redo_, false, tr("&Redo"), {});
        return;
    }
    const SceneModel& model = *currentPage()->model();
    const QUndoStack& history = *model.history();
    // What is typed or still being solved is in no history yet; undo takes it back.
    const bool isUnderWay =
        model.isTyped() || model.isSolving() || model.newestRefused() != nullptr;
    show(undo_, isUnderWay || history.canUndo(), tr("&Undo"),
         isUnderWay ? QString() : history.undoText());
    show(redo_, !model.isTyped() && !model.isSolving() && history.canRedo(), tr("&Redo"),
         history.redoText());
}

void MainWindow::updateSceneActions() {
    variants_->setPage(documents_->hasCurrent() ? currentPage() : nullptr);
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
    sceneMenu_->menuAction()->setVisible(!actions.isEmpty());
}

void MainWindow::updateTitle() {
    if (isAtStart()) {
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
    setWindowTitle((name.isEmpty()
                        ? scene + QStringLiteral("[*]")
                        : name + QStringLiteral("[*] – ") +
                              (isNamed ? title + QStringLiteral(" – ") : QString()) + scene) +
                   QStringLiteral(" – Ravnoves"));
    setWindowModified(document.needsSaving());
}

void MainWindow::openOrSayWhy(const QString& path) {
    const QString trouble = documents_->open(path, true);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("Open case"), trouble);
    }
}

void MainWindow::openWithDialog() {
    const QString file =
        documents_->hasCurrent() ? documents_->current().document->path() : QString();
    const QString path =
        askOpenPath(this, tr("Open case"), file.isEmpty() ? file : QFileInfo(file).absolutePath(),
                    tr("Ravnoves cases (*.case.json *.json);;All files (*)"));
    if (!path.isEmpty()) {
        openOrSayWhy(path);
    }
}

void MainWindow::exportPicture() {
    ScenePage* page = currentPage();
    if (page->model()->isSolving()) {
        QMessageBox::warning(this, tr("Save page as picture"), SceneModel::solvingText());
        return;
    }
    const auto draw = [page](QPainter& painter, double scale) {
        if (takesLines(painter)) {
            drawPage(painter, page);
        } else {
            painter.scale(scale, scale);
            page->render(&painter);
        }
    };
    savePictureWithDialog(this, tr("Save page as picture"), currentScene() + QStringLiteral(".png"),
                          page->size(), {}, [&](const QString& path, int pixels) {
                              return writePicture(path, page->size(),
                                                  documents_->current().document->name(), draw,
                                                  pixels);
                          });
}

QString MainWindow::writeReport(const QString& path) {
    return ravnoves::writeReport(*currentPage(), *documents_->current().document, path);
}

void MainWindow::exportReport() {
    if (!goOnWithoutRefused(currentPage(), tr("Report"))) {
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
    const QString trouble = writeReport(path);
    if (trouble.isEmpty()) {
        statusBar()->showMessage(tr("Report written: %1").arg(path), 5000);
    } else {
        QMessageBox::warning(this, tr("Report"), trouble);
    }
}

void MainWindow::fillRecentFiles() {
    recentMenu_->clear();
    const QStringList files = CaseDocument::recentPaths();
    for (const QString& file : files) {
        recentMenu_->addAction(file, this, [this, file] { openOrSayWhy(file); });
    }
    if (files.isEmpty()) {
        recentMenu_->addAction(tr("No files yet"))->setEnabled(false);
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
    if (!documents_->mayGo()) {
        event->ignore();
        return;
    }
    rememberSession();
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
    for (const QUrl& url : event->mimeData()->urls()) {
        openOrSayWhy(url.toLocalFile());
    }
}

}  // namespace ravnoves
