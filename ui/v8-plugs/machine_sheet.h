#pragma once

#include "v8-plugs/v8_sheet.h"

namespace ravnoves {

/// Sheet 5: the permissible residual unbalance, what the balancing machine reads, and the notes.
class MachineSheet : public V8Sheet {
    Q_OBJECT

  public:
    explicit MachineSheet(V8PlugsModel* model, QWidget* parent = nullptr);
};

}  // namespace ravnoves
