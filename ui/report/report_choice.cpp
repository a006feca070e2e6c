#include "report/report_choice.h"

#include <QSettings>

#include "text/usual_paper.h"

namespace ravnoves {

namespace {

QString key(const char* name) {
    return QStringLiteral("report/") + QLatin1String(name);
}

}  // namespace

ReportChoice ReportChoice::kept() {
    const QSettings settings;
    const auto isOn = [&](const char* name, bool usual) {
        return settings.value(key(name), usual).toBool();
    };
    const bool isLetter = settings.value(key("letter"), usualPaper() == QPageSize::Letter).toBool();
    return {isOn("inputs", true), isOn("plots", true), isOn("formulas", true),
            isOn("validation", false), isLetter ? QPageSize::Letter : QPageSize::A4};
}

void ReportChoice::keep() const {
    QSettings settings;
    settings.setValue(key("inputs"), inputs);
    settings.setValue(key("plots"), plots);
    settings.setValue(key("formulas"), formulas);
    settings.setValue(key("validation"), validation);
    settings.setValue(key("letter"), paper == QPageSize::Letter);
}

}  // namespace ravnoves
