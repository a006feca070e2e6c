#include "studies/tolerance_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

#include "case-file/message.h"
#include "model/background_job.h"
#include "model/scene_model.h"
#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "plot/plot_view.h"
#include "studies/model/study_figures.h"
#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "studies/sweep_view.h"
#include "studies/tolerance_bands.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/result_table.h"
#include "widgets/table_editor.h"

namespace ravnoves {

namespace {

constexpr int tornadoBar = 3;  ///< column

/// Rows are as high as their wrapped names take, also after the column has another width.
void growRowsWithWords(QTableView& view) {
    view.verticalHeader()->setMinimumSectionSize(view.verticalHeader()->defaultSectionSize());
    view.verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    QObject::connect(view.horizontalHeader(), &QHeaderView::sectionResized, &view,
                     &QTableView::resizeRowsToContents, Qt::QueuedConnection);
}

}  // namespace

ToleranceWindow::ToleranceWindow(ScenePage* page, QWidget* parent)
    : QDialog(parent), page_(page), model_(new StudyModel(page->model(), this)) {
    // Over the window of the page, however large that is.
    setWindowFlags(Qt::Dialog | Qt::WindowTitleHint | Qt::WindowSystemMenuHint |
                   Qt::WindowMinMaxButtonsHint | Qt::WindowCloseButtonHint);
    setObjectName(QStringLiteral("tolerances"));
    resizeWithText(this, 1120, 680);
    auto* row = new QVBoxLayout(this);
    auto* parts = new QSplitter(this);
    parts->addWidget(makeInputs());
    parts->addWidget(makeAnswers());
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 3);
    parts->setChildrenCollapsible(false);
    parts->setHandleWidth(Theme::space);
    constexpr double inputsPart = 0.36;
    const int inputsWidth = static_cast<int>(inputsPart * width());
    parts->setSizes({inputsWidth, width() - inputsWidth});
    row->addWidget(parts);
    connect(model_, &StudyModel::changed, this, &ToleranceWindow::showStudy);
    connect(model_, &StudyModel::answered, this, &ToleranceWindow::showAnswers);
    connect(&Theme::instance(), &Theme::changed, this, &ToleranceWindow::showAnswers);
    addKeys();
    connect(page, &QObject::destroyed, this, [this] { done(Rejected); });
    connect(model_->scene(), &SceneModel::titleChanged, this, &ToleranceWindow::showTitle);
    showTitle();
    showStudy();
    showAnswers();
}

void ToleranceWindow::addKeys() {
    const auto add = [this](const QKeySequence& keys, std::function<void()> use) {
        connect(new QShortcut(keys, this), &QShortcut::activated, this, std::move(use));
    };
    SceneModel* scene = model_->scene();
    add(QKeySequence(Qt::CTRL | Qt::Key_Z), [scene] { scene->undo(); });
    add(QKeySequence(Qt::CTRL | Qt::Key_Y), [scene] { scene->redo(); });
    add(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), [scene] { scene->redo(); });
    add(QKeySequence(Qt::CTRL | Qt::Key_S), [this] { Q_EMIT saveWanted(); });
    for (const TableEditor* editor : {inputs_, watched_}) {
        connect(scene, &SceneModel::broughtIn, editor->table(), &EditableTable::forgetRejected);
        editor->view()->installEventFilter(this);
    }
}

void ToleranceWindow::reject() {
    if (continueWithoutRejected(this, tr("Tolerances"))) {
        QDialog::reject();
    }
}

bool ToleranceWindow::eventFilter(QObject* object, QEvent* event) {
    const int key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event)->key() : 0;
    if (key == Qt::Key_Escape) {
        // A table would take it for a letter.
        if (!(object == inputs_->view() ? inputs_ : watched_)->takeBackRejected()) {
            reject();
        }
        return true;
    }
    const QItemSelection cells = key == Qt::Key_Delete && object == watched_->view()
                                     ? watched_->view()->selectionModel()->selection()
                                     : QItemSelection();
    if (!cells.isEmpty() && cells.first().left() > StudyTable::Name) {  // limits alone
        const QItemSelectionRange& range = cells.first();
        watched_->table()->pasteBlock(
            range.top(), range.left(),
            std::vector<QStringList>(static_cast<std::size_t>(range.height()),
                                     QStringList(range.width())));
        return true;
    }
    return QDialog::eventFilter(object, event);
}

