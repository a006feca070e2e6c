#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace ravnoves {

/// What's this: every widget that has a tip explains itself by it, every cell and heading of a
/// table as well. Shift+F1 asks what has the focus, the action of the Help menu waits for a click.
class WhatsThis : public QObject {
    Q_OBJECT

  public:
    /// @param window  in which Shift+F1 asks
    explicit WhatsThis(QWidget* window);

    QAction* action() const { return action_; }
    /// The explanation of a widget, as rich text; empty where it has none.
    /// @param at  in the widget, for those that hold several things
    static QString explanation(const QWidget* widget, const QPoint& at);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void explainFocus();

    QAction* action_;
};

}  // namespace ravnoves
