#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "shell/help_pages.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QTextBrowser;
class QToolButton;

namespace ravnoves {

/// The in-program help: its pages, one of them shown, and a search through all of them.
class HelpWindow : public QDialog {
    Q_OBJECT

  public:
    explicit HelpWindow(const QString& topic, QWidget* parent = nullptr);
    ~HelpWindow() override;

    QString topic() const { return topic_; }
    /// Comes to the front with this page.
    void goTo(const QString& topic);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Page {
        QString topic;
        QString title;
        std::unique_ptr<QTextDocument> text;  ///< to search in
        std::vector<HelpHit> hits;
    };

    /// In the present language and theme.
    void renew();
    void readPages();
    void showPage(const QString& topic);
    void search();
    /// Fills the list: the pages, or what was found in them.
    void fillList();
    void showItem(const QListWidgetItem* item);
    /// Goes to the next place, or the one before.
    void step(int by);
    void markHits();
    const Page* page(const QString& topic) const;

    std::vector<Page> pages_;
    QString topic_;
    const HelpHit* hit_ = nullptr;  ///< the present one
    QLineEdit* field_;
    QLabel* count_;
    QToolButton* previous_;
    QToolButton* next_;
    QListWidget* list_;
    QTextBrowser* text_;
};

}  // namespace ravnoves
