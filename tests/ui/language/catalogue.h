#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace ravnoves::test {

/// One text of the program in a translation file.
struct CatalogueEntry {
    QString context;
    QString source;
    QStringList translations;  ///< one, or one for each plural form
    bool finished = false;
    bool plural = false;
};

/// The texts of a .ts file.
std::vector<CatalogueEntry> readCatalogue(const QString& path);

/// The Russian texts as they stand in the project.
QString russianFile();

}  // namespace ravnoves::test
