#include "studies/tolerance_switch.h"

#include <QSettings>

namespace ravnoves {

namespace {

const QString switchKey = QStringLiteral("tolerances/shown");

}  // namespace

ToleranceSwitch& ToleranceSwitch::instance() {
    static ToleranceSwitch one;
    return one;
}

ToleranceSwitch::ToleranceSwitch() : on_(QSettings().value(switchKey, true).toBool()) {}

void ToleranceSwitch::setOn(bool on) {
    if (on != on_) {
        on_ = on;
        QSettings().setValue(switchKey, on);
        Q_EMIT changed(on);
    }
}

}  // namespace ravnoves