QWidget* ToleranceWindow::makeInputs() {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    const auto edit = [&](EditableTable* table, const QString& name, const QString& remove) {
        auto* editor = new TableEditor(table, name, {}, remove, holder);
        table->setParent(editor);
        editor->findChild<QToolButton*>(QStringLiteral("add_row"))->hide();
        editor->view()->verticalHeader()->hide();
        QHeaderView* header = editor->view()->horizontalHeader();
        constexpr int minimum = 72;  // room to type in
        header->setMinimumSectionSize(Theme::withText(minimum));
        header->setSectionResizeMode(QHeaderView::ResizeToContents);
        header->setSectionResizeMode(StudyTable::Name, QHeaderView::Stretch);
        growRowsWithWords(*editor->view());
        editor->layout()->itemAt(0)->widget()->hide();  // no caption: the heading is above
        editor->layout()->setContentsMargins(0, 0, 0, 0);
        // Where a fault comes and goes nothing moves: a click goes where it was meant to.
        QWidget* fault = editor->layout()->itemAt(editor->layout()->count() - 1)->widget();
        QSizePolicy room = fault->sizePolicy();
        room.setRetainSizeWhenHidden(true);
        fault->setSizePolicy(room);
        fault->setMinimumHeight(2 * QFontMetrics(fault->font()).lineSpacing());
        // Before and after what was said of a block that was not pasted.
        const auto say = [editor] { editor->say(editor->trouble(), true); };
        connect(table, &QAbstractItemModel::dataChanged, editor, say);
        connect(table, &QAbstractItemModel::modelReset, editor, say);
        connect(table, &EditableTable::troubleChanged, this, [this, say] {
            say();
            showAnswers();  // they are without what is rejected
        });
        return editor;
    };
    auto* top = new QHBoxLayout;
    QLabel* heading = headingLabel(tr("Inputs and their tolerances"), holder);
    heading->setWordWrap(true);
    top->addWidget(heading, 1);
    auto* presets = new QPushButton(tr("&Typical tolerances"), holder);
    presets->setObjectName(QStringLiteral("presets"));
    presets->setAutoDefault(false);
    auto* menu = new QMenu(presets);
    const auto add = [&](const QString& text, StudyModel::Preset preset) {
        menu->addAction(text, model_, [this, preset] { model_->take(preset); });
    };
    add(tr("&Weighed parts: ± %1, machined sizes: ± %2")
            .arg(shownShort(StudyModel::weighedGrams * units::gram, units::gram, 3),
                 shownShort(StudyModel::machinedMm * units::mm, units::mm, 3)),
        StudyModel::Preset::Typical);
    add(tr("&All inputs: ± 1 %"), StudyModel::Preset::OnePercent);
    menu->addSeparator();
    menu->addAction(tr("&Remove all"), model_, &StudyModel::clear);
    presets->setMenu(menu);
    top->addWidget(presets);
    column->addLayout(top);
    inputs_ = edit(new ScatterTable(model_), tr("Inputs and their tolerances"),
                   tr("Remove the tolerances of the selected inputs"));
    column->addWidget(inputs_, 3);
    column->addWidget(headingLabel(tr("Results to watch"), holder));
    auto* watchable = new QPushButton(tr("Watch a result…"), holder);
    watchable->setObjectName(QStringLiteral("watchable"));
    watchable->setAutoDefault(false);
    auto* results = new QMenu(watchable);
    connect(results, &QMenu::aboutToShow, this, [this, results] {
        results->clear();
        for (const std::string& pointer : model_->results()) {
            results->addAction(model_->resultName(pointer).withUnit(), this,
                               [this, pointer] { watch(pointer); });
        }
    });
    watchable->setMenu(results);
    column->addWidget(watchable);
    watched_ =
        edit(new WatchTable(model_), tr("Results to watch"), tr("Remove the selected results"));
    column->addWidget(watched_, 2);
    return holder;
}

