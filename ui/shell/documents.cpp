#include "shell/documents.h"

#include <QApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/open_case.h"
#include "model/recovery.h"
#include "numerics/demand.h"
#include "scenes/case_sources.h"
#include "shell/disk_notice.h"
#include "shell/refused_entries.h"
#include "shell/scene_page.h"
#include "shell/solving_notice.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/message_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/file_dialogs.h"

namespace ravnoves {

namespace {

/// Tabs that scroll before their titles are too short to be told apart.
class CaseTabs final : public QTabBar {
  public:
    using QTabBar::QTabBar;

  protected:
    QSize minimumTabSizeHint(int index) const override {
        const QSize whole = tabSizeHint(index);
        return {std::min(whole.width(), Theme::withText(150)), whole.height()};
    }
};

}  // namespace

Documents::Documents(QWidget* parent) : QWidget(parent), scenes_(sceneList()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    tabs_ = new CaseTabs(this);
    tabs_->setObjectName(QStringLiteral("documents"));
    tabs_->setAccessibleName(tr("Open cases"));
    tabs_->setDocumentMode(true);
    tabs_->setDrawBase(true);
    tabs_->setExpanding(false);
    tabs_->setMovable(true);
    tabs_->setUsesScrollButtons(true);
    tabs_->setElideMode(Qt::ElideMiddle);
    tabs_->installEventFilter(this);
    tabs_->hide();
    column->addWidget(tabs_);
    makeNotice();
    stack_ = new QStackedWidget(this);
    column->addWidget(stack_, 1);
    connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) {
        if (OpenDocument* document = ofTab(tab)) {
            bringToFront(*document);
        }
    });
    connect(tabs_, &QTabBar::tabMoved, this, &Documents::changed);
}

Documents::~Documents() {
    for (const auto& each : documents_) {
        delete each->document;
        delete each->page;
    }
}

// ------------------------------------------------------------------------------- looking up

std::optional<std::size_t> Documents::indexOf(const QString& scene) const {
    const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                    [&](const SceneInfo& info) { return info.name == scene; });
    return found == scenes_.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - scenes_.begin()));
}

OpenDocument* Documents::lastOf(std::size_t scene) const {
    OpenDocument* last = nullptr;
    for (const auto& each : documents_) {
        if (each->scene == scene && (last == nullptr || each->shown > last->shown)) {
            last = each.get();
        }
    }
    return last;
}

OpenDocument* Documents::withFile(const QString& path) const {
    for (const auto& each : documents_) {
        const QString other = each->document->path();
        if (!other.isEmpty() && (other == QFileInfo(path).absoluteFilePath() ||
                                 is_same_file(fsPath(other), fsPath(path)))) {
            return each.get();
        }
    }
    return nullptr;
}

OpenDocument* Documents::ofTab(int tab) const {
    for (const auto& each : documents_) {
        if (tabs_->tabData(tab).toInt() == each->id) {
            return each.get();
        }
    }
    return nullptr;
}

bool Documents::isUntouched(const OpenDocument& document) {
    const SceneModel& model = *document.document->model();
    return !model.hasCaseFile() ||
           (document.document->path().isEmpty() && !model.hasChanges() &&
            model.history()->count() == 0 && model.inputJson().dump() == document.beginning);
}

OpenDocument* Documents::untouchedOf(std::size_t scene, const OpenDocument* butNot) const {
    for (const auto& each : documents_) {
        if (each->scene == scene && each.get() != butNot && isUntouched(*each)) {
            return each.get();
        }
    }
    return nullptr;
}

// ------------------------------------------------------------------------ coming and going

