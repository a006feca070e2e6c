#include "workshop/model/shop_machine.h"

#include <QSettings>

#include "case-file/case_file.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/json.h"

namespace ravnoves {

namespace {
const QString machineKey = QStringLiteral("workshop/machine");
}  // namespace

workshop::Machine shop_machine::kept() {
    const QString text = QSettings().value(machineKey).toString();
    try {
        return text.isEmpty() ? workshop::Machine()
                              : read_fields<workshop::Machine>(parse_json(text.toStdString()),
                                                               Completeness::as_is);
    } catch (const InputError&) {
        return {};  // damaged settings are none
    }
}

void shop_machine::keep(const workshop::Machine& machine) {
    QSettings().setValue(machineKey, QString::fromStdString(write_fields(machine).dump()));
}

}  // namespace ravnoves
