#include "balance-shaft/torque_source_editor.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <array>

#include "balance-shaft/inertia_check.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/table_format_text.h"
#include "balance-shaft/torque_table_editor.h"
#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/number_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"

namespace ravnoves {

using balance_shaft::GasCycle;
using balance_shaft::Input;
using balance_shaft::TorqueSource;
namespace field = balance_shaft::field;

namespace {

enum Page { TablePage = 0, PressurePage = 1, CyclePage = 2 };

int pageOf(TorqueSource::Kind kind) {
    switch (kind) {
        case TorqueSource::Kind::pressure:
            return PressurePage;
        case TorqueSource::Kind::cycle:
            return CyclePage;
        default:
            return TablePage;
    }
}

}  // namespace

TorqueSourceEditor::TorqueSourceEditor(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, Theme::space, 0, 0);
    column->setSpacing(0);
    auto* source = new FormSection({}, this);
    source->setContentsMargins(Theme::margin, 0, Theme::margin, 0);
    choice_ = new QComboBox(source);
    choice_->addItems({tr("table"), tr("pressure trace"), tr("computed cycle")});
    choice_->setObjectName(QStringLiteral("torque_source"));
    source->addWidget(tr("Tor&que from"), choice_, {},
                      tr("A table is taken as it is. From a pressure trace or a computed cycle the "
                         "torque is gas torque plus inertia torque of the masses and speed "
                         "entered, so it follows both."));
    column->addWidget(source);
    trouble_ = captionLabel({}, this);
    trouble_->setContentsMargins(Theme::margin, 0, Theme::margin, 0);
    trouble_->hide();
    column->addWidget(trouble_);
    column->addWidget(buildCheck());
    forms_ = new QStackedWidget(this);
    table_ = new TorqueTableEditor(model_, forms_);
    forms_->addWidget(table_);
    forms_->addWidget(buildPressure());
    forms_->addWidget(buildCycle());
    column->addWidget(forms_, 1);

    connect(choice_, &QComboBox::activated, this, [this](int page) {
        if (page == PressurePage && model_->input().torque.trace.pressure.empty()) {
            forms_->setCurrentIndex(page);  // nothing to solve until a file is read
            return;
        }
        const QString why =
            model_->setTorqueKind(page == TablePage      ? TorqueSource::Kind::table
                                  : page == PressurePage ? TorqueSource::Kind::pressure
                                                         : TorqueSource::Kind::cycle);
        trouble_->setText(why);
        trouble_->setVisible(!why.isEmpty());
        showInput();
    });
    connect(model_, &SceneModel::changed, this, &TorqueSourceEditor::showInput);
    showInput();
}

void TorqueSourceEditor::addCylinder(FormSection* form) {
    const auto add = [&](const QString& label, const FieldSpec& spec, const QString& hint,
                         auto access) {
        NumberField* numberField = form->addNumber(label, spec, hint);
        QString step = label;
        step.remove(QLatin1Char('&'));
        connect(numberField, &NumberField::valueEdited, this,
                [this, step, spec, access](std::optional<double> value) {
                    model_->edit(step, [&](Input& input) { access(input) = *value * spec.to_si; });
                });
        bindings_.push_back({numberField, [this, spec, access]() -> std::optional<double> {
                                 Input input = model_->input();
                                 return access(input) / spec.to_si;
                             }});
    };
    add(tr("&Bore"), field::bore, tr("Diameter of the cylinder. TMZ-650D: 95.5 mm."),
        [](Input& input) -> double& { return input.torque.cylinder.bore; });
    add(tr("O&ffset e"), field::offset,
        tr("Distance of the cylinder axis from the crank axis, positive on the side to which the "
           "crankpin moves first."),
        [](Input& input) -> double& { return input.torque.cylinder.offset; });
    add(tr("Crankcase &pressure"), field::crankcase_pressure,
        tr("Absolute pressure under the piston, p₀."),
        [](Input& input) -> double& { return input.torque.cylinder.crankcase_pressure; });
}

