#include "methods/methods_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "methods/method_plots.h"
#include "methods/model/case_budget_model.h"
#include "methods/model/method_words.h"
#include "methods/validation_view.h"
#include "scenes/scenes.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

using methods::Kernel;
using methods::MethodRow;

namespace {

constexpr int progressHeight = 6;  ///< pixels

/// Columns of the table.
enum Column { Method, SettingColumn, Time, Error, Order };

QLabel* labelFor(const QString& text, QWidget* buddy, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setBuddy(buddy);
    return label;
}

ResultRow cells(const methods::KernelReport& report, const MethodRow& row) {
    const methods::MethodInfo& method = report.method(row);
    QString title = shownText(method.title);
    if (row.in_use) {
        title = MethodsPage::tr("%1 (in use)").arg(title);
    }
    const auto order = row.setting == 0 ? report.order(row.method) : std::nullopt;
    return {title, methodText(report.setting(row)), nanosecondsText(row.timing.median),
            resultText(row.result), order ? QLocale().toString(*order, 'f', 1) : QString()};
}

/// As a sentence begins; a symbol (s′, ρ) stays as it is.
QString capitalised(QString text) {
    if (text.size() > 1 && text[1].isLetter()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString paragraph(const QString& heading, const QString& text) {
    return QStringLiteral("<p><b>%1</b><br>%2</p>").arg(heading, capitalised(text).toHtmlEscaped());
}

}  // namespace

MethodsPage::MethodsPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<MethodsModel>(kept)) {
    auto* left = new QWidget(this);
    QVBoxLayout* column = columnIn(left);
    column->addWidget(buildChoice());
    column->addWidget(buildWords(), 1);
    // Tabs only where there is no room for the results beside it.
    auto* inputs = new QTabWidget(this);
    inputs->setDocumentMode(true);
    inputs->setTabBarAutoHide(true);
    inputs->setFocusPolicy(Qt::NoFocus);  // it would hand the focus to its hidden bar
    inputs->setFixedWidth(PageColumns::inputsWidth());
    inputs->addTab(left, tr("Quantity"));
    verdict_ = new VerdictLine(this);
    tabs_ = new QTabWidget(this);
    tabs_->setDocumentMode(true);
    case_ = buildCase();
    addScrolledTab(tabs_, case_, QStringLiteral("case"), tr("This case"));
    charts_ = new PageColumns(
        {.inputs = inputs, .tabs = inputs, .plots = nullptr, .results = buildResults()}, tabs_);
    charts_->setObjectName(QStringLiteral("charts"));
    tabs_->addTab(charts_, tr("Speed and accuracy"));
    validation_ = new ValidationView(tabs_);
    connect(validation_, &ValidationView::status, this, &ScenePage::status);
    connect(validation_->viewModel(), &ValidationModel::changed, this, &MethodsPage::showVerdict);
    addScrolledTab(tabs_, validation_, QStringLiteral("validation"), tr("Validation report"));
    connect(tabs_, &QTabWidget::currentChanged, this, [this] {
        updateActive();
        showVerdict();
    });
    QVBoxLayout* page = columnIn(this);
    page->addWidget(verdict_);
    page->addWidget(tabs_, 1);

    againAction_ = new QAction(themedIcon(QStringLiteral("play")), tr("&Measure again"), this);
    againAction_->setToolTip(tr("Measure this kernel again, with more repetitions (F5)"));
    againAction_->setShortcut(QKeySequence(Qt::Key_F5));
    connect(againAction_, &QAction::triggered, this, [this] {
        tabs_->setCurrentWidget(charts_);
        model_->measureAgain();
    });

    connect(model_, &MethodsModel::kernelChanged, this, &MethodsPage::showKernel);
    connect(model_, &MethodsModel::sweepChanged, this, &MethodsPage::showSweep);
    connect(model_, &MethodsModel::valueChanged, this, &MethodsPage::showValue);
    connect(model_, &SceneModel::changed, this, &MethodsPage::showTable);
    connect(model_, &MethodsModel::measurementChanged, this, &MethodsPage::showRunning);
    connect(model_, &MethodsModel::failed, this, &ScenePage::status);
    connect(&Theme::instance(), &Theme::changed, this, &MethodsPage::showTable);
    showKernel();
    showTable();
    showRunning();
}

QWidget* MethodsPage::buildChoice() {
    auto* panel = new Panel(this);
    QVBoxLayout* column =
        columnIn(panel, Theme::gap, {Theme::margin, Theme::space, Theme::margin, Theme::margin});
    kernels_ = new QComboBox(panel);
    kernels_->setObjectName(QStringLiteral("kernel"));
    kernels_->setAccessibleName(tr("Quantity"));
    kernels_->setToolTip(tr("Quantity to measure: the numerical kernels of the modules"));
    for (const Kernel& kernel : model_->kernels()) {
        kernels_->addItem(shownText(kernel.title));
    }
    connect(kernels_, &QComboBox::activated, this,
            [this](int index) { model_->setKernel(static_cast<std::size_t>(index)); });
    sweeps_ = new QComboBox(panel);
    sweeps_->setObjectName(QStringLiteral("sweep"));
    sweeps_->setAccessibleName(tr("Hard parameter"));
    sweeps_->setToolTip(
        tr("Parameter that makes the problem harder; the right chart shows the errors along it"));
    sweeps_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(sweeps_, &QComboBox::activated, this,
            [this](int index) { model_->setSweep(static_cast<std::size_t>(index)); });
    column->addWidget(labelFor(tr("&Quantity"), kernels_, panel));
    column->addWidget(kernels_);
    column->addWidget(labelFor(tr("&Hard parameter"), sweeps_, panel));
    column->addWidget(sweeps_);
    valuePlace_ = new QVBoxLayout;
    column->addLayout(valuePlace_);
    column->addSpacing(Theme::gap);
    column->addWidget(buildMeasuring());
    return panel;
}

QWidget* MethodsPage::buildMeasuring() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::gap);
    auto* row = new QHBoxLayout;
    row->setSpacing(Theme::space);
    auto* again = new QPushButton(tr("&Measure again"), holder);
    again->setObjectName(QStringLiteral("measure_again"));
    again->setToolTip(tr("Measure this kernel again, with more repetitions (F5)"));
    connect(again, &QPushButton::clicked, model_, &MethodsModel::measureAgain);
    auto* progress =
        new JobProgress(model_->measuring(), tr("Progress of the measurement"), holder);
    progress->setFixedHeight(progressHeight);
    QPushButton* cancel =
        progress->cancelButton(tr("&Cancel"), tr("Stop measuring and keep the previous results"));
    cancel->setObjectName(QStringLiteral("cancel"));
    row->addWidget(again, 1);
    row->addWidget(cancel);
    column->addLayout(row);
    column->addWidget(progress);
    return holder;
}

