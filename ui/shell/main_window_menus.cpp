// The menus, the tool bar and the navigation of the window.

#include <QActionGroup>
#include <QMenuBar>
#include <QMessageBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <algorithm>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "page/scene_page.h"
#include "scenes/shared_engine.h"
#include "shell/case_properties.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shell/new_cases.h"
#include "shell/settings_dialog.h"
#include "shell/variant_menu.h"
#include "shop/scale_button.h"
#include "text/message_text.h"
#include "text/plain_title.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/layouts.h"

namespace ravnoves {

using namespace std::chrono_literals;

namespace {

constexpr int navigationWidth = 104;

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

void MainWindow::buildNavigation() {
    auto* centre = new QWidget(this);
    QHBoxLayout* row = rowIn(centre, 0);

    startAction_ = new QAction(themedIcon(QStringLiteral("start")), tr("Start"), this);
    startAction_->setCheckable(true);
    startAction_->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Home));
    startAction_->setToolTip(
        tr("Modules, recent files, examples") +
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
    const auto showChecked = [area, navigation] {
        for (QToolButton* button : navigation->findChildren<QToolButton*>()) {
            if (button->isChecked()) {
                area->ensureWidgetVisible(button, 0, Theme::gap);
            }
        }
    };
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
        connect(action, &QAction::toggled, area, showChecked);
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
                goToScene(name);
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
    connect(bar, &QScrollBar::rangeChanged, area, showChecked, Qt::QueuedConnection);
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
    fresh->setToolTip(tr("New case with placeholder values (%1)")
                          .arg(fresh->shortcut().toString(QKeySequence::NativeText)));
    fresh->setStatusTip(fresh->toolTip());
    newMenu_ = file->addMenu(tr("New case &from"));
    connect(newMenu_, &QMenu::aboutToShow, this, &MainWindow::fillNewMenu);
    QAction* open = add(file, QStringLiteral("open"), tr("&Open case…"), QKeySequence::Open,
                        [this] { openWithDialog(); });
    recentMenu_ = file->addMenu(tr("Open &recent"));
    connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::fillRecentFiles);
    save_ = add(file, QStringLiteral("save"), tr("&Save case"), QKeySequence::Save,
                [this] { documents_->save(documents_->current()); });
    QAction* saveAsAction =
        add(file, {}, tr("Save case &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
            [this] { documents_->saveAs(documents_->current()); });
    file->addSeparator();
    QAction* picture = add(file, QStringLiteral("picture"), tr("Save page as &picture…"),
                           QKeySequence(Qt::CTRL | Qt::Key_E), [this] { exportPicture(); });
    QAction* report = add(file, QStringLiteral("pdf"), tr("Repor&t…"),
                          QKeySequence(Qt::CTRL | Qt::Key_R), [this] { exportReport(); });
    file->addSeparator();
    QAction* close = add(file, {}, tr("&Close case"), QKeySequence(Qt::CTRL | Qt::Key_W),
                         [this] { documents_->close(documents_->current()); });
    file->addSeparator();
    add(file, {}, tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { this->close(); });

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    // The step is said: its field may be behind another tab.
    const auto step = [this](const QString& said, const QString& name, void (SceneModel::*make)()) {
        (currentPage()->model()->*make)();
        say(name.isEmpty() ? name : said.arg(name));
    };
    undo_ = add(edit, QStringLiteral("undo"), tr("&Undo"), QKeySequence::Undo, [this, step] {
        const SceneModel& model = *currentPage()->model();
        step(tr("Undone: %1"), model.hasRejected() ? QString() : model.history()->undoText(),
             &SceneModel::undo);
    });
    redo_ = add(edit, QStringLiteral("redo"), tr("&Redo"), {}, [this, step] {
        step(tr("Redone: %1"), currentPage()->model()->history()->redoText(), &SceneModel::redo);
    });
    redo_->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::Key_Y), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
    edit->addSeparator();
    QAction* copyText =
        add(edit, QStringLiteral("copy"), tr("Copy results as &text"),
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
            [this] { copyResults(&ScenePage::resultsAsText, tr("Results copied as text")); });
    QAction* copyCsv = add(edit, {}, tr("Copy results as &CSV"), {}, [this] {
        copyResults(&ScenePage::resultsAsCsv, tr("Results copied as CSV"));
    });

