#pragma once

#include "v8-plugs/model/v8_plugs_model.h"
#include "workshop/matching_sheet.h"

namespace ravnoves {

/// Sheet 3, the weigh-in: what is typed or weighed counts; what the parts make of the crankpins.
class WeighInSheet : public MatchingSheet {
    Q_OBJECT

  public:
    explicit WeighInSheet(V8PlugsModel* model, QWidget* parent = nullptr);
};

}  // namespace ravnoves