OpenDocument& Documents::add(std::size_t scene) {
    documents_.push_back(std::make_unique<OpenDocument>());
    OpenDocument& added = *documents_.back();
    added.id = ++ids_;
    added.scene = scene;
    putPage(added, scenes_[scene].make(stack_));
    SceneModel* model = added.page->model();
    added.document = new CaseDocument(model, dialogsOf(added), this);
    added.beginning = model->inputJson().dump();
    connect(model, &SceneModel::historyChanged, this, [this, &added] {
        if (&added == current_) {
            Q_EMIT historyChanged();
        }
    });
    connect(model, &SceneModel::refusedInChanged, this, [this, &added] {
        if (&added == current_) {
            Q_EMIT refusedInChanged();
        }
    });
    connect(added.document, &CaseDocument::nameChanged, this, [this, &added] {
        nameTabs();
        if (&added == current_) {
            Q_EMIT titleChanged();
        }
        Q_EMIT changed();
    });
    connect(added.document, &CaseDocument::saved, this, &Documents::saved);
    connect(&added.document->disk(), &FileOnDisk::stateChanged, this, &Documents::showNotice);
    connect(added.document, &CaseDocument::sourcesChanged, this, &Documents::showNotice);
    keep(added);
    return added;
}

void Documents::putPage(OpenDocument& document, ScenePage* page) {
    document.page = page;
    page->setOpenCases([this](const QString& other) -> std::optional<OpenCase> {
        const auto index = indexOf(other);
        const OpenDocument* last = index ? lastOf(*index) : nullptr;
        return last != nullptr ? std::optional(last->document->asOpenCase()) : std::nullopt;
    });
    connect(page, &ScenePage::status, this, [this, &document](const QString& text) {
        if (&document == current_) {
            Q_EMIT status(text);
        }
    });
    stack_->addWidget(page);
}

void Documents::makeNotice() {
    tabs_->setFont(Theme::font(Theme::smallSize));
    tabs_->setIconSize(QSize(Theme::withText(16), Theme::withText(16)));
    notice_ = new DiskNotice(this);
    static_cast<QVBoxLayout*>(layout())->insertWidget(1, notice_);  // below the tabs
    connect(notice_, &DiskNotice::reloadAsked, this, &Documents::reload);
    connect(notice_, &DiskNotice::keepAsked, this, [this] {
        CaseDocument& document = *current_->document;
        if (document.disk().state() != FileOnDisk::State::Same) {
            document.keepMine();
        } else {
            document.keepSources();
        }
    });
    connect(notice_, &DiskNotice::saveAsAsked, this, [this] { current_->document->saveAs(); });
    solving_ = new SolvingNotice(this);
    static_cast<QVBoxLayout*>(layout())->insertWidget(2, solving_);
}

void Documents::renewPages() {
    scenes_ = sceneList();
    for (const auto& each : documents_) {
        ScenePage* old = each->page;
        const ScenePage::Left left = old->giveWay();
        const Json refused = refusedTexts(*old);
        stack_->removeWidget(old);
        delete old;
        putPage(*each, scenes_[each->scene].make(stack_, left.model));
        each->page->resume(left);
        typeAgain(*each->page, refused);
    }
    tabs_->setAccessibleName(tr("Open cases"));
    delete notice_;
    delete solving_;
    makeNotice();
    if (current_ == nullptr) {
        return;
    }
    stack_->setCurrentWidget(current_->page);
    showNotice();
    arrangeTabs();
    current_->page->setActive(true);
    Q_EMIT currentChanged();
    Q_EMIT changed();
}

void Documents::remove(OpenDocument& document) {
    if (recovery_ != nullptr) {
        recovery_->release(document.document);
    }
    delete document.document;
    stack_->removeWidget(document.page);
    document.page->deleteLater();  // it may be the one that the key was pressed in
    const auto found = std::find_if(documents_.begin(), documents_.end(),
                                    [&](const auto& each) { return each.get() == &document; });
    documents_.erase(found);
}

OpenDocument& Documents::firstOf(std::size_t scene) {
    OpenDocument* last = lastOf(scene);
    return last != nullptr ? *last : add(scene);
}

OpenDocument& Documents::current() {
    if (current_ == nullptr) {
        const QSignalBlocker quiet(this);
        bringToFront(firstOf(0));
        current_->page->setActive(isVisible());
    }
    return *current_;
}

