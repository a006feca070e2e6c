#pragma once

#include <QDialog>
#include <QList>

#include "shop/model/journal.h"
#include "shop/model/words.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace ravnoves {

/// The jobs in the journal: search by numbers, customer or day, open, copy, remove, export.
class JournalDialog : public QDialog {
    Q_OBJECT

  public:
    /// @param text  searched for, as if it were typed
    explicit JournalDialog(Journal* journal, QWidget* parent = nullptr, const QString& text = {});

    /// The job that the user wants, to be copied or opened.
    qint64 chosenId() const { return chosen_; }
    bool isCopy() const { return isCopy_; }
    /// Writes the jobs listed to a CSV file. @return an empty string, or what went wrong
    QString exportTo(const QString& file);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void search();
    void choose(bool isCopy);
    void removeSelected();
    void exportWithDialog();
    qint64 selectedId() const;

    QStringList cellsOf(const Words& words, const JournalJob& job) const;

    Journal* journal_;
    QList<JournalJob> jobs_;
    bool truncated_ = false;  // more match than the list shows
    qint64 chosen_ = 0;
    bool isCopy_ = false;
    QLineEdit* text_;
    QCheckBox* unfinished_;
    QTableWidget* table_;
    QLabel* message_;
    QPushButton* open_;
    QPushButton* copy_;
    QPushButton* remove_;
    QPushButton* export_;
};

}  // namespace ravnoves
