#include "shell/documents.h"

#include <QEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/open_case.h"
#include "model/recovery.h"
#include "page/scene_page.h"
#include "scenes/case_sources.h"
#include "shell/case_tabs.h"
#include "shell/disk_notice.h"
#include "shell/missing_file.h"
#include "shell/saving_dialogs.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/message_text.h"
#include "text/plain_title.h"

namespace ravnoves {

Documents::Documents(QWidget* parent) : QWidget(parent), scenes_(sceneList()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    tabs_ = new CaseTabs(this);
    column->addWidget(tabs_);
    makeNotices();
    stack_ = new QStackedWidget(this);
    column->addWidget(stack_, 1);
    connect(tabs_, &QTabBar::currentChanged, this, &Documents::showTab);
    connect(tabs_, &QTabBar::tabMoved, this, &Documents::changed);
    connect(tabs_, &CaseTabs::closeAsked, this, [this](int id) {
        if (OpenDocument* document = withId(id)) {
            close(*document);
        } else if (std::erase_if(later_, [id](const Later& each) { return each.id == id; }) > 0) {
            arrangeTabs();
            Q_EMIT changed();
        }
    });
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

namespace {

/// By whatever name, and also where nothing is there.
bool isSame(const QString& known, const QString& path) {
    return !known.isEmpty() && (known == QFileInfo(path).absoluteFilePath() ||
                                is_same_file(fsPath(known), fsPath(path)));
}

}  // namespace

OpenDocument* Documents::withFile(const QString& path) const {
    for (const auto& each : documents_) {
        if (isSame(each->document->path(), path)) {
            return each.get();
        }
    }
    return nullptr;
}

OpenDocument* Documents::withId(int id) const {
    for (const auto& each : documents_) {
        if (each->id == id) {
            return each.get();
        }
    }
    return nullptr;
}

OpenDocument* Documents::ofTab(int tab) const {
    return withId(tabs_->idOf(tab));
}

bool Documents::isUntouched(const OpenDocument& document) {
    const SceneModel& model = *document.document->model();
    return !model.hasCaseFile() ||
           (document.document->path().isEmpty() && !model.hasChanges() &&
            model.history()->count() == 0 && model.inputJson().dump() == document.beginning);
}

OpenDocument* Documents::untouchedOf(std::size_t scene) const {
    for (const auto& each : documents_) {
        if (each->scene == scene && isUntouched(*each)) {
            return each.get();
        }
    }
    return nullptr;
}

// ------------------------------------------------------------------------ coming and going

OpenDocument& Documents::add(std::size_t scene, int id) {
    documents_.push_back(std::make_unique<OpenDocument>());
    OpenDocument& added = *documents_.back();
    added.id = id != 0 ? id : ++ids_;
    added.scene = scene;
    putPage(added, scenes_[scene].make(stack_));
    SceneModel* model = added.page->model();
    added.document = new CaseDocument(model, savingDialogs(*this, added), this);
    added.beginning = model->inputJson().dump();
    connect(model, &SceneModel::historyChanged, this, [this, &added] {
        if (&added == current_) {
            Q_EMIT historyChanged();
        }
    });
    connect(model, &SceneModel::rejectedInChanged, this, [this, &added] {
        if (&added == current_) {
            Q_EMIT rejectedInChanged();
        }
    });
    connect(added.document, &CaseDocument::nameChanged, this, [this, &added] {
        tabs_->name(caseTabs());
        if (&added == current_) {
            Q_EMIT titleChanged();
        }
        Q_EMIT changed();
    });
    connect(added.document, &CaseDocument::saved, this, &Documents::saved);
    connect(&added.document->disk(), &FileOnDisk::stateChanged, this, &Documents::showNotices);
    connect(added.document, &CaseDocument::sourcesChanged, this, &Documents::showNotices);
    keep(added);
    return added;
}

void Documents::putPage(OpenDocument& document, ScenePage* page) {
    document.page = page;
    page->setOpenCases([this](const QString& other) -> std::optional<OpenCase> {
        const auto index = indexOf(other);
        const OpenDocument* last = index ? lastOf(*index) : nullptr;
        if (last == nullptr) {
            return std::nullopt;
        }
        OpenCase open = last->document->asOpenCase();
        open.shown = last->shown;
        return open;
    });
    page->setShowOther([this, page](const std::function<bool(ScenePage*)>& isWanted) {
        for (const auto& each : documents_) {
            if (each->page != page && isWanted(each->page)) {
                bringToFront(*each);
                return true;
            }
        }
        return false;
    });
    connect(page, &ScenePage::status, this, [this, &document](const QString& text) {
        if (&document == current_) {
            Q_EMIT status(text);
        }
    });
    stack_->addWidget(page);
}

void Documents::makeNotices() {
    notices_ = new DiskNotice(this);
    static_cast<QVBoxLayout*>(layout())->insertWidget(1, notices_);  // below the tabs
}

void Documents::renewPages() {
    scenes_ = sceneList();
    for (const auto& each : documents_) {
        ScenePage* old = each->page;
        const QStringList tabs = old->shownTabs();
        SceneModel* model = old->letGo();
        stack_->removeWidget(old);
        delete old;
        putPage(*each, scenes_[each->scene].make(stack_, model));
        each->page->showTabs(tabs);
    }
    tabs_->renew();
    delete notices_;
    makeNotices();
    if (current_ == nullptr) {
        return;
    }
    stack_->setCurrentWidget(current_->page);
    showNotices();
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
    // While no page is seen Qt leaves the focus with the one before, and gives it back there.
    if (QWidget* last = focusWidget();
        last != nullptr && stack_->isAncestorOf(last) && !document.page->isAncestorOf(last)) {
        last->clearFocus();
    }
    arrangeTabs();
    document.document->disk().check();
    document.document->checkSources();
    showNotices();
    document.page->setActive(true);
    Q_EMIT currentChanged();
    Q_EMIT changed();
}

void Documents::step(int by) {
    const int count = tabs_->count();
    showTab((tabs_->currentIndex() + by + count) % count);
}

void Documents::showTab(int tab) {
    if (OpenDocument* document = ofTab(tab)) {
        bringToFront(*document);
        return;
    }
    const auto later = std::find_if(later_.begin(), later_.end(),
                                    [&](const Later& each) { return each.id == tabs_->idOf(tab); });
    if (later == later_.end()) {
        return;
    }
    const QString trouble = open(QString(later->path), true);
    if (current_ == nullptr || current_->id != tabs_->idOf(tabs_->currentIndex())) {
        arrangeTabs();
        Q_EMIT changed();
    }
    if (!trouble.isEmpty()) {
        QMessageBox::warning(window(), tr("Open case"), trouble);
    }
}

void Documents::openLater(const QStringList& paths) {
    constexpr std::size_t maximum = 200;  // a bar of more takes long, and nobody finds one there
    int left = 0;
    for (const QString& path : paths) {
        if (later_.size() >= maximum) {
            ++left;
            continue;
        }
        const bool isAsked = std::any_of(later_.begin(), later_.end(), [&](const Later& each) {
            return isSame(each.path, path);
        });
        if (!isAsked && withFile(path) == nullptr) {
            later_.push_back({++ids_, QFileInfo(path).absoluteFilePath()});
        }
    }
    arrangeTabs();
    Q_EMIT changed();
    if (left > 0) {
        // Not before what opened the first file says.
        QMetaObject::invokeMethod(
            this, [this, left] { Q_EMIT status(tr("Too many files; not opened: %1").arg(left)); },
            Qt::QueuedConnection);
    }
}

bool Documents::hasSeveralTabs() const {
    return tabs_->hasSeveral();
}

void Documents::put(const CaseFile& file, OpenDocument* there, int id,
                    const std::function<void(CaseDocument&)>& load) {
    const auto scene = indexOf(QString::fromStdString(file.scene));
    if (!scene) {
        throw InputError(
            "/scene",
            CORE_TEXT("core", "must be a module of the window; the command line solves this case"),
            file.scene);
    }
    OpenDocument* reused = there != nullptr ? there : untouchedOf(*scene);
    OpenDocument& target = reused != nullptr ? *reused : add(*scene, id);
    try {
        load(*target.document);
    } catch (const InputError&) {
        if (reused == nullptr) {
            remove(target);
        }
        throw;
    }
    if (reused != nullptr) {
        target.id = id != 0 ? id : target.id;
        target.page->resetZoom();
    }
    bringToFront(target);
}

QString Documents::open(const QString& path, bool locates) {
    if (OpenDocument* there = withFile(path)) {
        bringToFront(*there);
        return {};
    }
    int id = 0;  // of the tab that waits for it
    std::erase_if(later_, [&](const Later& each) {
        const bool isIt = isSame(each.path, path);
        id = isIt ? each.id : id;
        return isIt;
    });
    CaseFile file;
    QByteArray known;
    MissingFile missing(this, tr("Open case"), QFileInfo(path).absolutePath());
    for (bool isMoved = false;; isMoved = true) {
        try {
            if (!isMoved) {
                file = CaseDocument::read(path, &known);
            }
            put(file, nullptr, id, [&](CaseDocument& document) {
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
            const auto isMoving = locates ? missing.locate(file, error, trouble) : std::nullopt;
            if (!isMoving.value_or(false)) {
                arrangeTabs();
                return isMoving ? QString() : trouble;
            }
        }
    }
}

QString Documents::begin(const CaseFile& file, const CaseContext& context, bool isFirst) {
    try {
        put(file, nullptr, 0, [&](CaseDocument& document) { document.begin(file, context); });
        if (isFirst) {
            current_->beginning = current_->page->model()->inputJson().dump();
            current_->hasTab = false;
            arrangeTabs();
        }
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
        recovery_->watch(document.document);
    }
}

bool Documents::restore(const RecoveredCase& recovered) {
    OpenDocument* there = recovered.path.isEmpty() ? nullptr : withFile(recovered.path);
    if (there != nullptr && (there->document->needsSaving() ||
                             scenes_[there->scene].name.toStdString() != recovered.content.scene)) {
        there = nullptr;
    }
    CaseFile file = recovered.content;
    const QString title = tr("Unsaved cases");
    MissingFile missing(
        this, title,
        recovered.path.isEmpty() ? QString() : QFileInfo(recovered.path).absolutePath());
    for (bool isThere = false; !isThere;) {
        try {
            put(file, there, 0, [&](CaseDocument& document) { document.restore(file, recovered); });
            isThere = true;
        } catch (const InputError& error) {
            const QString trouble = (recovered.path.isEmpty() ? recovered.file : recovered.path) +
                                    QStringLiteral(": ") + errorText(error);
            const auto isMoving = missing.locate(file, error, trouble);
            if (!isMoving) {
                QMessageBox::warning(window(), title, trouble);
            }
            if (!isMoving.value_or(false)) {
                return false;
            }
        }
    }
    return recovery_ == nullptr || recovery_->keep(current_->document);  // or the other copy stays
}

void Documents::showNotices() {
    if (current_ != nullptr) {
        notices_->showFor(current_->document, current_->page);
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
    if (!document.document->canClose()) {
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
        if (next != nullptr) {
            bringToFront(*next);
        } else {
            document.page->setActive(false);
            current_ = nullptr;
        }
    }
    remove(document);
    arrangeTabs();
    Q_EMIT changed();
    while (current_ == nullptr && !later_.empty()) {
        showTab(std::max(tabs_->currentIndex(), 0));
    }
    if (current_ == nullptr) {
        Q_EMIT lastClosed();
    }
    return true;
}

/// Where one stays, the case that was asked about is in front.
bool Documents::canClose() {
    return std::all_of(documents_.begin(), documents_.end(),
                       [](const auto& each) { return each->document->canClose(); });
}

// ------------------------------------------------------------------------------------- tabs

QString Documents::nameOf(const OpenDocument& document) const {
    const QString name = document.document->name();
    return name.isEmpty() ? scenes_[document.scene].title : name;
}

namespace {

/// Of a file, without its endings.
QString bareName(const QString& path) {
    QString name = plainTitle(QFileInfo(path).fileName());
    for (const QString& ending : {QStringLiteral(".json"), QStringLiteral(".case")}) {
        if (name.endsWith(ending)) {
            name.chop(ending.size());
        }
    }
    return name;
}

}  // namespace

std::vector<CaseTab> Documents::caseTabs() const {
    std::vector<CaseTab> tabs;
    for (const auto& each : documents_) {
        if (!each->hasTab && each.get() != current_) {
            continue;
        }
        const SceneInfo& scene = scenes_[each->scene];
        const QString path = each->document->path();
        tabs.push_back(
            {.id = each->id,
             .icon = QStringLiteral("scene-") + scene.name,
             .name = path.isEmpty() ? nameOf(*each) : bareName(path),
             .needsSaving = each->document->needsSaving(),
             .toolTip = scene.title +
                        (path.isEmpty() ? QString() : QStringLiteral("\n") + plainTitle(path))});
    }
    for (const Later& each : later_) {
        tabs.push_back({.id = each.id,
                        .icon = QStringLiteral("open"),
                        .name = bareName(each.path),
                        .toolTip = plainTitle(each.path)});
    }
    return tabs;
}

void Documents::arrangeTabs() {
    for (const auto& each : documents_) {
        each->hasTab = each->hasTab || !isUntouched(*each);
    }
    tabs_->arrange(caseTabs(), current_ != nullptr ? current_->id : 0);
    // Who has stood in the bar beside others does not vanish from it.
    if (current_ != nullptr) {
        const auto opened = tabs_->count() - static_cast<int>(later_.size());
        current_->hasTab = current_->hasTab || opened > 1;
    }
}

}  // namespace ravnoves
