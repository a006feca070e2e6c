#pragma once

#include <functional>

#include "widgets/panel.h"

class QLabel;
class QPushButton;

namespace ravnoves {

class CaseDocument;

/// Over the page: that the case's file, or one that it reads, was changed or deleted by others, and
/// what to do about it. Hidden where they are as they were.
class DiskNotice : public Panel {
    Q_OBJECT

  public:
    explicit DiskNotice(QWidget* parent = nullptr);

    /// @param page  has the focus again where the notice had it and hides
    void showFor(CaseDocument* document, QWidget* page);

  Q_SIGNALS:
    void saveAsWanted();

  private:
    QPushButton* addButton(const char* name, const QString& text, const QString& tip,
                           const std::function<void()>& pressed);
    void reload();

    CaseDocument* document_ = nullptr;
    QLabel* text_;
    QPushButton* reload_;
    QPushButton* keep_;
    QPushButton* saveAs_;
};

}  // namespace ravnoves
