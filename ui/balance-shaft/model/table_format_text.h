#pragma once

#include <QString>

#include "balance-shaft/torque_table.h"

namespace ravnoves {

/// What a table read from text turned out to be: TableFormat::describe() in the language of the
/// program, without the full stop.
QString tableFormatText(const balance_shaft::TableFormat& table);

}  // namespace ravnoves
