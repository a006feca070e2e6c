#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <string>
#include <utility>

class QWidget;

namespace ravnoves {

class InputError;
struct CaseFile;

/// A file that a case names and that cannot be read: prompts for its present place. One for each
/// case that is opened, for it remembers the earlier answers.
class MissingFile {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::MissingFile)

  public:
    /// @param over    parent of the questions
    /// @param title   of the questions: the action
    /// @param folder  of the case
    MissingFile(QWidget* over, QString title, QString folder)
        : over_(over), title_(std::move(title)), folder_(std::move(folder)) {}

    /// Prompts for the file of the error, and enters the answer into the case.
    /// @param trouble  the fault, as text
    /// @return empty for another fault; false after Cancel
    std::optional<bool> locate(CaseFile& file, const InputError& error, const QString& trouble);

  private:
    /// @return an empty text where the user gives up
    QString ask(const QString& trouble) const;

    QWidget* over_;
    QString title_;
    QString folder_;
    std::string where_;  ///< in the case
    QString name_;       ///< as the case has it
};

}  // namespace ravnoves
