#include "language/catalogue.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QXmlStreamReader>

namespace ravnoves::test {

namespace {

using namespace Qt::StringLiterals;

CatalogueEntry readMessage(QXmlStreamReader& xml, const QString& context) {
    CatalogueEntry entry;
    entry.context = context;
    entry.plural = xml.attributes().value("numerus"_L1) == "yes"_L1;
    while (xml.readNextStartElement()) {
        if (xml.name() == "source"_L1) {
            entry.source = xml.readElementText();
        } else if (xml.name() == "translation"_L1) {
            entry.finished = !xml.attributes().hasAttribute("type"_L1);
            if (!entry.plural) {
                entry.translations << xml.readElementText();
                continue;
            }
            while (xml.readNextStartElement()) {
                entry.translations << xml.readElementText();
            }
        } else {
            xml.skipCurrentElement();
        }
    }
    return entry;
}

}  // namespace

std::vector<CatalogueEntry> readCatalogue(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    std::vector<CatalogueEntry> entries;
    QString context;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == "name"_L1) {
            context = xml.readElementText();
        } else if (xml.isStartElement() && xml.name() == "message"_L1) {
            entries.push_back(readMessage(xml, context));
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return entries;
}

QString russianFile() {
    return QStringLiteral(RAVNOVES_SOURCE "/resources/translations/ravnoves_ru.ts");
}

}  // namespace ravnoves::test
