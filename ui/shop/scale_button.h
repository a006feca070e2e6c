#pragma once

#include <QPointer>
#include <QToolButton>

namespace ravnoves {

namespace shop {
struct ScaleLine;
}
class ScaleDialog;
class ScaleReader;

/// The scale in the status bar of the window: its reading, or that it is unplugged; a click opens
/// its settings. Hidden where no scale is set up. Weights are entered into the field with the
/// focus.
class ScaleButton : public QToolButton {
    Q_OBJECT

  public:
    explicit ScaleButton(QWidget* parent = nullptr);

    ScaleReader* reader() { return reader_; }
    void openSettings();

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  private:
    void showConnection();
    void showLine(const shop::ScaleLine& line);

    ScaleReader* reader_;
    QPointer<ScaleDialog> settings_;
};

}  // namespace ravnoves
