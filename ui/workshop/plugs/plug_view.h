#pragma once

#include <QWidget>

#include "theme/theme.h"

namespace ravnoves {

class WorkshopModel;

/// The plug in section with its dimensions and the metal to bore out.
class PlugView : public QWidget {
    Q_OBJECT

  public:
    explicit PlugView(WorkshopModel* model, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {300, minimumSizeHint().height()}; }
    QSize minimumSizeHint() const override { return {Theme::withText(200), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    WorkshopModel* model_;
};

}  // namespace ravnoves