    edit->addSeparator();
    engineMenu_ = edit->addMenu(tr("Take the &engine from"));
    connect(engineMenu_, &QMenu::aboutToShow, this, &MainWindow::fillEngines);
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
        if (!mayRenew(tr("Settings"))) {
            return;
        }
        auto* dialog = new SettingsDialog(this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    add(edit, {}, tr("Sca&le…"), {}, [this] { scale_->click(); });

    sceneMenu_ = menuBar()->addMenu(QString());

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
    add(view, {}, tr("&Full screen"), QKeySequence(Qt::Key_F11),
        [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    add(help, QStringLiteral("help"), tr("&About this page: formulas and sources"),
        QKeySequence::HelpContents,
        [this] { showHelp(isAtStart() ? QStringLiteral("keys") : currentScene()); });
    add(help, {}, tr("&Case files and command line"), {},
        [this] { showHelp(QStringLiteral("case-files")); });
    add(help, {}, tr("&Variants: one design compared with another"), {},
        [this] { showHelp(QStringLiteral("variants")); });
    add(help, {}, tr("&Tolerances: how certain a result is"), {},
        [this] { showHelp(QStringLiteral("tolerances")); });
    add(help, {}, tr("&Keys and mouse"), {}, [this] { showHelp(QStringLiteral("keys")); });
    // The key asks what has the focus, so it is not the action's own.
    help->addAction(tr("&What’s this?") + QStringLiteral("\tShift+F1"), this,
                    [] { QWhatsThis::enterWhatsThisMode(); });
    help->addSeparator();
    add(help, {}, tr("About &Ravnoves"), {}, [this] { showAbout(); });

    toolBar_ = addToolBar(tr("Main toolbar"));
    toolBar_->setObjectName(QStringLiteral("main-toolbar"));
    toolBar_->setMovable(false);
    toolBar_->setIconSize(QSize(Theme::withText(20), Theme::withText(20)));
    toolBar_->addActions({fresh, open, save_});
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
    caseActions_ = {fresh, save_, saveAsAction, tolerances, properties, report};
    for (QAction* action : caseActions_) {
        action->setData(action->toolTip());
    }
}

void MainWindow::fillNewMenu() {
    newMenu_->clear();
    for (const NewCase& each : newCases()) {
        if (isAtStart() || each.scene == currentScene()) {
            newMenu_->addAction(themedIcon(QStringLiteral("scene-") + each.scene), each.listed,
                                this, [this, each] { beginOrSayWhy(each.make()); });
        }
    }
}

void MainWindow::fillEngines() {
    engineMenu_->clear();
    for (const auto& each : documents_->all()) {
        const SceneModel& other = *each->page->model();
        if (isAtStart() || each->page == currentPage() ||
            engine_of(other.sceneName().toStdString(), other.inputJson()) == SharedEngine()) {
            continue;
        }
        QString name = documents_->nameOf(*each);
        name.replace(QLatin1Char('&'), QLatin1String("&&"));
        engineMenu_->addAction(themedIcon(QStringLiteral("scene-") + other.sceneName()), name, this,
                               [this, from = each->document] { takeEngine(from); });
    }
    if (engineMenu_->isEmpty()) {
        engineMenu_->addAction(tr("No other open case has an engine"))->setEnabled(false);
    }
}

void MainWindow::takeEngine(const QObject* document) {
    const OpenDocument* from = documents_->of(document);
    if (from == nullptr) {
        return;
    }
    const SceneModel& other = *from->page->model();
    SceneModel& model = *currentPage()->model();
    Json input = model.inputJson();
    const auto [changed, kept] =
        give_engine(engine_of(other.sceneName().toStdString(), other.inputJson()),
                    model.sceneName().toStdString(), input);
    const auto listed = [](const std::vector<Text>& texts) {
        QStringList words;
        for (const Text& each : texts) {
            words << shownText(each);
        }
        return words.join(QStringLiteral(", "));
    };
    const QString name = documents_->nameOf(*from);
    try {
        if (!changed.empty()) {
            model.loadInput(input, model.context(), tr("Take the engine from %1").arg(name));
        }
        QString said = changed.empty() ? tr("The engine is already the same as in %1.").arg(name)
                                       : tr("Copied from %1: %2.").arg(name, listed(changed));
        if (!kept.empty()) {
            said += QLatin1Char(' ') + tr("Unchanged: %1.").arg(listed(kept));
        }
        say(said, 20s);
    } catch (const InputError& error) {
        QMessageBox::warning(this, tr("Take the engine from %1").arg(name), model.explain(error));
    }
}

void MainWindow::fillRecentFiles() {
    recentMenu_->clear();
    const QStringList files = CaseDocument::recentPaths();
    for (const QString& file : files) {
        recentMenu_->addAction(plainTitle(file), this, [this, file] { openOrSayWhy({file}); });
    }
    if (files.isEmpty()) {
        recentMenu_->addAction(tr("No files yet"))->setEnabled(false);
    }
}

}  // namespace ravnoves
