#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace ravnoves {

class EntryField;
/// A rejected field in another language than the program's, in which its sentence is.
using Retold = std::function<QString(const EntryField&)>;

/// Rejected texts in the fields and tables of a part's page and in the tables of its tolerances, or
/// in a window beside a page: "Crank radius r, mm: The value must be greater than 0 mm."
QStringList rejectedEntries(const QWidget* part, const Retold& retold = {});
/// The rejected ones that results depend on: not the date of a job.
QStringList rejectedInputs(const QWidget* part, const Retold& retold = {});

/// The same as a paragraph for a question; empty where nothing is rejected.
QString rejectedWords(const QWidget* part);

/// False where rejected entries must be corrected before a case can be saved: it names them and
/// shows the first.
bool mayBeSaved(QWidget* part, const QString& title, const QString& name = {});
/// Names those rejected entries and that the values before them are used. Where the user stays, the
/// first of them is shown.
/// @param title  of the action
/// @param name   of the case, where the page may be behind another
/// @return true where there are none, or the user continues without them
bool continueWithoutRejected(QWidget* part, const QString& title, const QString& name = {});
/// Before a case is saved: both.
bool saveWithoutRejected(QWidget* part, const QString& title, const QString& name = {});

}  // namespace ravnoves
