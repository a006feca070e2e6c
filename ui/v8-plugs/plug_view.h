#pragma once

#include <QWidget>

#include "theme/theme.h"

namespace ravnoves {

class V8PlugsModel;

/// The plug in section with its dimensions and what is to be bored out of it.
class PlugView : public QWidget {
    Q_OBJECT

  public:
    explicit PlugView(V8PlugsModel* model, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {300, minimumSizeHint().height()}; }
    QSize minimumSizeHint() const override { return {Theme::withText(200), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    V8PlugsModel* model_;
};

}  // namespace ravnoves