QWidget* MethodsPage::buildWords() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, -1, {1, 1, 1, 1});
    words_ = new QLabel;
    words_->setObjectName(QStringLiteral("words"));
    words_->setWordWrap(true);
    words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    words_->setTextFormat(Qt::RichText);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setMargin(Theme::margin);
    column->addWidget(scrolled(words_, panel));
    return panel;
}

QWidget* MethodsPage::buildCase() {
    auto* view = new QWidget(this);
    QVBoxLayout* column = columnIn(view, Theme::space, panelMargins);
    budget_ = new CaseBudgetModel(this);
    caseTitle_ = headingLabel({}, view);
    caseTitle_->setObjectName(QStringLiteral("case_title"));
    column->addWidget(caseTitle_);
    budgetTable_ = new ResultTable(tr("Contributions to the results"), view);
    budgetTable_->setObjectName(QStringLiteral("case_table"));
    budgetTable_->setWordWrap(true);
    column->addWidget(budgetTable_, 1);
    leftOut_ = copyableCaption("left_out", view);
    column->addWidget(leftOut_);
    connect(budget_, &CaseBudgetModel::changed, this, &MethodsPage::showBudget);
    return view;
}

std::optional<OpenCase> MethodsPage::caseLastInFront() const {
    for (ScenePage* other : others()) {
        if (const SceneModel& model = *other->model(); model.hasCaseFile()) {
            return OpenCase{model.caseFile(), model.context()};
        }
    }
    return std::nullopt;
}

