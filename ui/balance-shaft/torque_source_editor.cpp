#include "balance-shaft/torque_source_editor.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/import_dialog.h"
#include "balance-shaft/inertia_check.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/import_model.h"
#include "balance-shaft/model/torque_table_model.h"
#include "case-file/input_error.h"
#include "pictures/file_dialogs.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/write_file.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "widgets/layouts.h"

namespace ravnoves {

using balance_shaft::GasCycle;
using balance_shaft::Input;
using balance_shaft::TorqueSource;
namespace field = balance_shaft::field;

namespace {

using Kind = TorqueSource::Kind;

enum Page { TablePage, PressurePage };
constexpr std::array pages{Kind::table, Kind::pressure, Kind::cycle};

/// Whether cells go from the beginning of a cycle to its end: meant for a table of their own, they
/// are not put among the rows of another.
bool isCycle(const std::vector<QStringList>& cells) {
    std::vector<double> angles;
    for (const QStringList& row : cells) {
        const auto angle = row.size() > 1 ? readFormNumber(row[0]) : std::nullopt;
        if (angle) {
            angles.push_back(*angle);
        }
    }
    constexpr std::size_t fewest = 3;
    constexpr double turn = 360.0;  // degrees
    return angles.size() >= fewest && angles.front() == 0.0 &&
           (angles.back() == turn || angles.back() == 2.0 * turn);
}

}  // namespace

TorqueTableEditor::TorqueTableEditor(BalanceShaftModel* model, QWidget* parent)
    : TableEditor(new TorqueTableModel(model), tr("Torque table"), tr("Insert a row below"),
                  tr("Delete the selected rows"), parent),
      model_(model),
      table_(static_cast<TorqueTableModel*>(table())) {
    table_->setParent(this);
    caption()->setText(
        tr("Engine torque over one cycle, 720° (two-stroke 360°). Paste a whole table from a "
           "spreadsheet, or type."));
    addTool(QStringLiteral("job-new"), tr("Paste (Ctrl+V)"), [this] { tryPaste(); });
    addTool(QStringLiteral("import"), tr("Import CSV file…"), [this] { importWithDialog(); });
    addTool(QStringLiteral("export"), tr("Export CSV file…"), [this] {
        saveFile(this, tr("Export torque table"), QStringLiteral("torque.csv"), {csvFormat()},
                 [this](const QString& path) {
                     return writeFile(path, [this] {
                         return balance_shaft::write_torque_table(model_->input().torque.table);
                     });
                 });
    });
    connect(model_, &SceneModel::changed, this, [this] {
        if (trouble().isEmpty()) {
            say({}, false);  // what was said was of the table before
        }
    });
    connect(table_, &EditableTable::troubleChanged, this, [this](const QString& trouble) {
        const QString text = trouble.isEmpty()
                                 ? table_->strokesNote()
                                 : trouble + QLatin1Char('\n') +
                                       tr("The previous value is used until this is corrected.");
        say(text, !text.isEmpty());
    });
}

void TorqueTableEditor::importWithDialog() {
    const QString path = askOpenPath(this, tr("Import torque table"), {}, tablesFilter());
    if (!path.isEmpty()) {
        importFile(path);
    }
}

void TorqueTableEditor::importFile(const QString& path) {
    ImportModel file(balance_shaft::Measured::torque, slider_crank(model_->input()),
                     model_->input().strokes);
    file.open(path);
    ImportDialog dialog(&file, tr("Import torque table"), this);
    if (dialog.exec() == QDialog::Accepted) {
        table_->replaceBy(file.cycle()->table);
        say(tr("Read %1.").arg(messageText(file.cycle()->describe())), false);
    }
}

void TorqueTableEditor::paste() {
    const QString text = QApplication::clipboard()->text();
    try {
        const QString what = tr("Read %1.").arg(table_->replaceByText(text.toStdString()));
        const QString& note = table_->strokesNote();
        say(note.isEmpty() ? what : what + QLatin1Char(' ') + note, !note.isEmpty());
    } catch (const InputError& error) {
        const auto cells = readTextTable(text);
        const auto rows = static_cast<int>(cells.size());
        if (!isCycle(cells) && rows < table_->rowCount() &&
            (rows == 0 || view()->currentIndex().isValid())) {
            TableEditor::paste();
        } else {
            say(tr("Not pasted: %1").arg(errorText(error)), true);
        }
    }
}

TorqueSourceEditor::TorqueSourceEditor(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this, 0, tabMargins);
    auto* source = new FormSection({}, this);
    source->setContentsMargins(Theme::margin, 0, Theme::margin, 0);
    choice_ = new QComboBox(source);
    choice_->addItems({tr("table"), tr("pressure trace"), tr("computed cycle")});
    choice_->setObjectName(QStringLiteral("torque_source"));
    source->addWidget(tr("Tor&que from"), choice_, {},
                      tr("A table is used as entered. A pressure trace or computed cycle gives gas "
                         "torque plus inertia torque of the masses and speed."));
    column->addWidget(source);
    trouble_ = new TroubleLine(this);
    trouble_->setContentsMargins(Theme::margin, 0, Theme::margin, 0);
    column->addWidget(trouble_);
    column->addWidget(buildNoTable());
    noTrace_ = new TroubleLine(this);
    noTrace_->setContentsMargins(Theme::margin, 0, Theme::margin, Theme::gap);
    noTrace_->setObjectName(QStringLiteral("no_trace"));
    column->addWidget(noTrace_);
    forms_ = new QStackedWidget(this);
    table_ = new TorqueTableEditor(model_, forms_);
    forms_->addWidget(table_);
    forms_->addWidget(buildPressure());
    forms_->addWidget(buildCycle());
    column->addWidget(forms_, 1);
    // Below: what it says changes with each cell, and the rows must not move under the pointer.
    column->addWidget(buildCheck());

