#include "workshop/workshop_page.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QProgressDialog>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>
#include <atomic>

#include "model/background_job.h"
#include "page/rejected_entries.h"
#include "pictures/file_dialogs.h"
#include "shop/model/verdict.h"
#include "shop/scale_input.h"
#include "text/file_path.h"
#include "text/language.h"
#include "text/write_file.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/verdict_line.h"
#include "workshop/journal_dialog.h"
#include "workshop/model/workshop_model.h"
#include "workshop/sheets.h"
#include "workshop/workshop_answer.h"
#include "workshop/workshop_card.h"

namespace ravnoves {

namespace {
constexpr int sheetWidth = 470;
constexpr int narrowestSheet = 280;

/// One types into it.
bool isEntry(const QWidget* field, const WorkshopSheet& sheet) {
    return qobject_cast<const EntryField*>(field) != nullptr && field->isEnabled() &&
           field->isVisibleTo(&sheet);
}

}  // namespace

WorkshopPage::WorkshopPage(QWidget* parent, SceneModel* kept)
    : WorkshopPage(Journal::defaultPath(), parent, kept) {}

WorkshopPage::WorkshopPage(const QString& journalPath, QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<WorkshopModel>(kept, journalPath)) {
    model_->setRejected({});  // by the fields of a page before
    connect(model_, &SceneModel::changed, this, [this] {
        if (model_->hasRejected()) {
            noteRejected();  // their places change with the runs
        }
    });
    QVBoxLayout* column = columnIn(this, 0);
    column->addWidget(buildBanner());
    verdict_ = new VerdictLine(this);
    connect(verdict_, &VerdictLine::acted, this, &WorkshopPage::doVerdictAct);
    for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
        connect(model_, signal, this, &WorkshopPage::showVerdict);
    }
    column->addWidget(verdict_);
    sheets_ = new FittedTabs(this);
    sheets_->setObjectName(QStringLiteral("sheets"));
    sheets_->setDocumentMode(true);
    sheets_->setFixedWidth(Theme::withText(sheetWidth));
    answer_ = new WorkshopAnswer(model_, this);
    machine_ = new MachineSheet(model_);
    correction_ = new CorrectionSheet(model_);
    addSheet(new JobSheet(model_), tr("&1 Job"));
    addSheet(new PartsSheet(model_), tr("&2 Parts"));
    addSheet(new WeighInSheet(model_), tr("&3 Weigh-in"));
    addSheet(new PlugsSheet(model_), tr("&4 Plugs"));
    addSheet(machine_, tr("&5 Machine"));
    addSheet(correction_, tr("&6 Correction"));
    column->addWidget(new PageColumns({.inputs = sheets_,
                                       .tabs = sheets_,
                                       .plots = nullptr,
                                       .results = answer_,
                                       .narrowest = Theme::withText(narrowestSheet)},
                                      this),
                      1);
    connect(model_, &WorkshopModel::sheetChosen, sheets_, &QTabWidget::setCurrentIndex);
    connect(model_, &WorkshopModel::crankForgotten, this, [this] {
        Q_EMIT status(
            tr("Another engine: planes, heavy metal, nominal masses, service speed and own limit "
               "of the previous crankshaft are cleared. Undo restores them."));
    });
    const auto showPlugs = [this] {
        constexpr int plugsTab = 3;
        sheets_->setTabVisible(plugsTab, model_->hasPlugs());
    };
    connect(model_, &SceneModel::changed, this, showPlugs);
    showPlugs();
    showVerdict();
    beginSheets();
    connect(model(), &SceneModel::restarted, this, &WorkshopPage::beginSheets);
    connect(sheets_, &QTabWidget::currentChanged, this, [this](int sheet) {
        const WorkshopSheet* form = forms_.value(sheet);
        if (form == nullptr) {
            return;  // in a narrow window the answer is a tab of its own
        }
        answer_->setOfMachine(form == machine_ || form == correction_);
        // Qt has given the focus to where the sheet had it last; where that is gone, elsewhere.
        const QWidget* at = window()->focusWidget();
        if (!isVisible() || at == sheets_->tabBar()) {
            return;
        }
        const bool isThere = sheets_->currentWidget()->isAncestorOf(at) && at->isVisible();
        if (unseen_.remove(sheet) || !isThere || form == machine_) {
            nextEntry(*form, true)->setFocus(Qt::TabFocusReason);
        }
    });
    buildActions();
    connect(model(), &SceneModel::restarted, this, [this] { say({}); });
    connect(model_, &WorkshopModel::broughtWithoutRejected, this, [this](const QString& rejected) {
        say(tr("Entries were not accepted when the program ended. Enter or check them again: %1")
                .arg(rejected));
    });
}