QWidget* TorqueSourceEditor::buildCheck() {
    check_ = new QWidget(this);
    auto* column = new QVBoxLayout(check_);
    column->setContentsMargins(Theme::margin, 0, Theme::margin, Theme::gap);
    column->setSpacing(Theme::gap);
    checkText_ = captionLabel({}, check_);
    column->addWidget(checkText_);
    remedies_ = new QWidget(check_);
    auto* row = new QHBoxLayout(remedies_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(Theme::gap);
    auto* speed = new QPushButton(tr("Use its speed"), remedies_);
    speed->setObjectName(QStringLiteral("use_matching_speed"));
    speed->setToolTip(
        tr("Set the speed at which the masses entered have the inertia torque that "
           "is in the table."));
    auto* rebuild = new QPushButton(tr("Rebuild torque"), remedies_);
    rebuild->setObjectName(QStringLiteral("rebuild_torque"));
    rebuild->setToolTip(
        tr("Take the fitted inertia torque out of the table and put that of the "
           "masses and speed entered in."));
    row->addWidget(speed);
    row->addWidget(rebuild);
    column->addWidget(remedies_);
    connect(speed, &QPushButton::clicked, this, [this] {
        model_->edit(tr("Use the torque's speed"), [this](Input& input) {
            input = balance_shaft::with_matching_speed(input, model_->result().inertia_check);
        });
    });
    connect(rebuild, &QPushButton::clicked, this, [this] {
        model_->edit(tr("Rebuild torque"), [this](Input& input) {
            input = balance_shaft::with_rebuilt_torque(input, model_->result().inertia_check);
        });
    });
    return check_;
}

void TorqueSourceEditor::showCheck() {
    const balance_shaft::InertiaCheck& check = model_->result().inertia_check;
    const bool table = !model_->input().torque.is_computed();
    check_->setVisible(table);
    if (!table) {
        return;
    }
    const QLocale locale;
    const bool wrong = check.consistent && !*check.consistent;
    remedies_->setVisible(wrong);
    QString text;
    if (!check.fitted || !check.consistent) {
        text =
            tr("No inertia torque can be read off this table, so it cannot be checked against "
               "the masses and speed.");
    } else if (wrong) {
        text =
            tr("This torque does not belong to the masses and speed entered. On its gas-exchange "
               "stroke it holds mⱼ r² ω² = %1 N·m (λ %2); entered are %3 N·m. It would fit "
               "%4 min⁻¹ with these masses, or %5 kg at this speed.")
                .arg(fixedNumber(*check.fitted, 0, locale),
                     fixedNumber(check.fitted_lambda, 3, locale),
                     fixedNumber(check.entered, 0, locale),
                     fixedNumber(check.matching_speed / rpm, 0, locale),
                     fixedNumber(check.matching_mass, 3, locale));
    } else {
        text =
            tr("The inertia torque in this table fits the masses and speed: mⱼ r² ω² = %1 N·m "
               "against %2 N·m entered.")
                .arg(fixedNumber(*check.fitted, 0, locale), fixedNumber(check.entered, 0, locale));
    }
    colourText(checkText_, wrong ? Theme::instance().warning() : Theme::instance().mutedText());
    checkText_->setText(text);
}

QWidget* TorqueSourceEditor::buildPressure() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    column->addWidget(captionLabel(
        tr("Measured cylinder pressure over 720° as a CSV file: crank angle from top dead centre "
           "before intake, absolute pressure (bar unless the heading says kPa, MPa, Pa or psi)."),
        content));
    auto* import =
        new QPushButton(themedIcon(QStringLiteral("import")), tr("&Read CSV file…"), content);
    column->addWidget(import);
    trace_ = captionLabel({}, content);
    column->addWidget(trace_);
    auto* form = new FormSection(tr("Cylinder"), content);
    addCylinder(form);
    column->addWidget(form);
    column->addWidget(captionLabel(tr("The rod length is on the Inputs tab."), content));
    column->addStretch();
    connect(import, &QPushButton::clicked, this, [this] {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Read pressure trace"), QString(),
                                         tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
        if (path.isEmpty()) {
            return;
        }
        const QString why = importTrace(path);
        if (!why.isEmpty()) {
            QMessageBox::warning(this, tr("Read pressure trace"), why);
        }
    });
    return scrolled(content, this);
}

