#include "balance-shaft/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableWidget>
#include <algorithm>
#include <array>

#include "balance-shaft/model/import_model.h"
#include "model/background_job.h"
#include "pictures/file_dialogs.h"
#include "text/number_text.h"
#include "text/plain_title.h"
#include "theme/theme.h"
#include "widgets/dialog_size.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"

namespace ravnoves {

using balance_shaft::Measured;
using balance_shaft::TableReading;

namespace {

constexpr std::array separatorsInOrder{';', ',', '\t', ' '};

/// Of what a combo box lists from its first entry.
int placeOf(const std::optional<bool>& choice) {
    return choice ? static_cast<int>(*choice) : -1;
}

}  // namespace

ImportDialog::ImportDialog(ImportModel* model, const QString& title, QWidget* parent)
    : QDialog(parent), model_(model) {
    setWindowTitle(title + QStringLiteral(" – ") + plainTitle(QFileInfo(model->path()).fileName()));
    QVBoxLayout* column =
        columnIn(this, Theme::space, {Theme::margin, Theme::margin, Theme::margin, Theme::margin});
    preview_ = new QTableWidget(this);
    preview_->setObjectName(QStringLiteral("import_preview"));
    preview_->setAccessibleName(tr("First lines of the file"));
    preview_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    preview_->setSelectionMode(QAbstractItemView::NoSelection);
    preview_->setTabKeyNavigation(false);
    preview_->setWordWrap(false);
    column->addWidget(preview_, 1);
    column->addWidget(buildSettings());
    understood_ = copyableCaption("import_understood", this);
    doubts_ = copyableCaption("import_doubts", this);
    colourText(doubts_, &Theme::warning);
    for (QLabel* label : {understood_, doubts_}) {  // what is below must not move as they change
        label->setMinimumHeight(2 * label->fontMetrics().lineSpacing());
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        column->addWidget(label);
    }
    shift_ = new QCheckBox(this);
    shift_->setObjectName(QStringLiteral("import_shift"));
    explain(shift_, tr("Add this shift to the crank angles of the trace."));
    column->addWidget(shift_);
    progress_ = new QProgressBar(this);
    progress_->setRange(0, 100);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Reading the file"));
    QSizePolicy keepsItsPlace = progress_->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(keepsItsPlace);
    progress_->setFixedHeight(Theme::space);
    column->addWidget(progress_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    import_ = buttons->addButton(tr("I&mport"), QDialogButtonBox::AcceptRole);
    import_->setObjectName(QStringLiteral("import_accept"));
    import_->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::rejected, model_->job(), &BackgroundJob::cancel);
    connect(model_->job(), &BackgroundJob::progress, progress_,
            [this](double part) { progress_->setValue(static_cast<int>(100.0 * part)); });
    connect(shift_, &QCheckBox::clicked, model_, &ImportModel::setShifted);
    connectSettings();
    connect(model_, &ImportModel::changed, this, &ImportDialog::showFile);
    showFile();
    separator_->setFocus();
    resizeWithText(this, 760, 620);
}

QComboBox* ImportDialog::addChoice(FormSection* section, const char* name, const QString& label,
                                   const QString& hint, const QStringList& choices) {
    auto* box = new QComboBox(section);
    box->setObjectName(QLatin1String(name));
    box->addItems(choices);
    box->setPlaceholderText(tr("from the file"));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(18);
    section->addWidget(label, box, {}, hint);
    return box;
}

QWidget* ImportDialog::buildSettings() {
    auto* settings = new QWidget(this);
    QHBoxLayout* row = rowIn(settings, Theme::margin);
    auto* layout = new FormSection({}, settings);
    auto* meaning = new FormSection({}, settings);
    row->addWidget(layout, 1, Qt::AlignTop);
    row->addWidget(meaning, 1, Qt::AlignTop);
    separator_ = addChoice(layout, "import_separator", tr("&Separator"),
                           tr("Character between the columns."),
                           {tr("semicolon"), tr("comma"), tr("tab"), tr("blanks")});
    decimal_ = addChoice(layout, "import_decimal", tr("&Decimal sign"),
                         tr("Decimal sign of the numbers."), {tr("point"), tr("comma")});
    decimal_->setPlaceholderText(tr("choose"));  // where the numbers leave it open
    header_ = new QSpinBox(layout);
    header_->setObjectName(QStringLiteral("import_header_lines"));
    header_->setRange(0, 999);
    layout->addWidget(tr("&Header lines"), header_, {},
                      tr("Lines above the first row, without empty lines and comments (#)."));
    cycle_ = addChoice(layout, "import_cycle", tr("C&ycle"),
                       tr("Length of a cycle. Several cycles in the file are averaged."),
                       {tr("360° (two-stroke)"), tr("720° (four-stroke)")});
    angle_ = addChoice(meaning, "import_angle", tr("Crank &angle"),
                       tr("Column of the crank angle. Without one, the rows are equal steps over "
                          "one cycle."),
                       {});
    angleUnit_ = addChoice(meaning, "import_angle_unit", tr("Angles i&n"),
                           tr("Unit of the crank angle."), {tr("degrees"), tr("radians")});
    const bool isPressure = model_->what() == Measured::pressure;
    value_ = addChoice(
        meaning, "import_value", isPressure ? tr("&Pressure") : tr("&Torque"),
        isPressure ? tr("Column of the cylinder pressure.") : tr("Column of the engine torque."),
        {});
    QStringList units;
    for (const Unit& unit : units_of(model_->what())) {
        units << unitText(unit.name);
    }
    unit_ = addChoice(meaning, "import_unit", tr("&Unit"),
                      isPressure ? tr("Unit of the pressure.") : tr("Unit of the torque."), units);
    if (isPressure) {
        gauge_ =
            addChoice(meaning, "import_gauge", tr("Pressure &is"),
                      tr("Gauge pressure is relative to the atmosphere: 1.01325 bar is added."),
                      {tr("absolute"), tr("gauge")});
    }
    return settings;
}

void ImportDialog::connectSettings() {
    const auto decideBy = [this](QComboBox* box, auto change) {
        connect(box, &QComboBox::activated, this, [this, change](int place) {
            TableReading decided = model_->decided();
            change(decided, place);
            model_->decide(decided);
        });
    };
    decideBy(separator_, [](TableReading& decided, int place) {
        decided = {};  // all else was of other columns
        decided.layout.separator = separatorsInOrder.at(static_cast<std::size_t>(place));
    });
    decideBy(decimal_,
             [](TableReading& decided, int place) { decided.layout.decimal_comma = place == 1; });
    connect(header_, &QSpinBox::valueChanged, this, [this](int lines) {
        TableReading decided = model_->decided();
        decided.layout.header_lines = static_cast<std::size_t>(lines);
        model_->decide(decided);
    });
    decideBy(cycle_, [](TableReading& decided, int place) { decided.strokes = 2 + 2 * place; });
    decideBy(angleUnit_, [](TableReading& decided, int place) { decided.in_radians = place == 1; });
    decideBy(unit_, [what = model_->what()](TableReading& decided, int place) {
        decided.unit = units_of(what).at(static_cast<std::size_t>(place));
    });
    if (gauge_ != nullptr) {
        decideBy(gauge_, [](TableReading& decided, int place) { decided.gauge = place == 1; });
    }
    connect(angle_, &QComboBox::activated, this, [this](int place) {
        model_->decideColumn(0, place > 0 ? std::optional(place - 1) : std::nullopt);
    });
    connect(value_, &QComboBox::activated, this,
            [this](int place) { model_->decideColumn(1, place); });
}

void ImportDialog::showFile() {
    const bool isRunning = model_->job()->isRunning();
    progress_->setVisible(isRunning);
    import_->setEnabled(model_->isReady());
    if (isRunning) {
        return;  // what is shown is of the settings before
    }
    showLines();
    showSettings();
    const QString trouble = model_->troubleText();
    colourText(understood_, trouble.isEmpty() ? &Theme::text : &Theme::error);
    understood_->setText(trouble.isEmpty() ? model_->understoodText() : trouble);
    doubts_->setText(model_->doubtsText());
    shift_->setText(model_->deadCentreText());
    shift_->setVisible(!shift_->text().isEmpty());
    shift_->setChecked(model_->isShifted());
}

void ImportDialog::showLines() {
    const auto& lines = model_->lines();
    const int columns = model_->columns();
    const std::array marked{model_->column(0), model_->column(1)};
    const std::array marks{tr("crank angle"),
                           model_->what() == Measured::pressure ? tr("pressure") : tr("torque")};
    preview_->clear();
    preview_->setRowCount(static_cast<int>(lines.size()));
    preview_->setColumnCount(columns);
    const Theme& theme = Theme::instance();
    QColor tint = theme.accent();
    constexpr int faint = 50;  // of 255
    tint.setAlpha(faint);
    for (int column = 0; column < columns; ++column) {
        const auto mark = std::find(marked.begin(), marked.end(), std::optional(column));
        const bool isMarked = mark != marked.end();
        QString title = QString::number(column + 1);
        if (isMarked) {
            title += QLatin1Char('\n') + marks.at(static_cast<std::size_t>(mark - marked.begin()));
        }
        preview_->setHorizontalHeaderItem(column, new QTableWidgetItem(title));
        for (int row = 0; row < preview_->rowCount(); ++row) {
            const auto& line = lines[static_cast<std::size_t>(row)];
            const auto place = static_cast<std::size_t>(column);
            constexpr std::size_t longest = 60;  // bytes; a binary file may have any
            auto* cell = new QTableWidgetItem(
                place < line.size() ? QString::fromStdString(line[place].substr(0, longest))
                                    : QString());
            if (row < model_->headerLines()) {
                cell->setForeground(theme.mutedText());
            } else if (isMarked) {
                cell->setBackground(tint);
            }
            preview_->setItem(row, column, cell);
        }
    }
    preview_->resizeColumnsToContents();
    const int first = std::max(0, model_->headerLines() - 2);
    if (QTableWidgetItem* item = preview_->item(first, marked[1].value_or(0))) {
        preview_->scrollToItem(item, QAbstractItemView::PositionAtTop);
    }
}

void ImportDialog::showSettings() {
    const TableReading& reading = model_->reading();
    const auto separator = std::find(separatorsInOrder.begin(), separatorsInOrder.end(),
                                     reading.layout.separator.value_or('\0'));
    separator_->setCurrentIndex(separator == separatorsInOrder.end()
                                    ? -1
                                    : static_cast<int>(separator - separatorsInOrder.begin()));
    decimal_->setCurrentIndex(placeOf(model_->decimalComma()));
    {
        const QSignalBlocker blocker(header_);
        header_->setValue(model_->headerLines());
    }
    cycle_->setCurrentIndex(reading.strokes ? *reading.strokes / 2 - 1 : -1);
    angleUnit_->setCurrentIndex(placeOf(reading.in_radians));
    QStringList columns;
    for (int column = 0; column < model_->columns(); ++column) {
        const QString heading = model_->heading(column);
        columns << (heading.isEmpty()
                        ? tr("column %1").arg(column + 1)
                        : QString::number(column + 1) + QStringLiteral(": ") + heading);
    }
    value_->clear();
    value_->addItems(columns);
    value_->setCurrentIndex(model_->column(1).value_or(-1));
    columns.prepend(tr("none: equal steps"));
    angle_->clear();
    angle_->addItems(columns);
    angle_->setCurrentIndex(model_->column(0).value_or(-1) + 1);
    const std::vector<Unit> all = units_of(model_->what());
    const auto unit = std::find(all.begin(), all.end(), reading.unit.value_or(units::none));
    unit_->setCurrentIndex(unit == all.end() ? -1 : static_cast<int>(unit - all.begin()));
    if (gauge_ != nullptr) {
        gauge_->setCurrentIndex(placeOf(reading.gauge));
    }
}

void ImportDialog::accept() {
    if (!model_->isReady()) {
        return;
    }
    if (model_->needsOwnFile()) {
        const QFileInfo file(model_->path());
        const QString path =
            saveFile(this, tr("Save the cycle"),
                     file.dir().filePath(file.completeBaseName() + QStringLiteral("-cycle.csv")),
                     {csvFormat()}, std::bind_front(&ImportModel::writeOwnFile, model_));
        if (path.isEmpty()) {
            return;
        }
    }
    QDialog::accept();
}

}  // namespace ravnoves
