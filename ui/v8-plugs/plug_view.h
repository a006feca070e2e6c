#pragma once

#include <QWidget>

namespace ravnoves {

class V8PlugsViewModel;

/// The plug in section with its dimensions and what is to be bored out of it.
class PlugView : public QWidget {
    Q_OBJECT

  public:
    explicit PlugView(V8PlugsViewModel* model, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {300, 200}; }
    QSize minimumSizeHint() const override { return {200, 130}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    V8PlugsViewModel* model_;
};

}  // namespace ravnoves