    connect(choice_, &QComboBox::activated, this, [this](int page) {
        awaited_.reset();
        if (isEmpty(page)) {
            awaited_ = page;  // nothing to solve until there are numbers
            showForm(page);
            return;
        }
        trouble_->say(model_->setTorqueKind(pages.at(static_cast<std::size_t>(page))));
        showInput();
    });
    connect(model_, &SceneModel::changed, this, [this] {
        trouble_->say({});
        showInput();
    });
    showInput();
}

QWidget* TorqueSourceEditor::buildNoTable() {
    noTable_ = new QWidget(this);
    QVBoxLayout* column =
        columnIn(noTable_, Theme::gap, {Theme::margin, 0, Theme::margin, Theme::gap});
    column->addWidget(captionLabel(tr("No table yet, so the computed torque is used: paste a "
                                      "table, import a CSV file, or use this torque as table."),
                                   noTable_));
    auto* take = new QPushButton(tr("Use as table"), noTable_);
    take->setObjectName(QStringLiteral("take_computed_torque"));
    take->setToolTip(
        tr("Make a table of the computed torque, a row per step. The table does not "
           "follow speed and masses."));
    connect(take, &QPushButton::clicked, this, [this] {
        trouble_->say(model_->tabulateTorque());
        showInput();
    });
    column->addWidget(take);
    return noTable_;
}

QWidget* TorqueSourceEditor::buildCheck() {
    auto* check = new QWidget(this);
    QVBoxLayout* column =
        columnIn(check, Theme::gap, {Theme::margin, 0, Theme::margin, Theme::gap});
    QLabel* text = copyableCaption("", check);
    column->addWidget(text);
    auto* remedies = new QWidget(check);
    QHBoxLayout* row = rowIn(remedies, Theme::gap);
    auto* useSpeed = new QPushButton(tr("Use its speed"), remedies);
    useSpeed->setObjectName(QStringLiteral("use_matching_speed"));
    useSpeed->setToolTip(
        tr("Set the speed at which the masses give the inertia torque of the table."));
    row->addWidget(useSpeed);
    row->addWidget(rebuildButton(model_, QStringLiteral("rebuild_torque"), remedies));
    column->addWidget(remedies);
    connect(useSpeed, &QPushButton::clicked, this, [this] {
        model_->edit(tr("Use the torque's speed"), [this](Input& input) {
            input.angular_speed = model_->result().inertia_check.matching_speed;
        });
    });
    const auto show = [=, this] {
        const balance_shaft::InertiaCheck& found = model_->result().inertia_check;
        const bool isWrong = !found.warning.empty();
        check->setVisible(!model_->input().torque.is_computed());
        remedies->setVisible(isWrong);
        useSpeed->setVisible(!found.is_of_other_rod);  // no speed makes another rod of it
        colourText(text, isWrong ? &Theme::warning : &Theme::mutedText);
        text->setText(messageText(found.text));
    };
    connect(model_, &SceneModel::changed, check, show);
    show();
    return check;
}

QPushButton* TorqueSourceEditor::rebuildButton(BalanceShaftModel* model, const QString& name,
                                               QWidget* parent) {
    auto* rebuild = new QPushButton(tr("Rebuild torque"), parent);
    rebuild->setObjectName(name);
    rebuild->setToolTip(
        tr("Replace the fitted inertia torque of the table by the inertia torque of masses and "
           "speed."));
    connect(rebuild, &QPushButton::clicked, model, &BalanceShaftModel::rebuildTorque);
    return rebuild;
}