/// News of the journal or the card, until they are understood.
QWidget* WorkshopPage::buildBanner() {
    banner_ = new Panel(this);
    QHBoxLayout* row = rowIn(banner_, -1, barMargins);
    news_ = copyableLabel("banner", Theme::baseSize, banner_, true);
    row->addWidget(news_, 1);
    offer_ = largeButton("backup_restore", tr("Restore the backup"), banner_);
    row->addWidget(offer_);
    QPushButton* close = largeButton("banner_close", tr("Understood"), banner_);
    row->addWidget(close);
    banner_->hide();
    connect(offer_, &QPushButton::clicked, this, [this] { restoreFrom(desk()->offeredBackup()); });
    connect(close, &QPushButton::clicked, this, [this] {
        said_.clear();
        banner_->hide();
    });
    connect(desk(), &JobDesk::journalTroubleChanged, this, &WorkshopPage::showNews);
    return banner_;
}

void WorkshopPage::say(const QString& text) {
    if (text != said_) {
        said_ = text;
        showNews();
    }
}

void WorkshopPage::showNews() {
    const QString news = said_.isEmpty() ? desk()->journalTrouble() : said_;
    news_->setText(news);
    offer_->setVisible(said_.isEmpty() && !news.isEmpty() && !desk()->offeredBackup().isEmpty());
    banner_->setVisible(!news.isEmpty());
}

SceneModel* WorkshopPage::model() {
    return model_;
}

JobDesk* WorkshopPage::desk() const {
    return model_->desk();
}

void WorkshopPage::showVerdict() {
    const Verdict verdict = model_->shown().verdictShown().value();
    verdict_->show(verdict, verdict.act == workshop::swap_ends_act ? tr("Swap the rod ends")
                            : verdict.act == workshop::drilled_act ? tr("Correct the drilled holes")
                            : verdict.act == workshop::present_plan_act ? tr("Use the present plan")
                                                                        : QString());
}

void WorkshopPage::doVerdictAct() {
    if (model_->verdictShown()->act == workshop::swap_ends_act) {
        model_->swapRodEnds();
        return;
    }
    if (model_->verdictShown()->act == workshop::present_plan_act) {
        model_->usePresentPlan();
        return;
    }
    sheets_->setCurrentIndex(static_cast<int>(forms_.indexOf(correction_)));
    if (QWidget* hole = correction_->drilled(model_->doubts().front().hole)) {
        hole->setFocus(Qt::TabFocusReason);
    }
}

void WorkshopPage::addSheet(WorkshopSheet* form, const QString& title) {
    form->setMaximumWidth(Theme::withText(sheetWidth));  // a field is near its name
    auto* scroll = scrolled(form, sheets_);
    sheets_->addTab(scroll, title);
    forms_ << form;
    scroll->setObjectName(QStringLiteral("sheet-%1").arg(forms_.size()));
    const int tab = sheets_->count() - 1;
    const auto follow = [this, tab](QWidget* field) {
        field->installEventFilter(this);
        if (auto* entry = qobject_cast<EntryField*>(field)) {
            connect(entry, &EntryField::troubleChanged, this, [this, tab] {
                markTab(tab);
                noteRejected();
            });
        }
    };
    std::for_each(form->order().begin(), form->order().end(), follow);
    connect(form, &WorkshopSheet::fieldAdded, this, follow);
    connect(model(), &SceneModel::changed, this, [this, tab] { markTab(tab); });
    connect(&Theme::instance(), &Theme::changed, this, [this, tab] { markTab(tab); });
    markTab(tab);  // a page made again shows a job that is there
}

