#include "shell/documents.h"

#include <QApplication>
#include <QEvent>
#include <QFileInfo>
#include <QKeySequence>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/json.h"
#include "model/recovery.h"
#include "page/scene_page.h"
#include "scenes/case_sources.h"
#include "text/file_path.h"
#include "text/plain_title.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"

namespace ravnoves {

Documents::Documents(QWidget* parent) : QWidget(parent), scenes_(sceneList()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    makeTabs();
    column->addWidget(tabs_);
    notices_ = new Panel(this);
    notices_->setObjectName(QStringLiteral("disk_notice"));
    rowIn(notices_, Theme::space, barMargins);
    notices_->hide();
    column->addWidget(notices_);
    stack_ = new QStackedWidget(this);
    column->addWidget(stack_, 1);
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
    const auto last = std::find_if(documents.rbegin(), documents.rend(),
                                   [&](const auto& each) { return fits(*each); });
    return last != documents.rend() ? last->get() : nullptr;
}

/// By whatever name, and also where nothing is there.
bool isSame(const QString& known, const QString& path) {
    return !known.isEmpty() && (known == QFileInfo(path).absoluteFilePath() ||
                                is_same_file(fsPath(known), fsPath(path)));
}

}  // namespace

OpenDocument* Documents::withFile(const QString& path) const {
    return lastWhere(documents_,
                     [&](const OpenDocument& each) { return isSame(each.document->path(), path); });
}

OpenDocument* Documents::of(const QObject* document) const {
    return lastWhere(documents_,
                     [&](const OpenDocument& each) { return each.document == document; });
}

OpenDocument* Documents::at(int tab) const {
    return of(tabs_->tabData(tab).value<QObject*>());
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
    added.scene = scene;
    putPage(added, scenes_[scene].make(stack_, nullptr));
    SceneModel* model = added.page->model();
    added.document = new CaseDocument(model, this);
    added.beginning = model->inputJson().dump();
    for (const auto signal : {&SceneModel::historyChanged, &SceneModel::rejectedInChanged}) {
        connect(model, signal, this, [this, &added] {
            if (&added == current_) {
                Q_EMIT historyChanged();
            }
        });
    }
    connect(added.document, &CaseDocument::nameChanged, this, [this] {
        nameTabs();
        Q_EMIT changed();
    });
    connect(added.document, &CaseDocument::filesChanged, this, &Documents::showNotices);
    if (recovery_ != nullptr) {
        recovery_->watch(added.document);
    }
    return added;
}

void Documents::putPage(OpenDocument& document, ScenePage* page) {
    document.page = page;
    page->setOthers([this, page] {
        QList<ScenePage*> others;
        for (const auto& each : documents_) {
            if (each->page != page) {
                others.prepend(each->page);
            }
        }
        return others;
    });
    connect(page, &ScenePage::frontWanted, this, [this, &document] { bringToFront(document); });
    connect(page, &ScenePage::status, this, [this, &document](const QString& text) {
        if (&document == current_) {
            Q_EMIT status(text);
        }
    });
    stack_->addWidget(page);
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
    dressTabs();
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
    OpenDocument* last =
        lastWhere(documents_, [scene](const OpenDocument& each) { return each.scene == scene; });
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
        Q_EMIT currentChanged();
        return;
    }
    if (current_ != nullptr) {
        current_->page->setActive(false);
    }
    current_ = &document;
    const auto place = std::find_if(documents_.begin(), documents_.end(),
                                    [&](const auto& each) { return each.get() == &document; });
    std::rotate(place, place + 1, documents_.end());
    stack_->setCurrentWidget(document.page);
    // While no page is seen Qt leaves the focus with the one before, and gives it back there.
    if (QWidget* last = focusWidget();
        last != nullptr && stack_->isAncestorOf(last) && !document.page->isAncestorOf(last)) {
        last->clearFocus();
    }
    arrangeTabs();
    document.document->checkFiles();
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
    if (OpenDocument* document = at(tab)) {
        bringToFront(*document);
    }
}

bool Documents::hasSeveralTabs() const {
    return tabs_->count() > 1;
}

// ----------------------------------------------------------------------- crashes and others

void Documents::keepIn(Recovery* recovery) {
    recovery_ = recovery;
    for (const auto& each : documents_) {
        recovery_->watch(each->document);
    }
}