QWidget* ToleranceWindow::makeAnswers() {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    const auto chooser = [&](const QString& text, const char* name) {
        auto* label = new QLabel(text, holder);
        auto* box = new QComboBox(holder);
        box->setObjectName(QLatin1String(name));
        constexpr int minChooser = 90;  // they give way where the text is large
        box->setMinimumWidth(Theme::withText(minChooser));
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box);
        return box;
    };
    method_ = chooser(tr("M&ethod"), "method");
    samples_ = chooser(tr("&Samples"), "samples");
    for (const studies::Method method :
         {studies::Method::sobol, studies::Method::monte_carlo, studies::Method::linear}) {
        const auto number = static_cast<std::size_t>(method);
        method_->addItem(shownText(studies::method_words()[number].label),
                         static_cast<int>(method));
    }
    connect(method_, &QComboBox::activated, this, [this] {
        model_->setMethod(static_cast<studies::Method>(method_->currentData().toInt()));
    });
    connect(samples_, &QComboBox::activated, this,
            [this](int index) { model_->setSamples(samples_->itemData(index).toULongLong()); });
    row->addStretch();
    column->addLayout(row);

    const auto newTable = [](const QString& name, QWidget* parent) {
        auto* table = new ResultTable(name, parent);
        constexpr int shownRows = 4;
        table->setShownRows(shownRows);
        constexpr int minHeight = 60;  // further rows scroll
        table->setMinimumHeight(Theme::withText(minHeight));
        table->setWordWrap(true);  // names that begin alike are distinguished by their ends
        growRowsWithWords(*table);
        return table;
    };
    table_ = newTable(tr("Results with tolerances"), holder);
    table_->setColumns(foundResults(*model_).columns);
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
        histogram_->resetZoom();  // to part of another result
        showChosen();
        const StudyAnswers* answers = model_->answers();
        if (const auto place = static_cast<std::size_t>(row);
            answers != nullptr && place < answers->values.size()) {
            sweep_->chooseResult(answers->values[place].pointer);
        }
    });
    column->addWidget(table_, 2);
    words_ = captionLabel({}, holder);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* notes = scrolled(words_, holder);
    constexpr int notesHeight = 46;
    notes->setFixedHeight(Theme::withText(notesHeight));
    column->addWidget(notes);

    auto* tabs = new QTabWidget(holder);
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(true);
    tornado_ = newTable(tr("Main contributors"), tabs);
    tabs->addTab(tornado_, tr("Main contributors"));
    histogram_ = new PlotView(tabs);
    tabs->addTab(histogram_, tr("Histogram"));
    sweep_ = new SweepView(model_, tabs);
    addScrolledTab(tabs, sweep_, QStringLiteral("sweep"), tr("Sweep"));
    constexpr int minTab = 220;  // narrower than what is in it, it scrolls sideways
    for (QScrollArea* tab : tabs->findChildren<QScrollArea*>()) {
        tab->setMinimumWidth(Theme::withText(minTab));
    }
    column->addWidget(tabs, 5);
    bands_ = new QCheckBox(tr("Show &bands and ± on the page"), holder);
    bands_->setObjectName(QStringLiteral("bands"));
    connect(bands_, &QCheckBox::clicked, &ToleranceBands::setShown);
    auto* progress = new JobProgress(model_->job(), tr("Progress"), holder);
    constexpr int minProgress = 60;  // beside long words
    progress->setMinimumWidth(Theme::withText(minProgress));
    auto* below = new QHBoxLayout;
    below->addWidget(bands_, 1);
    below->addWidget(progress);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, holder);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);  // Enter is of the tables
    connect(buttons, &QDialogButtonBox::rejected, this, &QWidget::close);
    below->addWidget(buttons);
    column->addLayout(below);
    return holder;
}

void ToleranceWindow::watch(const std::string& pointer) {
    model_->watch(pointer);
    const auto& watch = model_->study().watch;
    const auto at = std::ranges::find(watch, pointer, &studies::Watched::pointer);
    QTableView* view = watched_->view();
    if (at != watch.end()) {
        view->setCurrentIndex(
            view->model()->index(static_cast<int>(at - watch.begin()), WatchTable::Minimum));
    }
    view->setFocus();
}

void ToleranceWindow::showTitle() {
    const QString title = model_->scene()->titleShown();
    setWindowTitle(title.isEmpty() ? tr("Tolerances")
                                   : tr("Tolerances") + QStringLiteral(" – ") + title);
}