void WorkshopPage::noteRejected() {
    std::vector<std::string> places;
    for (const WorkshopSheet* form : forms_) {
        std::ranges::move(form->rejectedPlaces(), std::back_inserter(places));
    }
    model_->setRejected(rejectedInputs(this), places);
}

void WorkshopPage::markTab(int tab) {
    // A tab that hides a rejected entry says so, or readings that may not hold.
    const WorkshopSheet* form = forms_.at(tab);
    const Theme& theme = Theme::instance();
    const QColor colour = form->hasRejected()  ? theme.error()
                          : form->isDoubtful() ? theme.warning()
                                               : QColor();
    if (colour != sheets_->tabBar()->tabTextColor(tab)) {
        sheets_->tabBar()->setTabTextColor(tab, colour);
    }
}

void WorkshopPage::buildActions() {
    const auto add = [this](const QString& name, const QString& icon, const QString& text,
                            const QKeySequence& keys, const QString& tip, auto&& slot) {
        auto* action = new QAction(icon.isEmpty() ? QIcon() : themedIcon(icon), text, this);
        action->setObjectName(name);
        if (!keys.isEmpty()) {
            action->setShortcut(keys);
            action->setToolTip(
                tip + QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText)));
            addAction(action);
        }
        connect(action, &QAction::triggered, this, slot);
        actions_ << action;
    };
    add(QStringLiteral("save_job"), QStringLiteral("job-done"), tr("&Save job in the journal"),
        QKeySequence(Qt::Key_F2), tr("Save the job in the journal"), [this] { saveJob(true); });
    add(QStringLiteral("put_aside"), {}, tr("Put job &aside unfinished"),
        QKeySequence(Qt::SHIFT | Qt::Key_F2), tr("Save the job in the journal to continue later"),
        [this] { saveJob(false); });
    add(QStringLiteral("new_job"), QStringLiteral("job-new"), tr("&Next job"),
        QKeySequence(Qt::Key_F4), tr("Next job: engine values are kept, other fields are cleared"),
        [this] {
            if (mayReplaceJob()) {
                model_->newJob();
                showNewJob();
            }
        });
    add(QStringLiteral("show_journal"), QStringLiteral("journal"), tr("&Journal…"),
        QKeySequence(Qt::Key_F3), tr("Find, open and copy jobs"), [this] { showJournal(); });
    actions_ << nullptr;
    const auto ofCard = [this](void (WorkshopPage::*act)()) {
        return [this, act] {
            if (rejectedEntriesAreKnown()) {
                (this->*act)();
            }
        };
    };
    add(QStringLiteral("preview_card"), QStringLiteral("preview"), tr("Job card, &preview…"),
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P), tr("Preview the job card"),
        ofCard(&WorkshopPage::previewCard));
    add(QStringLiteral("print_card"), QStringLiteral("print"), tr("&Print job card…"),
        QKeySequence(Qt::CTRL | Qt::Key_P), tr("Print the job card"),
        ofCard(&WorkshopPage::printCard));
    add(QStringLiteral("export_card"), QStringLiteral("pdf"), tr("Job card as P&DF…"),
        QKeySequence(Qt::CTRL | Qt::Key_D), tr("Write the job card as PDF"),
        ofCard(&WorkshopPage::exportCard));
    buildCardLanguages();
    add(QStringLiteral("shop"), {}, tr("S&hop on the job card…"), {}, {},
        [this] { askShopName(this); });
    actions_ << nullptr;
    add(QStringLiteral("back_up"), {}, tr("&Back up the journal…"), {}, {}, [this] {
        const QString name = QStringLiteral("journal-") +
                             QDate::currentDate().toString(Qt::ISODate) + QStringLiteral(".sqlite");
        const QString file = askSavePath(this, tr("Back up the journal"), name,
                                         {{QStringLiteral("sqlite"), tr("Journal")}});
        if (!file.isEmpty()) {
            QMessageBox::information(this, tr("Journal"), desk()->backUpJournal(file));
        }
    });
    add(QStringLiteral("restore"), {}, tr("&Restore from a backup…"), {}, {}, [this] {
        const QString file =
            askOpenPath(this, tr("Restore from a backup"), {}, tr("Journal (*.sqlite)"));
        if (!file.isEmpty()) {
            restoreFrom(file);
        }
    });
}

