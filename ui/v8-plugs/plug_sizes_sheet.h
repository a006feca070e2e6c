#pragma once

#include "v8-plugs/sheet_form.h"

namespace ravnoves {

/// Sheet 4: sizes of the plug, the cutter, the walls that must stay, densities.
class PlugSizesSheet : public SheetForm {
    Q_OBJECT

  public:
    explicit PlugSizesSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  private:
    void addThread(FormSection* section);
    void addSize(FormSection* section, const QString& label, const FieldSpec& spec,
                 std::optional<double> v8_plugs::PlugSheet::*member, const QString& hint);
    void addDensity(FormSection* section, const QString& label, const FieldSpec& spec,
                    double v8_plugs::PlugSheet::*member, double usual, const QString& hint);
};

}  // namespace ravnoves
