#pragma once

#include <QString>

#include "balance-shaft/torque_table.h"

namespace ravnoves {

/// What a table read from text turned out to be: TableText::describe() in the language of the
/// program, without the full stop.
QString tableText(const balance_shaft::TableText& table);

}  // namespace ravnoves