QWidget* TorqueSourceEditor::buildCycle() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    column->addWidget(captionLabel(
        tr("A plain four-stroke cycle: constant pressures for gas exchange, polytropic "
           "compression, one Wiebe heat release, polytropic expansion."),
        content));
    auto* cylinder = new FormSection(tr("Cylinder"), content);
    addCylinder(cylinder);
    column->addWidget(cylinder);

    const auto add = [&](FormSection* form, const QString& label, const FieldSpec& spec,
                         const QString& hint, double GasCycle::*member) {
        NumberField* numberField = form->addNumber(label, spec, hint);
        QString step = label;
        step.remove(QLatin1Char('&'));
        connect(numberField, &NumberField::valueEdited, this,
                [this, step, spec, member](std::optional<double> value) {
                    model_->edit(step, [&](Input& input) {
                        input.torque.cycle.*member = *value * spec.to_si;
                    });
                });
        bindings_.push_back({numberField, [this, spec, member]() -> std::optional<double> {
                                 return model_->input().torque.cycle.*member / spec.to_si;
                             }});
    };
    auto* gas = new FormSection(tr("Gas exchange and compression"), content);
    add(gas, tr("Compression &ratio ε"), field::compression_ratio,
        tr("Largest over smallest volume."), &GasCycle::compression_ratio);
    add(gas, tr("&Intake pressure"), field::intake_pressure, tr("Absolute, constant over intake."),
        &GasCycle::intake_pressure);
    add(gas, tr("E&xhaust pressure"), field::exhaust_pressure,
        tr("Absolute, constant over exhaust."), &GasCycle::exhaust_pressure);
    add(gas, tr("Exponent, &compression"), field::polytropic_compression,
        tr("Polytropic exponent until combustion begins; about 1.32 to 1.38."),
        &GasCycle::polytropic_compression);
    add(gas, tr("Exponent, ex&pansion"), field::polytropic_expansion,
        tr("Polytropic exponent of combustion and expansion; about 1.22 to 1.32."),
        &GasCycle::polytropic_expansion);
    column->addWidget(gas);

    auto* heat = new FormSection(tr("Combustion"), content);
    const auto addLoad = [&](const QString& label, const FieldSpec& spec, const QString& hint,
                             std::optional<double> GasCycle::*own,
                             std::optional<double> GasCycle::*other) {
        NumberField* numberField = heat->addNumber(label, spec, hint);
        numberField->setOptional(true);
        numberField->setPlaceholderText(tr("from the other"));
        numberField->setDigits(6);
        QString step = label;
        step.remove(QLatin1Char('&'));
        connect(numberField, &NumberField::valueEdited, this,
                [this, step, spec, own, other](std::optional<double> value) {
                    if (!value) {
                        return;  // one of the two always holds
                    }
                    model_->edit(step, [&](Input& input) {
                        input.torque.cycle.*own = *value * spec.to_si;
                        (input.torque.cycle.*other).reset();
                    });
                });
        bindings_.push_back({numberField, [this, spec, own]() -> std::optional<double> {
                                 const auto& value = model_->input().torque.cycle.*own;
                                 return value ? std::optional(*value / spec.to_si) : std::nullopt;
                             }});
    };
    addLoad(tr("I&MEP"), field::imep,
            tr("Indicated mean effective pressure over 720°; the heat that gives it is found."),
            &GasCycle::imep, &GasCycle::heat);
    addLoad(tr("&Heat"), field::heat, tr("Heat released per cycle; instead of the IMEP."),
            &GasCycle::heat, &GasCycle::imep);
    add(heat, tr("&Start of combustion"), field::combustion_start,
        tr("Crank angle; 360° is the firing top dead centre."), &GasCycle::combustion_start);
    add(heat, tr("&Duration"), field::combustion_duration,
        tr("Crank angle from the start to the end of heat release."),
        &GasCycle::combustion_duration);
    add(heat, tr("&Wiebe exponent m"), field::wiebe_m,
        tr("Form exponent of Wiebe's law; 0.5 to 1.5 for diesels, 2 to 4 for petrol engines."),
        &GasCycle::wiebe_m);
    column->addWidget(heat);
    column->addStretch();
    return scrolled(content, this);
}

QString TorqueSourceEditor::importTrace(const QString& path) {
    try {
        const std::string text = read_text_file(fsPath(path));
        const balance_shaft::ParsedPressureTrace read = balance_shaft::parse_pressure_trace(text);
        const QString why = model_->setPressureTrace(read.trace, path);
        if (!why.isEmpty()) {
            return path + QStringLiteral(": ") + why;
        }
        trace_->setText(tr("%1: %2.").arg(QFileInfo(path).fileName(), tableFormatText(read)));
        return {};
    } catch (const InputError& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
}

void TorqueSourceEditor::showInput() {
    const int page = pageOf(model_->input().torque.kind);
    choice_->setCurrentIndex(page);
    forms_->setCurrentIndex(page);
    for (const Binding& binding : bindings_) {
        binding.field->setValue(binding.read());
    }
    showCheck();
}

}  // namespace ravnoves
