#include "balance-shaft/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
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
#include "widgets/form_section.h"
#include "widgets/job_progress.h"
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

template <typename List, typename Value>
int placeIn(const List& list, const std::optional<Value>& value) {
    const auto found = std::find(list.begin(), list.end(), value);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
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
    auto* progress = new JobProgress(model_->job(), tr("Reading the file"), this);
    progress->setFixedHeight(Theme::space);
    column->addWidget(progress);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    import_ = buttons->addButton(tr("I&mport"), QDialogButtonBox::AcceptRole);
    import_->setObjectName(QStringLiteral("import_accept"));
    import_->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::rejected, model_->job(), &BackgroundJob::cancel);
    connect(shift_, &QCheckBox::clicked, model_, &ImportModel::setShifted);
    connect(model_, &ImportModel::changed, this, &ImportDialog::showFile);
    showFile();
    findChild<QComboBox*>()->setFocus();
    resizeWithText(this, 760, 620);
}

QComboBox* ImportDialog::addChoice(FormSection* section, const char* name, const QString& label,
                                   const QString& hint, const std::function<QStringList()>& words,
                                   const std::function<int()>& read,
                                   const std::function<void(int)>& decide) {
    auto* box = new QComboBox(section);
    box->setObjectName(QLatin1String(name));
    box->setPlaceholderText(tr("from the file"));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(18);
    section->addWidget(label, box, {}, hint);
    connect(box, &QComboBox::activated, this, decide);
    settings_.push_back([=] {
        box->clear();
        box->addItems(words());
        box->setCurrentIndex(read());
    });
    return box;
}

QStringList ImportDialog::columns() const {
    QStringList columns;
    for (int column = 0; column < model_->columns(); ++column) {
        const QString heading = model_->heading(column);
        columns << (heading.isEmpty()
                        ? tr("column %1").arg(column + 1)
                        : QString::number(column + 1) + QStringLiteral(": ") + heading);
    }
    return columns;
}

QWidget* ImportDialog::buildSettings() {
    auto* settings = new QWidget(this);
    QHBoxLayout* row = rowIn(settings, Theme::margin);
    auto* layout = new FormSection({}, settings);
    auto* meaning = new FormSection({}, settings);
    row->addWidget(layout, 1, Qt::AlignTop);
    row->addWidget(meaning, 1, Qt::AlignTop);
    const auto fixed = [](const QStringList& words) { return [words] { return words; }; };
    const auto decideBy = [this](auto change) {
        return [this, change](int place) {
            TableReading decided = model_->decided();
            change(decided, place);
            model_->decide(decided);
        };
    };
    addChoice(
        layout, "import_separator", tr("&Separator"), tr("Character between the columns."),
        fixed({tr("semicolon"), tr("comma"), tr("tab"), tr("blanks")}),
        [this] { return placeIn(separatorsInOrder, model_->reading().layout.separator); },
        decideBy([](TableReading& decided, int place) {
            decided = {};  // all else was of other columns
            decided.layout.separator = separatorsInOrder.at(static_cast<std::size_t>(place));
        }));
    addChoice(
        layout, "import_decimal", tr("&Decimal sign"), tr("Decimal sign of the numbers."),
        fixed({tr("point"), tr("comma")}), [this] { return placeOf(model_->decimalComma()); },
        decideBy(
            [](TableReading& decided, int place) { decided.layout.decimal_comma = place == 1; }))
        ->setPlaceholderText(tr("choose"));  // where the numbers leave it open
    auto* header = new QSpinBox(layout);
    header->setObjectName(QStringLiteral("import_header_lines"));
    header->setRange(0, 999);
    layout->addWidget(tr("&Header lines"), header, {},
                      tr("Lines above the first row, without empty lines and comments (#)."));
    connect(header, &QSpinBox::valueChanged, this, decideBy([](TableReading& decided, int lines) {
                decided.layout.header_lines = static_cast<std::size_t>(lines);
            }));
    settings_.push_back([this, header] {
        const QSignalBlocker blocker(header);
        header->setValue(model_->headerLines());
    });
    QComboBox* cycle = addChoice(
        layout, "import_cycle", tr("C&ycle"),
        tr("Length of a cycle. Several cycles in the file are averaged."),
        fixed({tr("360° (two-stroke)"), tr("720° (four-stroke)")}),
        [this] {
            return model_->asksForCycle() ? -1 : model_->reading().strokes.value_or(0) / 2 - 1;
        },
        decideBy([](TableReading& decided, int place) { decided.strokes = 2 + 2 * place; }));
    settings_.push_back([this, cycle] {
        cycle->setPlaceholderText(model_->asksForCycle() ? tr("choose") : tr("from the file"));
    });
    addChoice(
        meaning, "import_angle", tr("Crank &angle"),
        tr("Column of the crank angle. Without one, the rows are equal steps over one cycle."),
        [this] { return QStringList{tr("none: equal steps")} + columns(); },
        [this] { return model_->column(0).value_or(-1) + 1; },
        [this](int place) {
            model_->decideColumn(0, place > 0 ? std::optional(place - 1) : std::nullopt);
        });
    addChoice(
        meaning, "import_angle_unit", tr("Angles i&n"), tr("Unit of the crank angle."),
        fixed({tr("degrees"), tr("radians")}),
        [this] { return placeOf(model_->reading().in_radians); },
        decideBy([](TableReading& decided, int place) { decided.in_radians = place == 1; }));
    const bool isPressure = model_->what() == Measured::pressure;
    addChoice(
        meaning, "import_value", isPressure ? tr("&Pressure") : tr("&Torque"),
        isPressure ? tr("Column of the cylinder pressure.") : tr("Column of the engine torque."),
        [this] { return columns(); }, [this] { return model_->column(1).value_or(-1); },
        [this](int place) { model_->decideColumn(1, place); });
    const std::vector<Unit> units = units_of(model_->what());
    QStringList names;
    for (const Unit& unit : units) {
        names << unitText(unit.name);
    }
    addChoice(
        meaning, "import_unit", tr("&Unit"),
        isPressure ? tr("Unit of the pressure.") : tr("Unit of the torque."), fixed(names),
        [this, units] { return placeIn(units, model_->reading().unit); },
        decideBy([units](TableReading& decided, int place) {
            decided.unit = units.at(static_cast<std::size_t>(place));
        }));
    if (isPressure) {
        addChoice(
            meaning, "import_gauge", tr("Pr&essure is"),
            tr("Gauge pressure is relative to the atmosphere: 1.01325 bar is added."),
            fixed({tr("absolute"), tr("gauge")}),
            [this] { return placeOf(model_->reading().gauge); },
            decideBy([](TableReading& decided, int place) { decided.gauge = place == 1; }));
    }
    return settings;
}

void ImportDialog::showFile() {
    import_->setEnabled(model_->isReady());
    if (model_->job()->isRunning()) {
        return;  // what is shown is of the settings before
    }
    showLines();
    for (const auto& show : settings_) {
        show();
    }
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
