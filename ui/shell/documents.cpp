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

namespace {

/// The document that was in front last, of those that fit; null without one.
template <typename Fits>
OpenDocument* lastWhere(const std::vector<std::unique_ptr<OpenDocument>>& documents, Fits fits) {
    OpenDocument* last = nullptr;
    for (const auto& each : documents) {
        if (fits(*each) && (last == nullptr || each->shown > last->shown)) {
            last = each.get();
        }
    }
    return last;
}

/// By whatever name, and also where nothing is there.
bool isSame(const QString& known, const QString& path) {
    return !known.isEmpty() && (known == QFileInfo(path).absoluteFilePath() ||
                                is_same_file(fsPath(known), fsPath(path)));
}

}  // namespace

OpenDocument* Documents::lastOf(std::size_t scene) const {
    return lastWhere(documents_, [scene](const OpenDocument& each) { return each.scene == scene; });
}

OpenDocument* Documents::withFile(const QString& path) const {
    return lastWhere(documents_,
                     [&](const OpenDocument& each) { return isSame(each.document->path(), path); });
}

OpenDocument* Documents::withId(int id) const {
    return lastWhere(documents_, [id](const OpenDocument& each) { return each.id == id; });
}

bool Documents::isUntouched(const OpenDocument& document) {
    const SceneModel& model = *document.document->model();
    return !model.hasCaseFile() ||
           (document.document->path().isEmpty() && !model.hasChanges() &&
            model.history()->count() == 0 && model.inputJson().dump() == document.beginning);
}

OpenDocument* Documents::untouchedOf(std::size_t scene) const {
    return lastWhere(documents_, [scene](const OpenDocument& each) {
        return each.scene == scene && isUntouched(each);
    });
}

// ------------------------------------------------------------------------ coming and going

OpenDocument& Documents::add(std::size_t scene) {
    documents_.push_back(std::make_unique<OpenDocument>());
    OpenDocument& added = *documents_.back();
    added.id = ++ids_;
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
        nameTabs();
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
    if (OpenDocument* document = withId(tabs_->idOf(tab))) {
        bringToFront(*document);
    }
}

bool Documents::hasSeveralTabs() const {
    return tabs_->hasSeveral();
}

void Documents::put(const CaseFile& file, OpenDocument* there,
                    const std::function<void(CaseDocument&)>& load) {
    const auto scene = indexOf(QString::fromStdString(file.scene));
    if (!scene) {
        throw InputError(
            "/scene", Text::tr("must be a module of the window; the command line solves this case"),
            file.scene);
    }
    OpenDocument* reused = there != nullptr ? there : untouchedOf(*scene);
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

QString Documents::open(const QString& path, bool locates) {
    if (OpenDocument* there = withFile(path)) {
        bringToFront(*there);
        return {};
    }
    try {
        QByteArray known;
        CaseFile file = CaseDocument::read(path, &known);
        const Json input = file.input;
        const auto load = [&] {
            put(file, nullptr, [&](CaseDocument& document) {
                document.open(file, path, known);
                // Where a file is now, and what an older version has become, is to be saved.
                if (file.input != input || !file.changes.empty()) {
                    document.model()->history()->resetClean();
                }
            });
            QStringList changes;
            for (const Message& change : file.changes) {
                changes << messageText(change);
            }
            Q_EMIT status(changes.join(QLatin1Char(' ')));
        };
        if (locates) {
            MissingFile::locate(this, tr("Open case"), path, QFileInfo(path).absolutePath(), file,
                                load);
        } else {
            load();
        }
        return {};
    } catch (const InputError& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
}

QString Documents::begin(const CaseFile& file, bool isFirst) {
    try {
        put(file, nullptr, [&](CaseDocument& document) { document.begin(file); });
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
    const bool hasPath = !recovered.path.isEmpty();
    const QString name = hasPath ? recovered.path : recovered.file;
    const QString folder = hasPath ? QFileInfo(name).absolutePath() : QString();
    try {
        if (!MissingFile::locate(this, title, name, folder, file, [&] {
                put(file, there,
                    [&](CaseDocument& document) { document.restore(file, recovered); });
            })) {
            return false;
        }
    } catch (const InputError& error) {
        QMessageBox::warning(window(), title, name + QStringLiteral(": ") + errorText(error));
        return false;
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
        OpenDocument* next = lastWhere(documents_, [this](const OpenDocument& each) {
            return &each != current_ && each.hasTab;
        });
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

void Documents::nameTabs() {
    QStringList titles;
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        const OpenDocument* document = withId(tabs_->idOf(tab));
        if (document == nullptr) {
            continue;
        }
        const QString path = document->document->path();
        const QString name = path.isEmpty() ? nameOf(*document) : bareName(path);
        // Two of one name differ by their number.
        QString title = name;
        for (int number = 2; titles.contains(title); ++number) {
            title = name + QStringLiteral(" (%1)").arg(number);
        }
        titles << title;
        tabs_->name(tab, title, document->document->needsSaving(),
                    scenes_[document->scene].title +
                        (path.isEmpty() ? QString() : QLatin1Char('\n') + plainTitle(path)));
    }
}

void Documents::arrangeTabs() {
    for (const auto& each : documents_) {
        each->hasTab = each->hasTab || !isUntouched(*each);
    }
    const auto hasTab = [this](const OpenDocument* document) {
        return document != nullptr && (document->hasTab || document == current_);
    };
    {
        const QSignalBlocker quiet(tabs_);
        for (int tab = tabs_->count(); tab-- > 0;) {
            if (!hasTab(withId(tabs_->idOf(tab)))) {
                tabs_->removeCase(tab);
            }
        }
        for (const auto& each : documents_) {
            const int tab =
                hasTab(each.get())
                    ? tabs_->tabOf(each->id, QStringLiteral("scene-") + scenes_[each->scene].name)
                    : -1;
            if (each.get() == current_) {
                tabs_->setCurrentIndex(tab);
            }
        }
    }
    nameTabs();
    tabs_->setVisible(tabs_->hasSeveral());
    // Who has stood in the bar beside others does not vanish from it.
    if (current_ != nullptr) {
        current_->hasTab = current_->hasTab || tabs_->hasSeveral();
    }
}

}  // namespace ravnoves