void Documents::showNotices() {
    if (current_ == nullptr) {
        return;
    }
    const bool hadFocus = notices_->isAncestorOf(QApplication::focusWidget());
    notices_->hide();
    for (QWidget* before :
         notices_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        before->setParent(nullptr);
        before->deleteLater();  // it may be the button that was pressed
    }
    CaseDocument* document = current_->document;
    const FileOnDisk* file = document->changedFile();
    if (file == nullptr) {
        if (hadFocus) {  // else it goes where it happens to
            QWidget* last = current_->page->focusWidget();
            (last != nullptr ? last : current_->page)->setFocus(Qt::OtherFocusReason);
        }
        return;
    }
    const bool isMissing = file->state() == FileOnDisk::State::Missing;
    auto* text = new QLabel((isMissing ? tr("%1 was deleted, moved or renamed.")
                                       : tr("%1 was changed by another program."))
                                .arg(QFileInfo(file->path()).fileName()),
                            notices_);
    text->setToolTip(file->path());
    text->setWordWrap(true);
    static_cast<QHBoxLayout*>(notices_->layout())->addWidget(text, 1);
    const auto add = [this](const char* name, const QString& label, const QString& tip,
                            auto pressed) {
        auto* button = new QPushButton(label, notices_);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(tip);
        notices_->layout()->addWidget(button);
        connect(button, &QPushButton::clicked, this, pressed);
    };
    if (!isMissing) {
        add("disk_reload", tr("Reload"),
            tr("Show the present contents of the file. Undo restores this page."),
            [this, document] {
                const QString trouble = document->reload();
                if (!trouble.isEmpty()) {
                    QMessageBox::warning(window(), tr("Open case"), trouble);
                }
            });
    }
    const bool isOwn = document->isOwn(file);
    add("disk_keep", tr("Keep mine"),
        isOwn ? tr("Continue with this page. Saving replaces the file.")
              : tr("Continue with the numbers read before. The next time, the case opens with the "
                   "numbers of the file."),
        [document] { document->keepMine(); });
    if (isOwn) {
        add("disk_save_as", tr("Save as…"), tr("Save this page in another file."),
            [this] { saveAs(*current_); });
    }
    notices_->show();
    if (hadFocus) {
        notices_->findChild<QPushButton*>()->setFocus(Qt::OtherFocusReason);
    }
}

bool Documents::event(QEvent* event) {
    if (event->type() == QEvent::WindowActivate) {
        for (const auto& each : documents_) {
            each->document->checkFiles();
        }
    }
    return QWidget::event(event);
}

bool Documents::close(OpenDocument& document) {
    if (!mayClose(document)) {
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
    if (current_ == nullptr) {
        Q_EMIT currentChanged();
    }
    Q_EMIT changed();
    return true;
}

// ------------------------------------------------------------------------------------- tabs

void Documents::makeTabs() {
    tabs_ = new QTabBar(this);
    tabs_->setObjectName(QStringLiteral("documents"));
    tabs_->setDocumentMode(true);
    tabs_->setExpanding(false);
    tabs_->setMovable(true);
    tabs_->setTabsClosable(true);
    tabs_->setElideMode(Qt::ElideNone);  // it scrolls
    tabs_->hide();
    dressTabs();
    connect(tabs_, &QTabBar::currentChanged, this, &Documents::showTab);
    connect(tabs_, &QTabBar::tabMoved, this, &Documents::changed);
    const auto closeTab = [this](int tab) {
        if (OpenDocument* document = at(tab)) {
            close(*document);
        }
    };
    connect(tabs_, &QTabBar::tabCloseRequested, this, closeTab);
    connect(tabs_, &QTabBar::tabBarClicked, this, [closeTab](int tab) {
        if (QApplication::mouseButtons() == Qt::MiddleButton) {
            closeTab(tab);
        }
    });
}

/// In the present language and size of the text.
void Documents::dressTabs() {
    tabs_->setAccessibleName(tr("Open cases"));
    tabs_->setFont(Theme::font(Theme::smallSize));
    tabs_->setIconSize(QSize(Theme::withText(16), Theme::withText(16)));
}

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
    constexpr int widest = 250;
    QStringList titles;
    for (int tab = 0; tab < tabs_->count(); ++tab) {
        const OpenDocument* document = at(tab);
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
        title = tabs_->fontMetrics().elidedText(title, Qt::ElideMiddle, Theme::withText(widest));
        tabs_->setTabText(
            tab, title.replace(QLatin1Char('&'), QStringLiteral("&&")) +
                     (document->document->needsSaving() ? QStringLiteral(" *") : QString()));
        tabs_->setTabToolTip(
            tab, scenes_[document->scene].title +
                     (path.isEmpty() ? QString() : QLatin1Char('\n') + plainTitle(path)));
        QWidget* close = tabs_->tabButton(tab, QTabBar::RightSide);
        close->setToolTip(
            tr("Close (%1)")
                .arg(QKeySequence(Qt::CTRL | Qt::Key_W).toString(QKeySequence::NativeText)));
        close->setAccessibleName(tr("Close"));
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
            if (!hasTab(at(tab))) {
                tabs_->removeTab(tab);
            }
        }
        for (const auto& each : documents_) {
            int tab = tabs_->count() - 1;
            while (tab >= 0 && at(tab) != each.get()) {
                --tab;
            }
            if (tab < 0 && hasTab(each.get())) {
                tab = tabs_->addTab(
                    themedIcon(QStringLiteral("scene-") + scenes_[each->scene].name), {});
                tabs_->setTabData(tab, QVariant::fromValue<QObject*>(each->document));
            }
            if (each.get() == current_) {
                tabs_->setCurrentIndex(tab);
            }
        }
    }
    nameTabs();
    tabs_->setVisible(hasSeveralTabs());
    // Who has stood in the bar beside others does not vanish from it.
    if (current_ != nullptr) {
        current_->hasTab = current_->hasTab || hasSeveralTabs();
    }
}

}  // namespace ravnoves
