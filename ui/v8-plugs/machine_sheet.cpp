#include "v8-plugs/machine_sheet.h"

#include "page/part_views.h"
#include "shop/balance_grade.h"
#include "theme/theme.h"

namespace ravnoves {

MachineSheet::MachineSheet(V8PlugsModel* model, QWidget* parent) : V8Sheet(model, parent) {
    section(tr("Permissible residual unbalance, ISO 21940-11"));
    number("/balancing/grade_mm_s");
    doubt(number("/balancing/rotor_mass_kg"), [this] {
        const auto& sheet = model_->input().balancing;
        return sheet && shop::is_mass_in_grams(sheet->rotor_mass);
    });
    doubt(number("/balancing/service_speed_rpm"), [this] {
        const auto& sheet = model_->input().balancing;
        return sheet && shop::is_odd_speed(sheet->service_speed);
    });
    number("/balancing/front_share");
    section(tr("What the machine reads"));
    QList<NumberField*> readings;
    for (const char* reading : {"/balancing/front_reading_g_mm", "/balancing/rear_reading_g_mm"}) {
        NumberField* field = number(reading);
        readings << field;
        doubt(field, [this, field] { return !model_->solution().holds() && field->value(); });
    }
    auto* planes = new PartTable(model, "planes", tr("Correction planes"), this);
    planes->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    current()->addWide(planes);
    addHold([this] { return model_->otherReadingsText(); }, [this] { model_->confirmReadings(); },
            readings);
    line(Theme::baseSize, [this] { return model_->isoText(); });
    line(Theme::smallSize, [this] {
        return model_->machineLimitsText();
    })->setObjectName(QStringLiteral("machine_limits"));
    section(tr("Notes on the job card"));
    text("/job/notes", longestNotes);
    finish();
}

}  // namespace ravnoves
