#pragma once

#include <QDialog>
#include <optional>

#include "shell/new_cases.h"

class QListWidget;

namespace ravnoves {

/// Asks what a new case begins with: a scene, and of it an empty engine, a preset or an example.
class NewCaseDialog : public QDialog {
    Q_OBJECT

  public:
    /// @param scene  the one that is chosen first
    explicit NewCaseDialog(const QString& scene, QWidget* parent = nullptr);

    /// @return nothing where the user thought better of it
    static std::optional<CaseFile> ask(const QString& scene, QWidget* parent);
    CaseFile chosen() const;

  private:
    void fill();

    std::vector<NewCase> all_;
    QListWidget* scenes_;
    QListWidget* beginnings_;
};

}  // namespace ravnoves