void WorkshopPage::buildCardLanguages() {
    auto* language = new QAction(tr("&Language of the job card"), this);
    auto* menu = new QMenu(this);
    auto* group = new QActionGroup(menu);
    std::vector<Language> languages{{QString(), tr("As the program")}};
    for (Language& available : availableLanguages()) {
        languages.push_back(std::move(available));
    }
    for (const Language& each : languages) {
        QAction* choice = menu->addAction(
            each.ownName, this, [this, code = each.code] { desk()->setCardLanguage(code); });
        choice->setCheckable(true);
        choice->setChecked(each.code == desk()->cardLanguage());
        group->addAction(choice);
    }
    language->setMenu(menu);
    actions_ << language;
}

// -------------------------------------------------------------------------------- going on

bool WorkshopPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (enter && key->modifiers().testFlag(Qt::ControlModifier) == false) {
            focusNext(static_cast<QWidget*>(watched));
            return true;
        }
    } else if (event->type() == QEvent::FocusIn &&
               static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
        if (auto* scroll = qobject_cast<QScrollArea*>(sheets_->currentWidget())) {
            scroll->ensureWidgetVisible(static_cast<QWidget*>(watched), 0,
                                        WorkshopSheet::fieldHeight);
        }
    }
    return ScenePage::eventFilter(watched, event);
}

QWidget* WorkshopPage::nextEntry(const WorkshopSheet& sheet, bool isEmpty) {
    if (const auto* machine = qobject_cast<const MachineSheet*>(&sheet)) {
        return machine->nextReading();
    }
    QWidget* first = nullptr;
    for (QWidget* each : sheet.order()) {
        if (isEntry(each, sheet)) {
            if (!isEmpty ||
                (!isTypedAlone(each) && static_cast<EntryField*>(each)->text().isEmpty())) {
                return each;
            }
            first = first != nullptr ? first : each;
        }
    }
    return first != nullptr ? first : sheet.order().constFirst();
}

void WorkshopPage::beginSheets() {
    for (int sheet = 0; sheet < forms_.size(); ++sheet) {
        unseen_ << sheet;
    }
    unseen_.remove(sheets_->currentIndex());
}

void WorkshopPage::focusNext(QWidget* from) {
    auto* entry = qobject_cast<EntryField*>(from);
    if (entry != nullptr && !entry->trouble().isEmpty()) {
        QApplication::beep();  // a rejected entry is not passed over
        entry->selectAll();    // what is typed next takes its place
        return;
    }
    const QList<QWidget*>& order = forms_.at(sheets_->currentIndex())->order();
    for (QWidget* next : order.mid(order.indexOf(from) + 1)) {
        // What is typed once is not between what is weighed.
        const bool isSkipped = isTypedAlone(next) && !isTypedAlone(from);
        if (!isSkipped && next->isEnabled() && next->isVisibleTo(sheets_)) {
            next->setFocus(Qt::TabFocusReason);
            return;
        }
    }
    // The end of the sheet: on to the next one. The last sheet is not left: nobody fills the first
    // one after it.
    int then = sheets_->currentIndex() + 1;
    while (then < forms_.size() && !sheets_->isTabVisible(then)) {
        ++then;  // that of the plugs, where there are none
    }
    if (then < forms_.size()) {
        sheets_->setCurrentIndex(then);
        nextEntry(*forms_.at(then), false)->setFocus(Qt::TabFocusReason);
    } else if (entry != nullptr) {
        Q_EMIT entry->editingFinished();  // what is typed counts, as where it is left
        entry->selectAll();
    }
}

