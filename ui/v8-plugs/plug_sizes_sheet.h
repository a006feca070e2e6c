#pragma once

#include "v8-plugs/sheet_form.h"

namespace ravnoves {

/// Sheet 4: sizes of the plug, the cutter, the walls that must stay, densities.
class PlugSizesSheet : public SheetForm {
    Q_OBJECT

  public:
    explicit PlugSizesSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  private:
    void addThread();
};

}  // namespace ravnoves