void MethodsPage::showBudget() {
    showVerdict();
    budgetTable_->setResults(budget_->results());
    const bool hasResults = budgetTable_->rowCount() > 0;
    budgetTable_->setVisible(hasResults);
    const CaseFile* file = hasResults ? &budget_->open()->file : nullptr;
    const QString scene = file != nullptr ? SceneModel::titleOf(file->scene) : QString();
    showOrHide(
        caseTitle_,
        file == nullptr || file->title.empty()
            ? scene
            : tr("%1: %2").arg(scene, SceneModel::titleText(QString::fromStdString(file->title))));
    const QStringList leftOut = budget_->leftOut();
    showOrHide(leftOut_, !hasResults ? QString()
                                     : tr("The model leaves out:") + QStringLiteral("\n• ") +
                                           leftOut.join(QStringLiteral("\n• ")));
}

QWidget* MethodsPage::buildResults() {
    auto* charts = new QWidget(this);
    QVBoxLayout* column = columnIn(charts);
    plots_ = new MethodPlots(model_, charts);
    column->addWidget(plots_, 3);
    auto* panel = new Panel(charts);
    QVBoxLayout* inside = columnIn(panel, Theme::gap, {1, 1, 1, Theme::gap});
    table_ = new ResultTable(tr("Methods as measured"), panel);
    table_->setObjectName(QStringLiteral("methods_table"));
    // Further rows never cost a chart; where the page scrolls, the table does not.
    const auto chooseRows = [this](bool folded) { table_->setShownRows(folded ? 0 : 6); };
    connect(plots_, &FoldingRow::foldChanged, this, chooseRows);
    chooseRows(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setColumns(
        {{tr("Method"), tr("Methods for the quantity; the method in use is marked")},
         {tr("Setting"), tr("Steps, terms or samples of the method")},
         {tr("Time, ns"), tr("Median of repeated runs; the tips of the cells have the quartiles")},
         {tr("Error"), tr("Maximum error against 50 digits, in the measure of the quantity")},
         {tr("Order"),
          tr("Order of convergence: the error falls as this power of the number of steps")}});
    const auto showDetails = [this](bool shown) {
        table_->setColumnHidden(Time, !shown);
        table_->setColumnHidden(Order, !shown);
    };
    showDetails(false);
    connect(table_, &QTableWidget::currentCellChanged, this, &MethodsPage::chooseRow);
    inside->addWidget(table_, 1);
    auto* below = new QHBoxLayout;
    below->setContentsMargins(Theme::space, 0, Theme::space, 0);
    limits_ = captionLabel({}, panel);
    limits_->setObjectName(QStringLiteral("limits"));
    below->addWidget(limits_, 1);
    details_ = new QToolButton(panel);
    details_->setObjectName(QStringLiteral("details"));
    details_->setText(tr("&Details"));
    details_->setCheckable(true);
    details_->setToolTip(tr("Show times, orders of convergence and how both are measured"));
    connect(details_, &QToolButton::toggled, this, &MethodsPage::showWords);
    connect(details_, &QToolButton::toggled, table_, showDetails);
    below->addWidget(details_, 0, Qt::AlignTop);
    inside->addLayout(below);
    column->addWidget(panel, 2);
    return charts;
}

void MethodsPage::showKernel() {
    kernels_->setCurrentIndex(static_cast<int>(model_->kernelIndex()));
    const QSignalBlocker quiet(sweeps_);
    sweeps_->clear();
    for (const methods::SweepInfo& sweep : model_->kernel().sweeps) {
        sweeps_->addItem(shownText(sweep.title));
        sweeps_->setItemData(sweeps_->count() - 1, shownText(sweep.title), Qt::ToolTipRole);
    }
    showSweep();
    showWords();
}

void MethodsPage::showSweep() {
    const methods::SweepInfo& sweep = model_->sweep();
    sweeps_->setCurrentIndex(static_cast<int>(model_->sweepIndex()));
    delete value_;
    // A thousandth of the whole, in round numbers.
    const double span = sweep.to - sweep.from;
    const int decimals = 2 - static_cast<int>(std::floor(std::log10(span)));
    SliderScale scale{sweep.from, sweep.to, std::pow(10.0, -decimals), 0.05 * span,
                      std::max(0, decimals)};
    if (sweep.logarithmic()) {
        scale.decimals = -1;
        scale.stepsPerDecade = 100;
        scale.digits = 3;
    }
    value_ = new ValueSlider(tr("&Value measured at"), scale, unitText(sweep.unit.name), this);
    value_->setHint(shownText(sweep.title));
    value_->slider()->setObjectName(QStringLiteral("value_slider"));
    value_->box()->setObjectName(QStringLiteral("value"));
    value_->setModel(model_);
    connect(value_, &ValueSlider::valueEdited, model_, &MethodsModel::setValue);
    valuePlace_->addWidget(value_);
    setTabOrder(sweeps_, value_->slider());
    setTabOrder(value_->slider(), value_->box());
    showValue();
}

void MethodsPage::showValue() {
    value_->setValue(model_->value());
}

void MethodsPage::showWords() {
    const Kernel& kernel = model_->kernel();
    const methods::MethodInfo& method = kernel.methods[kernel.chosen_method()];
    const methods::Setting& setting = method.settings[kernel.chosen_setting()];
    QString html;
    html += paragraph(tr("Quantity"), shownText(kernel.quantity));
    html += paragraph(
        tr("Method in use, and reason"),
        tr("%1, %2. Tolerance: %3, %4.")
                .arg(shownText(method.title), methodText(setting.label),
                     errorNumber(kernel.choice.tolerance), shownText(kernel.error_measure)) +
            QLatin1Char(' ') + shownText(kernel.choice.reason));
    if (details_->isChecked()) {
        html += paragraph(tr("Reference"),
                          tr("The same quantity in 50 digits, without the module's formulas: %1.")
                              .arg(shownText(kernel.reference)));
        html += paragraph(tr("One evaluation"), shownText(kernel.evaluation));
    }
    words_->setText(html);
}

void MethodsPage::showVerdict() {
    const std::optional<Verdict> verdict = isInFront(case_) ? budget_->verdict()
                                           : isInFront(validation_)
                                               ? validation_->viewModel()->verdict()
                                               : model_->verdictShown();
    verdict_->show(verdict.value_or(
        Verdict{Severity::note, {Text::tr("Measuring the methods on this machine.")}}));
}

void MethodsPage::showTable() {
    showVerdict();
    const MethodMeasurement* shown = model_->shown();
    if (shown == nullptr) {
        return;
    }
    const Kernel& kernel = shown->kernel();
    const methods::KernelReport& report = shown->report;
    ResultRows rows;
    for (const MethodRow& row : report.rows) {
        rows << cells(report, row);
    }
    const QSignalBlocker quiet(table_);
    table_->setRows(rows);
    const Theme& theme = Theme::instance();
    for (int i = 0; i < rows.size(); ++i) {
        const MethodRow& row = report.rows[static_cast<std::size_t>(i)];
        for (int column = 0; column < table_->columnCount(); ++column) {
            QTableWidgetItem* cell = table_->item(i, column);
            QFont bold = table_->font();
            bold.setBold(true);
            cell->setData(Qt::FontRole, row.in_use && column == Method ? bold : QVariant());
            cell->setForeground(theme.text());
            if (const QString limits = shownText(kernel.methods[row.method].limits);
                !limits.isEmpty()) {
                cell->setToolTip(limits);
            }
        }
        table_->item(i, Time)->setToolTip(
            tr("Half of the runs from %1 to %2")
                .arg(timeText(row.timing.low), timeText(row.timing.high)));
        table_->item(i, Error)->setForeground(row.holds ? theme.good() : theme.error());
        table_->item(i, Error)->setToolTip(
            row.result.rejected() ? tr("rejected: %1").arg(methodText(row.result.rejection))
            : row.holds           ? tr("Within the tolerance")
                                  : tr("Beyond the tolerance"));
    }
    if (tableOf_ != &kernel) {
        tableOf_ = &kernel;
        const auto& all = report.rows;
        const auto used =
            std::find_if(all.begin(), all.end(), [](const MethodRow& row) { return row.in_use; });
        table_->setCurrentCell(static_cast<int>(used - all.begin()), Method);
    }
    table_->scrollTo(table_->currentIndex());
    chooseRow();
    showRunning();
}

void MethodsPage::chooseRow() {
    const MethodMeasurement* shown = model_->shown();
    const int row = table_->currentRow();
    if (shown == nullptr || row < 0 || &shown->kernel() != &model_->kernel() ||
        static_cast<std::size_t>(row) >= shown->report.rows.size()) {
        return;
    }
    const methods::KernelReport& report = shown->report;
    const std::size_t chosen = report.rows[static_cast<std::size_t>(row)].method;
    model_->setShownMethod(chosen);
    const methods::MethodInfo& method = shown->kernel().methods[chosen];
    QString text =
        tr("%1: %2.").arg(capitalised(shownText(method.title)), shownText(method.limits));
    for (const MethodRow& other : report.rows) {
        if (other.method == chosen && !other.fails.empty()) {
            text += QLatin1Char(' ') +
                    tr("Beyond the tolerance: %1.")
                        .arg(methodText(methods::failing_summary(shown->kernel(), other)));
        }
    }
    limits_->setText(text);
}

void MethodsPage::showRunning() {
    // A pale table is an old one.
    table_->setEnabled(!model_->isStale());
}

bool MethodsPage::isInFront(const QWidget* view) const {
    const QWidget* front = tabs_->currentWidget();
    return front == view || front->isAncestorOf(view);
}

QString MethodsPage::resultsAsText() const {
    return isInFront(case_)         ? budgetTable_->asText()
           : isInFront(validation_) ? validation_->asText()
                                    : table_->asText();
}

QString MethodsPage::resultsAsCsv() const {
    if (isInFront(case_)) {
        return budgetTable_->asCsv();
    }
    if (isInFront(validation_)) {
        return validation_->asCsv();
    }
    const MethodMeasurement* shown = model_->shown();
    return shown == nullptr
               ? QString()
               : QString::fromStdString(methods::write_csv(std::vector{shown->report}));
}

void MethodsPage::setActive(bool active) {
    active_ = active;
    updateActive();
}

void MethodsPage::updateActive() {
    if (active_) {
        // An empty tab answers nothing; with a case open it is the first question.
        const bool hasCase = caseLastInFront().has_value();
        if (tabs_->isTabVisible(0) != hasCase) {
            tabs_->setTabVisible(0, hasCase);
            tabs_->setCurrentIndex(hasCase ? 0 : 1);
        }
    }
    // Nothing is measured behind another tab: it would only disturb.
    model_->setActive(active_ && isInFront(charts_));
    if (active_ && isInFront(case_)) {
        budget_->load(caseLastInFront());
    }
    if (isInFront(validation_)) {
        validation_->load();
    }
}

}  // namespace ravnoves