// ------------------------------------------------------------------------- journal and card

void WorkshopPage::showEvent(QShowEvent* event) {
    ScenePage::showEvent(event);
    // One types at once, and the page's keys work: they ask for a focus on it. Where the page
    // before is hidden, Qt looks for a place by itself, and may find a drawing or a table.
    QTimer::singleShot(0, this, [this] {
        if (isVisible() && QApplication::activeModalWidget() == nullptr &&
            (!sheets_->isAncestorOf(window()->focusWidget()) ||
             window()->focusWidget() == sheets_->tabBar())) {
            nextEntry(*forms_.at(sheets_->currentIndex()), true)->setFocus();
        }
    });
    if (!journalTried_) {
        journalTried_ = true;
        // After the first picture of the page: a slow disk must not delay it.
        QTimer::singleShot(0, this, &WorkshopPage::openJournal);
    }
}

void WorkshopPage::openJournal() {
    journalTried_ = true;
    desk()->openJournal();
}

bool WorkshopPage::rejectedEntriesAreKnown() {
    return continueWithoutRejected(this, tr("Entries not accepted"));
}

std::optional<bool> WorkshopPage::saveInPlace() {
    return saveJob(true);
}

QString WorkshopPage::savingTip() const {
    return tr("Save the job in the journal; “Save case as…” writes a file");
}

bool WorkshopPage::hasUnsavedJob() {
    return model()->hasChanges() && !desk()->isJournaled();
}

