#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace ravnoves {

/// The in-program help: its pages, one of them shown, and a search in that. It closes when language
/// or theme change.
class HelpWindow : public QDialog {
    Q_OBJECT

  public:
    explicit HelpWindow(const QString& topic, QWidget* parent = nullptr);

    /// Comes to the front with this page.
    void goTo(const QString& topic);

  private:
    void showPage(const QString& topic);
    /// Moves to the next or previous place of the searched text, wrapping round the page.
    void find(bool backwards);

    QLineEdit* field_;
    QLabel* found_;
    QListWidget* list_;
    QTextBrowser* text_;
};

}  // namespace ravnoves
