#pragma once

#include <QCoreApplication>
#include <QString>
#include <functional>

class QWidget;

namespace ravnoves {

struct CaseFile;

/// A file that a case names and that cannot be read.
struct MissingFile {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::MissingFile)

  public:
    /// Loads a case; where a file that it names cannot be read, prompts for its present place,
    /// enters that into the case, and tries again.
    /// @param over    parent of the questions
    /// @param title   of the questions: the action
    /// @param name    of the case, for the fault
    /// @param folder  of the case
    /// @return false after Cancel
    /// @throws InputError of another fault
    static bool locate(QWidget* over, const QString& title, const QString& name,
                       const QString& folder, CaseFile& file, const std::function<void()>& load);
};

}  // namespace ravnoves
