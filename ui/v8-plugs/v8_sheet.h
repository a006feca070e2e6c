#pragma once

#include "v8-plugs/model/v8_plugs_model.h"
#include "workshop/sheet_form.h"

namespace ravnoves {

/// A sheet of the V-8 page.
class V8Sheet : public SheetForm {
    Q_OBJECT

  public:
    explicit V8Sheet(V8PlugsModel* model, QWidget* parent = nullptr)
        : SheetForm(model, parent), model_(model) {}

  protected:
    V8PlugsModel* model_;
};

}  // namespace ravnoves