bool Documents::showScene(const QString& scene) {
    const auto index = indexOf(scene);
    if (index) {
        bringToFront(firstOf(*index));
    }
    return index.has_value();
}

ScenePage* Documents::page(const QString& scene) {
    const auto index = indexOf(scene);
    return index ? firstOf(*index).page : nullptr;
}

void Documents::bringToFront(OpenDocument& document) {
    if (current_ == &document) {
        arrangeTabs();
        Q_EMIT currentAsked();
        return;
    }
    if (current_ != nullptr) {
        current_->page->setActive(false);
    }
    current_ = &document;
    document.shown = ++shows_;
    stack_->setCurrentWidget(document.page);
    arrangeTabs();
    document.document->disk().check();
    document.document->checkSources();
    showNotice();
    document.page->setActive(true);
    Q_EMIT currentChanged();
    Q_EMIT changed();
}

void Documents::step(int by) {
    const int count = tabs_->count();
    if (OpenDocument* next = ofTab((tabs_->currentIndex() + by + count) % count)) {
        bringToFront(*next);
    }
}

bool Documents::hasSeveralTabs() const {
    return tabs_->count() > 1;
}

void Documents::put(const CaseFile& file, OpenDocument* there,
                    const std::function<void(CaseDocument&)>& load) {
    const auto scene = indexOf(QString::fromStdString(file.scene));
    RAVNOVES_DEMAND(scene.has_value(), "every scene of a case file has a page");
    OpenDocument* reused = there != nullptr ? there : untouchedOf(*scene, nullptr);
    OpenDocument& target = reused != nullptr ? *reused : add(*scene);
    try {
        load(*target.document);
    } catch (const InputError&) {
        if (reused == nullptr) {
            remove(target);
        }
        throw;
    }
    if (reused != nullptr) {
        target.page->resetZoom();
    }
    bringToFront(target);
}

std::optional<bool> Documents::relocate(CaseFile& file, const InputError& error, Missing& missing,
                                        const QString& title, const QString& trouble) {
    Json* const name = CaseDocument::fileNamedAt(file, error);
    if (name == nullptr) {
        return std::nullopt;
    }
    const bool isSecond = missing.where == error.where();
    if (!isSecond) {
        missing.where = error.where();
        missing.name = QString::fromStdString(name->get<std::string>());
    }
    // What the case names is looked for, whatever was chosen for it.
    const QString found = locate(
        missing.name, missing.folder, title,
        isSecond
            ? tr("The file chosen for %1 does not do.").arg(QFileInfo(missing.name).fileName()) +
                  QStringLiteral("\n\n") + trouble
            : trouble);
    if (!found.isEmpty()) {
        *name = QFileInfo(found).absoluteFilePath().toStdString();
    }
    return !found.isEmpty();
}

QString Documents::open(const QString& path, bool locates) {
    if (OpenDocument* there = withFile(path)) {
        bringToFront(*there);
        return {};
    }
    CaseFile file;
    QByteArray known;
    Missing missing{QFileInfo(path).absolutePath()};
    for (bool isMoved = false;; isMoved = true) {
        try {
            if (!isMoved) {
                file = CaseDocument::read(path, &known);
            }
            put(file, nullptr, [&](CaseDocument& document) {
                document.open(file, path, known);
                // Where a file is now, and what an older version has become, is to be saved.
                if (isMoved || !file.changes.empty()) {
                    document.model()->history()->resetClean();
                }
            });
            QStringList changes;
            for (const Message& change : file.changes) {
                changes << messageText(change);
            }
            Q_EMIT status(changes.join(QLatin1Char(' ')));
            return {};
        } catch (const InputError& error) {
            QString trouble = path + QStringLiteral(": ") + errorText(error);
            const auto isMoving =
                locates ? relocate(file, error, missing, tr("Open case"), trouble) : std::nullopt;
            if (!isMoving) {
                return trouble;
            }
            if (!*isMoving) {
                return {};
            }
        }
    }
}

