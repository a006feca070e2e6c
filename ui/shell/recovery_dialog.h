#pragma once

#include <QDialog>

#include "model/recovery.h"

class QTreeWidget;

namespace ravnoves {

/// Offers what a crash has left: each case with title, job, file and time, ticked.
class RecoveryDialog : public QDialog {
    Q_OBJECT

  public:
    explicit RecoveryDialog(const Recovery::Found& found, QWidget* parent = nullptr);

  Q_SIGNALS:
    void restored(const RecoveredCase& recovered);
    void discarded(const RecoveredCase& recovered);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Asks, once for all.
    bool mayDiscard();
    /// Removes the ticked cases from the list. Closes when it is empty.
    QList<RecoveredCase> takeTicked();

    QList<RecoveredCase> cases_;
    QTreeWidget* list_ = nullptr;
};

}  // namespace ravnoves