std::optional<bool> WorkshopPage::askToSave() {
    if (!hasUnsavedJob()) {
        return true;
    }
    const QString name = model()->jobName();
    const QString uncorrected = model()->mustBeCorrected();
    QStringList said{name.isEmpty() ? tr("Save the job on the sheet in the journal?")
                                    : tr("Save the job “%1” in the journal?").arg(name),
                     uncorrected.isEmpty() ? rejectedWords(this) : uncorrected};
    said.removeAll(QString());
    QMessageBox box(QMessageBox::Question, tr("Unsaved job"), said.join(QStringLiteral("\n\n")),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    // Enter leaves out no entry.
    box.setDefaultButton(said.size() > 1 ? QMessageBox::Cancel : QMessageBox::Save);
    box.button(QMessageBox::Discard)->setText(tr("Do&n’t save"));
    const int answer = box.exec();
    if (answer == QMessageBox::Save) {
        return mayBeSaved(this, tr("Unsaved job")) && store(true);
    }
    return answer == QMessageBox::Discard;
}

bool WorkshopPage::mayReplaceJob() {
    const bool isAsked = hasUnsavedJob();
    return *askToSave() && (isAsked || rejectedEntriesAreKnown());
}

void WorkshopPage::restoreFrom(const QString& file) {
    if (!desk()->openJournal()) {
        QMessageBox::warning(this, tr("Journal"), desk()->journalTrouble());
        return;
    }
    QProgressDialog wait(tr("Restoring %1…").arg(file), tr("Cancel"), 0, 0, this);
    wait.setWindowModality(Qt::WindowModal);
    std::atomic<bool> cancelled = false;
    connect(&wait, &QProgressDialog::canceled, this, [&] { cancelled = true; });
    QString said;
    {
        BackgroundJob job;
        connect(&job, &BackgroundJob::failed, this, [&](const QString& why) { said = why; });
        job.start([&, path = desk()->journal()->path()](
                      const BackgroundJob::Progress&) -> std::function<void()> {
            return
                [&said, result = JobDesk::restoreJournal(path, file, cancelled)] { said = result; };
        });
        while (job.isRunning()) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
    }
    wait.reset();
    desk()->takeRestored();
    QMessageBox::information(this, tr("Journal"), said);
}

Paper WorkshopPage::card() {
    const Words words = desk()->cardWords();
    const QString& language = desk()->cardLanguage();
    Retold retold;
    if (!language.isEmpty() && language != currentLanguage()) {
        retold = [&](const EntryField& field) {
            const auto form = std::ranges::find_if(
                forms_, [&](const WorkshopSheet* each) { return each->isAncestorOf(&field); });
            const QString name = form == forms_.end() ? QString() : (*form)->nameIn(words, field);
            const QString typed = words.locale().quoteString(field.text());
            return name.isEmpty() ? typed : name + QStringLiteral(": ") + typed;
        };
    }
    return jobCard(*model_, words, rejectedEntries(this, retold), rejectedInputs(this, retold));
}

bool WorkshopPage::saveJob(bool isFinished) {
    return mayBeSaved(this, tr("Journal")) && rejectedEntriesAreKnown() && store(isFinished);
}

bool WorkshopPage::store(bool isFinished) {
    if (!isJobKnown()) {
        return false;
    }
    bool saved = false;
    // What is not what is on the sheet is no finished job.
    const QString text = desk()->saveJob(&saved, isFinished && rejectedEntries(this).isEmpty());
    Q_EMIT status(saved ? text : QString());
    if (saved) {
        say({});
    } else {
        QMessageBox::warning(this, tr("Journal"), text);
    }
    return saved;
}

int WorkshopPage::ask(const QString& question, const QStringList& answers, int usual) {
    QMessageBox box(QMessageBox::Question, tr("Journal"), question, QMessageBox::NoButton, this);
    QList<QPushButton*> buttons;
    for (const QString& answer : answers) {
        buttons << box.addButton(answer, QMessageBox::AcceptRole);
    }
    QPushButton* stay = box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(buttons.value(usual, stay));
    box.exec();
    return static_cast<int>(
        buttons.indexOf(static_cast<QPushButton*>(box.clickedButton())));  // -1: to stay
}

bool WorkshopPage::isJobKnown() {
    if (desk()->isNameless() && ask(tr("The sheet has no number of engine or crankshaft and no "
                                       "customer: the journal could not find the job."),
                                    {tr("&Enter one"), tr("Save &without")}, 0) != 1) {
        goToBeginning();
        return false;
    }
    const JournalJob onSheet = model_->journalEntry();
    const QString here = onSheet.numbers();
    const auto same = desk()->sameJob();
    if (same) {
        const int answer = ask(tr("The journal already has a job of %1 on this day, saved on %2.")
                                   .arg(here, timeText(same->saved)),
                               {tr("&Replace it"), tr("Save as &another")}, -1);
        if (answer != 0) {
            return answer == 1;
        }
        desk()->setJob(same->id, same->revision);
    }
    QString text;
    int usual = 0;
    if (const QString there = same ? QString() : desk()->otherEngine(); !there.isEmpty()) {
        text = there == here
                   ? tr("The job of %1 in the journal is for another engine than the sheet.")
                         .arg(there)
                   : tr("The job in the journal is for %1, the sheet for %2.").arg(there, here);
    } else if (const QString verdict = desk()->verdictToLose(); !verdict.isEmpty()) {
        const Words words;
        text = tr("The job of %1 in the journal is finished, verdict: %2. With this sheet the "
                  "verdict is: %3.")
                   .arg(here, verdictText(words, verdict), verdictText(words, onSheet.verdict));
        usual = -1;
    } else {
        return true;
    }
    // Of one engine a key that is pressed without reading makes no second job.
    const int answer = ask(text, {tr("Save as a &new job"), tr("&Change that job")}, usual);
    if (answer == 0 || (same && answer < 0)) {
        desk()->setJob();
    }
    return answer >= 0;
}

void WorkshopPage::goToBeginning() {
    sheets_->setCurrentIndex(0);
    nextEntry(*forms_.constFirst(), true)->setFocus(Qt::TabFocusReason);
}

void WorkshopPage::showNewJob() {
    goToBeginning();
    beginSheets();
    Q_EMIT status(
        tr("New job. Cleared: numbers, customer, typed and weighed masses, readings, holes and the "
           "crankshaft’s mass. Engine, machine, planes and drills are kept."));
}

void WorkshopPage::showJournal(const QString& search) {
    if (!desk()->openJournal()) {
        QMessageBox::warning(this, tr("Journal"), desk()->journalTrouble());
        return;
    }
    JournalDialog dialog(desk()->journal(), this, search);
    if (dialog.exec() == QDialog::Accepted) {
        bringJob(dialog.chosenId(), dialog.isCopy());
    }
}

void WorkshopPage::openJob(qint64 id) {
    if (desk()->jobId() != id) {
        bringJob(id, false);
    }
}

void WorkshopPage::bringJob(qint64 id, bool isCopy) {
    // One that is open beside this one is not opened twice: the later saving would be a copy.
    for (ScenePage* other : others()) {
        const auto* page = qobject_cast<WorkshopPage*>(other);
        if (!isCopy && page != nullptr && page->desk()->jobId() == id) {
            Q_EMIT other->frontWanted();
            return;
        }
    }
    if (!mayReplaceJob()) {
        return;
    }
    const QString trouble = desk()->openJob(id, isCopy);
    Q_EMIT status({});  // what was said of the sheet before
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, tr("Journal"), trouble);
    } else if (isCopy) {
        showNewJob();
    }
}