QString Documents::locate(const QString& name, const QString& folder, const QString& title,
                          const QString& trouble) {
    QMessageBox box(QMessageBox::Warning, title, trouble, QMessageBox::Cancel, this);
    const QPushButton* locate = box.addButton(tr("&Locate file…"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == locate
               ? askOpenPath(this, tr("Where is %1?").arg(QFileInfo(name).fileName()), folder,
                             tablesFilter())
               : QString();
}

bool Documents::begin(const QString& scene) {
    const auto index = indexOf(scene);
    if (!index || !page(scene)->model()->hasCaseFile()) {
        return false;
    }
    // One that is seen is left: something new shall be there.
    const OpenDocument* seen =
        current_ != nullptr && current_->page->isVisible() ? current_ : nullptr;
    OpenDocument* reused = untouchedOf(*index, seen);
    OpenDocument& target = reused != nullptr ? *reused : add(*index);
    target.hasTab = true;
    bringToFront(target);
    return true;
}

QString Documents::begin(const CaseFile& file, const CaseContext& context) {
    try {
        put(file, nullptr, [&](CaseDocument& document) { document.begin(file, context); });
        return {};
    } catch (const InputError& error) {
        return errorText(error);
    }
}

// ----------------------------------------------------------------------- crashes and others

void Documents::keepIn(Recovery* recovery) {
    recovery_ = recovery;
    for (const auto& each : documents_) {
        keep(*each);
    }
}

void Documents::keep(OpenDocument& document) {
    if (recovery_ != nullptr) {
        recovery_->watch(
            document.document, [&document] { return document.page->draftName(); },
            [&document] { return refusedTexts(*document.page); });
    }
}

bool Documents::restore(const RecoveredCase& recovered) {
    OpenDocument* there = recovered.path.isEmpty() ? nullptr : withFile(recovered.path);
    if (there != nullptr && (there->document->needsSaving() ||
                             scenes_[there->scene].name.toStdString() != recovered.content.scene)) {
        there = nullptr;
    }
    CaseFile file = recovered.content;
    Missing missing{recovered.path.isEmpty() ? QString()
                                             : QFileInfo(recovered.path).absolutePath()};
    for (bool isThere = false; !isThere;) {
        try {
            put(file, there, [&](CaseDocument& document) {
                document.restore(file, recovered.context, recovered.path, recovered.known);
            });
            isThere = true;
        } catch (const InputError& error) {
            const QString title = tr("Unsaved cases");
            const QString trouble = (recovered.path.isEmpty() ? recovered.file : recovered.path) +
                                    QStringLiteral(": ") + errorText(error);
            const auto isMoving = relocate(file, error, missing, title, trouble);
            if (!isMoving) {
                QMessageBox::warning(window(), title, trouble);
            }
            if (!isMoving.value_or(false)) {
                return false;
            }
        }
    }
    if (!recovered.draft.isEmpty()) {
        current_->page->takeDraft(recovered.draft);
    }
    typeAgain(*current_->page, recovered.refused);
    return recovery_ == nullptr || recovery_->keep(current_->document);  // or the other copy stays
}

void Documents::drop(const RecoveredCase& recovered) {
    if (!recovered.draft.isEmpty()) {
        page(QString::fromStdString(recovered.content.scene))->dropDraft(recovered.draft);
    }
}

QStringList Documents::paths() const {
    QStringList paths;
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        const QString path = ofTab(tab)->document->path();
        if (!path.isEmpty()) {
            paths << path;
        }
    }
    return paths;
}

void Documents::showNotice() {
    if (current_ != nullptr) {
        const bool hadFocus = notice_->isAncestorOf(QApplication::focusWidget());
        notice_->showFor(current_->document);
        if (hadFocus && notice_->isHidden()) {
            // Else it goes where it happens to.
            QWidget* last = current_->page->focusWidget();
            (last != nullptr ? last : current_->page)->setFocus(Qt::OtherFocusReason);
        }
        solving_->follow(current_->document->model());
    }
}

void Documents::reload() {
    CaseDocument& document = *current_->document;
    const QString trouble = document.disk().state() != FileOnDisk::State::Same
                                ? document.reload()
                                : document.readSources();
    if (!trouble.isEmpty()) {
        QMessageBox::warning(window(), tr("Open case"), trouble);
    }
}

bool Documents::event(QEvent* event) {
    if (event->type() == QEvent::WindowActivate) {
        for (const auto& each : documents_) {
            each->document->disk().check();
            each->document->checkSources();
        }
    }
    return QWidget::event(event);
}

// --------------------------------------------------------------------------------- closing

bool Documents::close(OpenDocument& document) {
    if (!document.document->mayGo()) {
        return false;
    }
    if (&document == current_) {
        OpenDocument* next = nullptr;
        for (const auto& each : documents_) {
            if (each.get() != current_ && each->hasTab &&
                (next == nullptr || each->shown > next->shown)) {
                next = each.get();
            }
        }
        if (next == nullptr && isUntouched(document)) {
            return true;  // the next would be like it
        }
        if (next == nullptr) {
            next = untouchedOf(document.scene, &document);
        }
        bringToFront(next != nullptr ? *next : add(document.scene));
    }
    remove(document);
    arrangeTabs();
    Q_EMIT changed();
    return true;
}

bool Documents::mayGo() {
    return std::all_of(documents_.begin(), documents_.end(),
                       [](const auto& each) { return each->document->mayGo(); });
}

DocumentDialogs Documents::dialogsOf(OpenDocument& document) {
    DocumentDialogs dialogs;
    dialogs.saveChanges = [this, &document](bool hasFile) {
        bringToFront(document);
        // A case that came from a file goes back to it.
        if (const auto goOn = hasFile ? std::nullopt : document.page->askToSave()) {
            return *goOn ? DocumentDialogs::Answer::Discard : DocumentDialogs::Answer::Stay;
        }
        const QString scene = scenes_[document.scene].title;
        const QString name = nameOf(document);
        QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                        tr("Save the changes of “%1”?")
                            .arg(name == scene ? scene : name + QStringLiteral(" – ") + scene),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window());
        box.setDefaultButton(QMessageBox::Save);
        box.button(QMessageBox::Discard)->setText(tr("Do&n’t save"));
        const int answer = box.exec();
        return answer == QMessageBox::Save      ? DocumentDialogs::Answer::Save
               : answer == QMessageBox::Discard ? DocumentDialogs::Answer::Discard
                                                : DocumentDialogs::Answer::Stay;
    };
    dialogs.choosePath = [this, &document](const QString& suggestion) {
        QString path = askSavePath(window(), tr("Save case"), suggestion,
                                         {{QStringLiteral("case.json"), tr("Ravnoves case")}});
        const OpenDocument* other = path.isEmpty() ? nullptr : withFile(path);
        if (other != nullptr && other != &document) {
            QMessageBox::warning(window(), tr("Save case"),
                                 tr("%1 is open in another tab. Close that first, or choose "
                                    "another name.")
                                     .arg(path));
            return QString();
        }
        return path;
    };
    dialogs.goOnWithoutRefused = [&document] {
        return goOnWithoutRefused(document.page, tr("Save case"));
    };
    dialogs.leaveRefused = [this, &document] {
        if (refusedEntries(document.page).isEmpty()) {
            return true;
        }
        bringToFront(document);
        return goOnWithoutRefused(document.page, tr("Close case"));
    };
    dialogs.elsewhere = [this](const QString& trouble) {
        QMessageBox box(QMessageBox::Warning, tr("Save case"), trouble, QMessageBox::Cancel,
                        window());
        box.setDefaultButton(box.addButton(tr("Save as…"), QMessageBox::AcceptRole));
        box.exec();
        return box.buttonRole(box.clickedButton()) == QMessageBox::AcceptRole;
    };
    dialogs.overwrite = [this](const QString& path) {
        QMessageBox box(QMessageBox::Warning, tr("Save case"),
                        tr("%1 was changed by another program since it was opened or saved here. "
                           "Overwrite it?")
                            .arg(path),
                        QMessageBox::Cancel, window());
        QPushButton* over = box.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
        QPushButton* elsewhere = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
        box.setDefaultButton(elsewhere);
        box.exec();
        return box.clickedButton() == over        ? DocumentDialogs::Overwrite::Yes
               : box.clickedButton() == elsewhere ? DocumentDialogs::Overwrite::Elsewhere
                                                  : DocumentDialogs::Overwrite::No;
    };
    return dialogs;
}

