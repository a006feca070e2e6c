#pragma once

#include "v8-plugs/v8_sheet.h"

namespace ravnoves {

/// Sheet 1: whose engine it is, which engine, and how much heavier its parts are.
class JobSheet : public V8Sheet {
    Q_OBJECT

  public:
    explicit JobSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  private:
    void buildWork();
    void buildChanges();
    void showEngines();

    QComboBox* engine_ = nullptr;
};

}  // namespace ravnoves
