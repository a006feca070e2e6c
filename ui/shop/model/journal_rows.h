#pragma once

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include "shop/model/journal.h"

namespace ravnoves::journal_rows {

// How jobs are in the rows of the database; shared by the parts of the journal.

/// The columns that read() expects, in their order; a file of version 1 has the first of them.
extern const QString columns;
extern const QString columnsOfVersionOne;

/// The job in the query's present row. What a row of version 1 has not is taken from its form.
JournalJob read(const QSqlQuery& query);
/// The columns of valuesOf(), in their order, and a place for each.
extern const QString written;
extern const QString places;
/// All but id and revision.
QVariantList valuesOf(const JournalJob& job);

/// Lower case in every alphabet, so that a search finds "змз" in "ЗМЗ": SQLite folds ASCII only.
QString folded(const QString& text);

/// True where SQLite says that the file is damaged or no database.
bool meansDamaged(const QSqlError& error);
/// Whether another program has locked the file now.
bool meansBusy(const QSqlError& error);
/// What SQLite says, as text for who works with the journal.
QString faultText(const QSqlError& error);

}  // namespace ravnoves::journal_rows
