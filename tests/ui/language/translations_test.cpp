// The Russian texts: all are there, and a translation asks for the same values as its source.

#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "language/catalogue.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using test::CatalogueEntry;

QStringList placeholders(const QString& text) {
    static const QRegularExpression form(u"%(L?[1-9]|n)"_s);
    QStringList found;
    for (auto match = form.globalMatch(text); match.hasNext();) {
        found << match.next().captured();
    }
    found.sort();
    return found;
}

/// "&" before a letter; "&&" and "& " are the sign itself.
int mnemonics(const QString& text) {
    static const QRegularExpression form(u"&[^& ]"_s);
    return static_cast<int>(text.count(form));
}

std::string name(const CatalogueEntry& entry) {
    return (entry.context + u": "_s + entry.source).toStdString();
}

/// The texts as the sources have them today: a copy of the file that lupdate has been over.
std::vector<CatalogueEntry> textsOfToday() {
    const QTemporaryDir folder;
    const QString copy = folder.filePath(u"ru.ts"_s);
    EXPECT_TRUE(QFile::copy(test::russianFile(), copy));
    QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    // As the target update-translations does.
    QStringList arguments{u"-silent"_s, u"-no-obsolete"_s, u"-locations"_s,
                          u"none"_s,    u"-I"_s,           QStringLiteral(RAVNOVES_SOURCE "/ui")};
    for (const QString& layer :
         {QStringLiteral(RAVNOVES_SOURCE "/core"), QStringLiteral(RAVNOVES_SOURCE "/ui")}) {
        for (QDirIterator files(layer, {u"*.cpp"_s, u"*.h"_s}, QDir::Files,
                                QDirIterator::Subdirectories);
             files.hasNext();) {
            if (const QString file = files.next(); !file.endsWith(u"/core/numerics/text.h"_s)) {
                arguments << file;
            }
        }
    }
    arguments << u"-ts"_s << copy;
    QProcess lupdate;
    lupdate.setProcessChannelMode(QProcess::MergedChannels);
    lupdate.start(QStringLiteral(RAVNOVES_LUPDATE), arguments);
    EXPECT_TRUE(lupdate.waitForFinished(60'000) && lupdate.exitCode() == 0)
        << lupdate.readAll().toStdString();
    return test::readCatalogue(copy);
}

TEST(Translations, EveryTextOfTheSourcesIsTranslated) {
    const std::vector<CatalogueEntry> entries = textsOfToday();
    EXPECT_GT(entries.size(), 1000U);
    for (const CatalogueEntry& entry : entries) {
        EXPECT_TRUE(entry.finished) << "not translated: " << name(entry);
        EXPECT_EQ(entry.translations.size(), entry.plural ? 3 : 1) << name(entry);
        for (const QString& text : entry.translations) {
            EXPECT_FALSE(text.trimmed().isEmpty()) << "empty: " << name(entry);
        }
    }
}

TEST(Translations, AskForTheSameValues) {
    for (const CatalogueEntry& entry : test::readCatalogue(test::russianFile())) {
        for (const QString& text : entry.translations) {
            EXPECT_EQ(placeholders(text), placeholders(entry.source))
                << name(entry) << " = " << text.toStdString();
        }
    }
}

TEST(Translations, KeepMnemonicsMarkupAndSpaceAround) {
    static const QRegularExpression tag(u"<[^>]+>"_s);
    static const QRegularExpression before(u"^[ \\n]"_s);
    static const QRegularExpression after(u"[ \\n]$"_s);
    for (const CatalogueEntry& entry : test::readCatalogue(test::russianFile())) {
        for (const QString& text : entry.translations) {
            const std::string both = name(entry) + " = " + text.toStdString();
            EXPECT_EQ(mnemonics(text), mnemonics(entry.source)) << both;
            EXPECT_EQ(text.count(tag), entry.source.count(tag)) << both;
            EXPECT_EQ(text.count(before), entry.source.count(before)) << both;
            EXPECT_EQ(text.count(after), entry.source.count(after)) << both;
            EXPECT_EQ(text.endsWith(u"…"_s), entry.source.endsWith(u"…"_s)) << both;
        }
    }
}

}  // namespace
}  // namespace ravnoves