// ------------------------------------------------------------------------------------- tabs

QString Documents::nameOf(const OpenDocument& document) const {
    const QString name = document.document->name();
    return name.isEmpty() ? scenes_[document.scene].title : name;
}

void Documents::arrangeTabs() {
    const QSignalBlocker blocker(tabs_);
    for (const auto& each : documents_) {
        each->hasTab = each->hasTab || !isUntouched(*each);
    }
    const auto belongs = [this](const OpenDocument& document) {
        return document.hasTab || &document == current_;
    };
    for (int tab = tabs_->count(); tab-- > 0;) {
        const OpenDocument* document = ofTab(tab);
        if (document == nullptr || !belongs(*document)) {
            tabs_->tabButton(tab, QTabBar::RightSide)->deleteLater();  // the bar only hides it
            tabs_->removeTab(tab);
        }
    }
    for (const auto& each : documents_) {
        int tab = 0;
        while (tab < tabs_->count() && ofTab(tab) != each.get()) {
            ++tab;
        }
        if (belongs(*each) && tab == tabs_->count()) {
            tabs_->addTab(themedIcon(QStringLiteral("scene-") + scenes_[each->scene].name), {});
            tabs_->setTabData(tab, each->id);
            auto* button = new QToolButton(tabs_);
            button->setIcon(themedIcon(QStringLiteral("close")));
            button->setIconSize(QSize(12, 12));
            button->setAutoRaise(true);
            button->setFocusPolicy(Qt::NoFocus);  // Ctrl+W does it
            connect(button, &QToolButton::clicked, this,
                    [this, document = each.get()] { close(*document); });
            tabs_->setTabButton(tab, QTabBar::RightSide, button);
        }
        if (each.get() == current_) {
            tabs_->setCurrentIndex(tab);
        }
    }
    nameTabs();
    tabs_->setVisible(hasSeveralTabs());
    // Who has stood in the bar beside others does not vanish from it.
    current_->hasTab = current_->hasTab || hasSeveralTabs();
}

