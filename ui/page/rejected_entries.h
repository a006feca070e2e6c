#pragma once

#include <QStringList>

class QWidget;

namespace ravnoves {

class EntryField;

/// The entries of the page that a widget is part of, whatever their tab.
QList<EntryField*> entriesOfPage(const QWidget* part);

/// What is typed and rejected in them and in the tables of the page and of its tolerances now:
/// "Crank radius r, mm: The value must be greater than 0 mm."
QStringList rejectedEntries(const QWidget* part);
/// Those of them that results depend on: not the date of a job.
QStringList rejectedInputs(const QWidget* part);

/// The same as a paragraph that goes with a question; empty where nothing is rejected.
QString rejectedWords(const QWidget* part);

/// Says which entries of that page are rejected and that the values before them are used.
/// @param title  what is about to be done
/// @return true where there are none, or the user continues without them
bool goOnWithoutRejected(QWidget* part, const QString& title);

}  // namespace ravnoves