void ToleranceWindow::showStudy() {
    const studies::Study& study = model_->study();
    method_->setCurrentIndex(method_->findData(static_cast<int>(study.method)));
    const QSignalBlocker block(samples_);
    samples_->clear();
    std::vector<std::uint64_t> offered{1024, 4096, 16384, 65536};
    if (std::find(offered.begin(), offered.end(), study.samples) == offered.end()) {
        offered.push_back(study.samples);
    }
    for (const std::uint64_t samples : offered) {
        samples_->addItem(QLocale().toString(samples), QVariant::fromValue(samples));
    }
    samples_->setCurrentIndex(samples_->findData(QVariant::fromValue(study.samples)));
    samples_->setEnabled(studies::is_sampled(study.method));
}

void ToleranceWindow::showAnswers() {
    showFound();
    showChosen();
}

void ToleranceWindow::showFound() {
    QStringList lines;
    const QStringList rejected =
        static_cast<const ScatterTable*>(inputs_->view()->model())->rejectedNames();
    if (!rejected.isEmpty()) {
        lines << tr("Out of date: these tolerances were not accepted: %1.")
                     .arg(rejected.join(QStringLiteral(", ")));
    }
    if (const QString gone = model_->removedMethod(); !gone.isEmpty()) {
        lines << tr("The method of this case, %1, is no longer available. Sobol points are used; "
                    "tolerances and limits are kept.")
                     .arg(gone == u"second-order" ? tr("second order") : tr("Latin hypercube"));
    }
    const StudyAnswers* answers = model_->answers();
    if (!model_->trouble().isEmpty()) {
        lines << model_->trouble();
    } else if (model_->study().vary.empty()) {
        lines << tr(
            "Enter the tolerance of an input in the column ±, or choose typical "
            "tolerances.");
    } else if (model_->study().watch.empty()) {
        lines << tr("Choose a result to watch.");
    } else if (answers != nullptr) {
        if (model_->isStale()) {
            lines << tr("Values before the change; computing…");
        }
        for (const auto& [severity, line] : notesOf(*model_).lines) {
            lines << line;
        }
    }
    const Theme& theme = Theme::instance();
    QPalette ink = table_->palette();
    ink.setColor(QPalette::Text, !rejected.isEmpty() ? theme.warning()
                                 : model_->isStale() ? theme.mutedText()
                                                     : theme.text());
    colourText(words_, rejected.isEmpty() ? &Theme::mutedText : &Theme::warning);
    table_->setPalette(ink);
    const QSignalBlocker block(table_);  // no row that the user chose
    table_->setRows(model_->trouble().isEmpty() ? foundResults(*model_).rows : ResultRows());
    for (int row = 0; row < table_->rowCount(); ++row) {
        const StudyAnswer& value = answers->values[static_cast<std::size_t>(row)];
        if (value.fails) {
            constexpr int linearColumn = 4;
            table_->item(row, linearColumn)->setToolTip(model_->named(*value.fails));
        }
    }
    if (table_->currentRow() < 0 && table_->rowCount() > 0) {
        table_->setCurrentCell(0, 0);
    }
    words_->setText(lines.join(QLatin1Char('\n')));
}

void ToleranceWindow::showChosen() {
    const StudyAnswers* answers = model_->answers();
    const auto row = static_cast<std::size_t>(std::max(table_->currentRow(), 0));
    histogram_->setFaded(model_->isStale(), model_->isStale() ? tr("Computing…") : QString());
    tornado_->setEnabled(!model_->isStale());
    const StudyAnswer* value =
        answers != nullptr && row < answers->values.size() ? &answers->values[row] : nullptr;
    histogram_->showFigure(histogramFigure(*model_, value));
    tornado_->setResults(tornado(*model_, value));
    for (int bar = 0; bar < tornado_->rowCount(); ++bar) {
        tornado_->item(bar, tornadoBar)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }
}

void ToleranceWindow::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    model_->setWatched(true);
    bands_->setChecked(ToleranceBands::areShown());
}

void ToleranceWindow::hideEvent(QHideEvent* event) {
    model_->setWatched(false);
    QDialog::hideEvent(event);
}

}  // namespace ravnoves