QWidget* TorqueSourceEditor::buildPressure() {
    auto* form = new Form(model_);
    FormSection* file = form->section({});
    file->addWide(
        captionLabel(tr("Measured cylinder pressure over one or more cycles; crank angles start at "
                        "the dead centre before intake (two-stroke: at firing)."),
                     form));
    auto* import = new QPushButton(themedIcon(QStringLiteral("import")), tr("Impo&rt file…"), form);
    file->addWide(import);
    trace_ = captionLabel({}, form);
    trace_->setObjectName(QStringLiteral("trace_file"));
    file->addWide(trace_);
    form->number("/torque/pressure/crank_angle_shift_deg");
    form->section(tr("Cylinder"));
    form->number("/torque/pressure/crankcase_pressure_bar");
    form->column()->addStretch();
    connect(import, &QPushButton::clicked, this, [this] {
        const QString path = askOpenPath(this, tr("Import pressure trace"), {}, tablesFilter());
        if (!path.isEmpty()) {
            importTrace(path);
        }
    });
    return scrolled(form, this);
}

QWidget* TorqueSourceEditor::buildCycle() {
    auto* form = new Form(model_);
    const auto addNumbers = [form](std::initializer_list<const char*> places) {
        for (const char* place : places) {
            form->number(place);
        }
    };
    form->section({})->addWide(
        captionLabel(tr("A plain cycle: constant pressures for gas exchange, polytropic "
                        "compression, one Wiebe heat release, polytropic expansion."),
                     form));
    form->section(tr("Cylinder"));
    form->number("/torque/cycle/crankcase_pressure_bar");
    form->section(tr("Gas exchange and compression"));
    addNumbers({"/torque/cycle/compression_ratio", "/torque/cycle/intake_pressure_bar",
                "/torque/cycle/exhaust_pressure_bar", "/torque/cycle/polytropic_compression",
                "/torque/cycle/polytropic_expansion"});
    NumberField* ports = form->number(
        field::ports_open, [this] { return model_->input().torque.cycle.ports_open; },
        [this](std::optional<double> value) {
            model_->edit(fieldName(field::ports_open),
                         [&](Input& input) { input.torque.cycle.ports_open = *value; });
        });
    form->follow([this, ports] { ports->setEnabled(model_->input().strokes == 2); });
    form->section(tr("Combustion"));
    for (const auto& [load, value] :
         {std::pair(&field::imep, &GasCycle::imep), std::pair(&field::heat, &GasCycle::heat)}) {
        NumberField* number = form->number(
            *load, [this, value = value] { return model_->input().torque.cycle.*value; },
            [this, value = value](std::optional<double> typed) {
                if (typed) {  // one of the two always holds
                    model_->setLoad(value, *typed);
                }
            });
        number->setOptional(true);
        number->setDigits(6);
        showAssumed(form, number, [this, load = load]() -> std::optional<double> {
            const auto& cycle = model_->result().indicated;
            return !cycle                 ? std::nullopt
                   : load == &field::heat ? cycle->heat
                                          : std::optional(cycle->imep / units::bar);
        });
    }
    addNumbers({"/torque/cycle/combustion_start_deg", "/torque/cycle/combustion_duration_deg",
                "/torque/cycle/wiebe_m"});
    form->column()->addStretch();
    return scrolled(form, this);
}

void TorqueSourceEditor::importTrace(const QString& path) {
    ImportModel file(balance_shaft::Measured::pressure, slider_crank(model_->input()),
                     model_->input().strokes);
    file.open(path);
    ImportDialog dialog(&file, tr("Import pressure trace"), this);
    if (dialog.exec() == QDialog::Accepted) {
        trouble_->say(
            model_->edit(tr("Pressure trace"), [&](Input& input) { file.putTraceInto(input); }));
    }
}

void TorqueSourceEditor::showForm(int page) {
    choice_->setCurrentIndex(page);
    forms_->setCurrentIndex(page);
    const TorqueSource& torque = model_->input().torque;
    noTable_->setVisible(page == TablePage && torque.is_computed());
    const bool isWithoutTrace = page == PressurePage && torque.kind != Kind::pressure;
    noTrace_->say(!isWithoutTrace        ? QString()
                  : torque.is_computed() ? tr("No pressure trace yet; the computed cycle is used.")
                                         : tr("No pressure trace yet; the table is used."));
    const QString file = QString::fromStdString(torque.trace_file.name);
    showOrHide(trace_, file.isEmpty() ? QString()
                       : torque.trace.pressure.empty()
                           ? tr("%1 cannot be read; import it again from its new place.").arg(file)
                           : tr("Pressure trace: %1.").arg(QFileInfo(file).fileName()));
    trace_->setToolTip(file);
}

bool TorqueSourceEditor::isEmpty(int page) const {
    const TorqueSource& torque = model_->input().torque;
    return page == PressurePage ? torque.trace.pressure.empty()
                                : page == TablePage && torque.table.size() == 0;
}

void TorqueSourceEditor::showInput() {
    const auto* of = std::find(pages.begin(), pages.end(), model_->input().torque.kind);
    const int page = of == pages.end() ? TablePage : static_cast<int>(of - pages.begin());
    if (std::exchange(given_, page) != page) {
        awaited_.reset();
    }
    showForm(awaited_.value_or(page));
}

}  // namespace ravnoves