void Documents::nameTabs() {
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        QWidget* button = tabs_->tabButton(tab, QTabBar::RightSide);
        button->setToolTip(
            tr("Close (%1)")
                .arg(QKeySequence(Qt::CTRL | Qt::Key_W).toString(QKeySequence::NativeText)));
        button->setAccessibleName(tr("Close"));
    }
    QStringList names;
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        const OpenDocument& document = *ofTab(tab);
        const QString path = document.document->path();
        QString name = nameOf(document);
        for (const QString& ending : {QStringLiteral(".json"), QStringLiteral(".case")}) {
            if (!path.isEmpty() && name.endsWith(ending)) {
                name.chop(ending.size());
            }
        }
        // Two of one name differ by their number.
        const QString wanted = name;
        for (int number = 2; names.contains(name); ++number) {
            name = wanted + QStringLiteral(" (%1)").arg(number);
        }
        names << name;
        tabs_->setTabText(
            tab, QString(name).replace(QLatin1Char('&'), QStringLiteral("&&")) +
                     (document.document->needsSaving() ? QStringLiteral(" *") : QString()));
        tabs_->setTabToolTip(tab, scenes_[document.scene].title +
                                      (path.isEmpty() ? QString() : QStringLiteral("\n") + path));
    }
}

bool Documents::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::MiddleButton) {
            if (OpenDocument* document = ofTab(tabs_->tabAt(mouse->pos()))) {
                close(*document);
                return true;
            }
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ravnoves
