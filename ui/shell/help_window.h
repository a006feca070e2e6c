#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QTextDocument;

namespace ravnoves {

/// The in-program help: its pages, one of them shown, and a search in that.
class HelpWindow : public QDialog {
    Q_OBJECT

  public:
    explicit HelpWindow(const QString& topic, QWidget* parent = nullptr);

    /// Comes to the front with this page.
    void goTo(const QString& topic);

  private:
    /// In the present language and theme.
    void renew();
    void showPage(const QString& topic);
    /// Moves to the next or previous place of the searched text, wrapping round the page.
    void find(bool backwards);

    QString topic_;
    QLineEdit* field_;
    QLabel* found_;
    QListWidget* list_;
    QTextBrowser* text_;
};

/// The pages of the help by their names: the scenes' pages, then the others.
QStringList helpTopics();

/// Puts a page of resources/help into a document: Markdown, in the present language where there is
/// one (TOPIC.LANG.md), else English (TOPIC.md), set with room between paragraphs.
/// @return false without one
bool loadHelp(const QString& topic, QTextDocument* document);
/// Its first heading.
QString helpTitle(const QString& topic);

}  // namespace ravnoves
