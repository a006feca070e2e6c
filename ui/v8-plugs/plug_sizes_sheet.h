#pragma once

#include "v8-plugs/v8_sheet.h"

namespace ravnoves {

/// Sheet 4: sizes of the plug, the cutter, the walls that must stay, densities.
class PlugSizesSheet : public V8Sheet {
    Q_OBJECT

  public:
    explicit PlugSizesSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  private:
    void addThread();
};

}  // namespace ravnoves
