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

/// A file that a case names and that cannot be read: the user is asked where it is now. One for
/// each case that is opened, for it knows what was asked before.
class MissingFile {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::MissingFile)

  public:
    /// @param over    the questions stand over it
    /// @param title   of the questions: what is being done
    /// @param folder  of the case
    MissingFile(QWidget* over, QString title, QString folder)
        : over_(over), title_(std::move(title)), folder_(std::move(folder)) {}

    /// Asks for the file that the error is about, and enters the answer into the case.
    /// @param trouble  what is wrong, as text
    /// @return nothing where something else is wrong; false where the user gives up
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