bool WorkshopPage::paintCard(QPrinter* printer) {
    if (printPaper(card(), *printer)) {
        return true;
    }
    QMessageBox::warning(this, tr("Job card"), tr("The printer cannot be used."));
    return false;
}

void WorkshopPage::previewCard() {
    QPrinter printer(QPrinter::HighResolution);
    setPaper(printer, cardPaper());
    QPrintPreviewDialog dialog(&printer, this);
    dialog.setWindowTitle(tr("Job card"));
    dialog.resize(900, 760);
    bool isPainted = false;
    connect(&dialog, &QPrintPreviewDialog::paintRequested, this,
            [&](QPrinter* each) { isPainted = paintCard(each); });
    if (dialog.exec() == QDialog::Accepted && isPainted) {
        model_->keepPlan();
    }
    keepCardPaper(printer);
}

void WorkshopPage::printCard() {
    QPrinter printer(QPrinter::HighResolution);
    setPaper(printer, cardPaper());
    QPrintDialog dialog(&printer, this);
    dialog.setOption(QPrintDialog::PrintPageRange, false);  // the card is printed whole
    if (dialog.exec() == QDialog::Accepted) {
        keepCardPaper(printer);
        if (paintCard(&printer)) {
            model_->keepPlan();
        }
    }
}

QString WorkshopPage::writeCard(const QString& file) {
    const QString why =
        writeFile(file, [this] { return paperAsPdf(card(), cardPaper()).toStdString(); });
    if (why.isEmpty()) {
        model_->keepPlan();
    }
    return why;
}

void WorkshopPage::exportCard() {
    const QString name = asFileName(model()->jobName());
    const QString file =
        askSavePath(this, tr("Job card as PDF"),
                    (name.isEmpty() ? QStringLiteral("job-card") : name) + QStringLiteral(".pdf"),
                    {pdfFormat()});
    if (file.isEmpty()) {
        return;
    }
    const QString trouble = writeCard(file);
    if (trouble.isEmpty()) {
        Q_EMIT status(tr("Written: %1").arg(file));
    } else {
        QMessageBox::warning(this, tr("Job card as PDF"), trouble);
    }
}

}  // namespace ravnoves
