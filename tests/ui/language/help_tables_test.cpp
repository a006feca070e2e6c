// The tables of keys in the help on case files are those of the fields, in every language.
// To renew them: cmake --build build/release --target update-help

#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/field_index.h"
#include "page/scene_page.h"
#include "scenes/scenes.h"
#include "shell/scene_list.h"
#include "text/language.h"
#include "text/message_text.h"
#include "workshop/older_formats.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

struct HelpPage {
    QString language;
    QString file;
    QString heading;  ///< of a scene's table, with %1 for its name
    QString head;     ///< of the table
    QString either;   ///< before keys that may stand instead
};

const std::vector<HelpPage>& helpPages() {
    static const std::vector<HelpPage> pages{
        {u"en"_s, u"case-files.md"_s, u"## %1: input"_s, u"| Key | Meaning | Allowed | Default |"_s,
         u"or"_s},
        {u"ru"_s, u"case-files.ru.md"_s, u"## %1: входные данные"_s,
         u"| Ключ | Значение | Допустимо | По умолчанию |"_s, u"или"_s}};
    return pages;
}

QString code(const QString& text) {
    return u'`' + text + u'`';
}

QString plain(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString numberText(double value) {
    return QString::fromStdString(format_number(value));
}

/// "spring/stiffness_N_m", "cylinders[]/offset_mm"
QString keyOf(const FieldEntry& entry) {
    static const QRegularExpression index(u"/[0-9]+(?=/|$)"_s);
    QString key = QString::fromStdString(entry.pointer).mid(1);
    return key.replace(index, u"[]"_s);
}

QString allowed(const FieldEntry& entry) {
    QStringList parts;
    for (const Word& word : entry.field.words) {
        const QString label = shownText(word.label);
        const QString name = entry.kind == FieldKind::integer
                                 ? code(plain(word.word))
                                 : code(u'"' + plain(word.word) + u'"');
        parts << (label.isEmpty() ? name : name + u" ("_s + label + u')');
    }
    if (entry.kind == FieldKind::flag) {
        parts << code(u"true"_s) << code(u"false"_s);
    }
    const Range& range = entry.field.range;
    const bool low = std::isfinite(range.min);
    const bool high = std::isfinite(range.max);
    if (low && high && !range.min_open) {
        parts << numberText(range.min) + u" … "_s + numberText(range.max);
    } else {
        if (low) {
            parts << (range.min_open ? u"> "_s : u"≥ "_s) + numberText(range.min);
        }
        if (high) {
            parts << u"≤ "_s + numberText(range.max);
        }
    }
    if (!entry.word.empty()) {
        parts << code(u'"' + plain(entry.word) + u'"');
    }
    return parts.join(u", "_s);
}

QString usual(const FieldEntry& entry) {
    if (const double* number = std::get_if<double>(&entry.usual)) {
        return numberText(*number);
    }
    if (const bool* flag = std::get_if<bool>(&entry.usual)) {
        return code(*flag ? u"true"_s : u"false"_s);
    }
    if (const int* index = std::get_if<int>(&entry.usual)) {
        return entry.kind == FieldKind::choice
                   ? code(u'"' + plain(entry.field.words[static_cast<std::size_t>(*index)].word) +
                          u'"')
                   : QString::number(*index);
    }
    return {};
}

QString meaning(const FieldEntry& entry) {
    const QString name = fieldName(entry.field);
    const QString hint = fieldHint(entry.field);
    QString text = name.isEmpty() || hint.isEmpty() ? name + hint : name + u". "_s + hint;
    return text.replace(u'|', u"\\|"_s);
}

QString keyCell(const FieldEntry& entry, const HelpPage& page) {
    QString text = code(keyOf(entry)) + (entry.required ? u" *"_s : QString());
    for (const std::string& key : entry.alternatives) {
        if (!entry.pointer.ends_with('/' + key)) {
            text += u' ' + page.either + u' ' + code(QString::fromStdString(key));
        }
    }
    return text;
}

/// The table of a scene, in the language that is set.
QStringList tableOf(const std::vector<FieldEntry>& entries, const HelpPage& page) {
    QStringList lines{page.head, u"|---|---|---|---|"_s};
    QSet<QString> listed;
    for (const FieldEntry& entry : entries) {
        if (listed.contains(keyOf(entry))) {
            continue;  // of an object that may be a name instead
        }
        listed << keyOf(entry);
        EXPECT_FALSE(meaning(entry).isEmpty()) << "nothing is said of " << entry.pointer;
        lines << u"| "_s + keyCell(entry, page) + u" | "_s + meaning(entry) + u" | "_s +
                     allowed(entry) + u" | "_s + usual(entry) + u" |"_s;
    }
    return lines;
}

/// Where the first table below a heading begins and ends; nothing before the next scene's heading.
std::pair<qsizetype, qsizetype> tablePlace(const QStringList& lines, const QString& heading) {
    const qsizetype above = lines.indexOf(heading);
    qsizetype begin = above + 1;
    while (above >= 0 && begin < lines.size() && !lines[begin].startsWith(u'|')) {
        if (lines[begin].startsWith(u"## "_s)) {
            return {-1, -1};
        }
        ++begin;
    }
    qsizetype end = begin;
    while (end < lines.size() && lines[end].startsWith(u'|')) {
        ++end;
    }
    return above < 0 || begin == end ? std::pair<qsizetype, qsizetype>{-1, -1}
                                     : std::pair{begin, end};
}

class HelpTables : public ::testing::TestWithParam<HelpPage> {
  protected:
    ~HelpTables() override { installLanguage(u"en"_s); }
};

TEST_P(HelpTables, AreWhatTheFieldsSay) {
    const HelpPage& page = GetParam();
    installLanguage(page.language);
    QFile file(QStringLiteral(RAVNOVES_SOURCE "/resources/help/") + page.file);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n');
    file.close();
    const bool renew = qEnvironmentVariableIsSet("RAVNOVES_UPDATE_HELP");
    std::vector<std::pair<QString, std::vector<FieldEntry>>> tables;
    for (const SceneInfo& scene : sceneList()) {
        const std::unique_ptr<ScenePage> made(scene.make(nullptr, nullptr));
        if (made->model() != nullptr && !made->model()->describedFields().empty()) {
            tables.emplace_back(scene.name, made->model()->describedFields());
        }
    }
    // The window shows its cases as jobs of the workshop; those of bob-weights have its keys.
    tables.emplace_back(u"v8-plugs"_s, describe_fields<workshop::PlugsCase>());
    for (const auto& [scene, fields] : tables) {
        const QString heading = page.heading.arg(scene);
        if (renew && !lines.contains(heading)) {
            lines << heading << QString() << page.head << QString();
        }
        const auto [begin, end] = tablePlace(lines, heading);
        ASSERT_GE(begin, 0) << "no table of " << scene.toStdString() << " in "
                            << page.file.toStdString();
        const QStringList wanted = tableOf(fields, page);
        if (renew) {
            lines = lines.mid(0, begin) + wanted + lines.mid(end);
            continue;
        }
        const QStringList found = lines.mid(begin, end - begin);
        EXPECT_EQ(found.size(), wanted.size()) << scene.toStdString();
        for (qsizetype i = 0; i < std::min(found.size(), wanted.size()); ++i) {
            EXPECT_EQ(found[i].toStdString(), wanted[i].toStdString())
                << "renew with the target update-help";
        }
    }
    EXPECT_EQ(tables.size(), scene_solvers().size() - 1);
    if (renew) {
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(lines.join(u'\n').toUtf8());
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, HelpTables, ::testing::ValuesIn(helpPages()),
                         [](const auto& page) { return page.param.language.toStdString(); });

}  // namespace
}  // namespace ravnoves
