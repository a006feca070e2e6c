#include "v8-plugs/machine_sheet.h"

#include <QLabel>
#include <QVBoxLayout>

#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "widgets/form_section.h"
#include "widgets/result_table.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

/// The machine's part of the input, made where there is none yet.
BalancingSheet& machine(Input& input) {
    if (!input.balancing) {
        input.balancing.emplace();
    }
    return *input.balancing;
}

}  // namespace

MachineSheet::MachineSheet(V8PlugsModel* model, QWidget* parent) : SheetForm(model, parent) {
    auto* limits = new FormSection(tr("Permissible residual unbalance, ISO 21940-11"), this);
    addValue(
        limits, tr("&Grade G"), grade_field, &BalancingSheet::grade,
        tr("Balance quality grade. The standard's table has 0.4, 1, 2.5, 6.3, 16, 40, 100, 250, "
           "630, 1600, 4000 mm/s; crankshaft drives of car, truck and locomotive engines G 100, "
           "inherently balanced crankshafts better."));
    addValue(limits, tr("&Mass of the crankshaft"), rotor_mass_field, &BalancingSheet::rotor_mass,
             tr("As it lies on the machine, with the bob weights."));
    addValue(limits, tr("Service s&peed"), service_speed_field, &BalancingSheet::service_speed,
             tr("The highest speed in service, not that of the machine."));
    number(
        limits, tr("&Share of the front plane"), front_share_field,
        tr("Half for a crankshaft whose mass lies midway between the planes; the standard allows "
           "0.3 to 0.7."),
        [this]() -> std::optional<double> {
            return model_->input().balancing ? model_->input().balancing->front_share : 0.5;
        },
        [](Input& input, std::optional<double> typed) {
            machine(input).front_share = typed.value_or(0.5);
        });
    column_->addWidget(limits);
    QLabel* iso = wrapped(this, Theme::baseSize);
    column_->addWidget(iso);
    follow([this, iso] { iso->setText(model_->isoText()); });

    auto* readings = new FormSection(tr("What the machine reads"), this);
    addValue(readings, tr("&Front plane (pulley)"), front_reading_field,
             &BalancingSheet::front_reading, tr("Residual unbalance after correction."));
    addValue(readings, tr("&Rear plane (flywheel)"), rear_reading_field,
             &BalancingSheet::rear_reading, tr("Residual unbalance after correction."));
    column_->addWidget(readings);
    planes_ = new ResultTable(this);
    planes_->setAccessibleName(tr("Correction planes"));
    planes_->setColumns(model_->planeColumns());
    planes_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column_->addWidget(planes_);
    follow([this] { planes_->setRows(model_->planeRows()); });

    auto* notes = new FormSection(tr("Notes on the job card"), this);
    text(notes, tr("&Notes"), QStringLiteral("notes"), &JobHeader::notes,
         tr("Printed on the job card."), 200);
    column_->addWidget(notes);
    column_->addStretch();
}

void MachineSheet::addValue(FormSection* section, const QString& label, const FieldSpec& spec,
                            std::optional<double> BalancingSheet::*member, const QString& hint) {
    number(
        section, label, spec, hint,
        [this, spec, member]() -> std::optional<double> {
            const auto& sheet = model_->input().balancing;
            if (!sheet || !((*sheet).*member)) {
                return std::nullopt;
            }
            return in_unit(((*sheet).*member).value(), spec);
        },
        [spec, member](Input& input, std::optional<double> typed) {
            machine(input).*member = typed ? std::optional(*typed * spec.to_si) : std::nullopt;
        });
}

}  // namespace ravnoves
