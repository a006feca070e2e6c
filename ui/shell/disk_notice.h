#pragma once

#include "shell/notice_bar.h"

namespace ravnoves {

class CaseDocument;

/// Over the page: that the case's file, or one that it reads, was changed or deleted by others, and
/// what to do. Hidden where they are as they were.
class DiskNotice : public NoticeBar {
    Q_OBJECT

  public:
    explicit DiskNotice(QWidget* parent = nullptr);

    void showFor(CaseDocument* document);

  Q_SIGNALS:
    void reloadAsked();
    void keepAsked();
    void saveAsAsked();

  private:
    QPushButton* reload_;
    QPushButton* keep_;
    QPushButton* saveAs_;
};

}  // namespace ravnoves
