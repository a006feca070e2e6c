#include "shell/help_pages.h"

#include <QFile>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>
#include <algorithm>

#include "shell/scene_list.h"
#include "text/language.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

void layOutTables(QTextFrame* frame) {
    for (QTextFrame* child : frame->childFrames()) {
        if (auto* table = qobject_cast<QTextTable*>(child)) {
            QTextTableFormat format = table->format();
            format.setCellPadding(Theme::gap);
            format.setCellSpacing(0);
            format.setBorder(1);
            format.setBorderCollapse(true);
            format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            format.setBorderBrush(Theme::instance().border());
            format.setTopMargin(Theme::gap);
            format.setBottomMargin(Theme::margin);
            table->setFormat(format);
        }
        layOutTables(child);
    }
}

/// Room between paragraphs and lines; Markdown leaves that to who shows it.
void layOut(QTextDocument* document) {
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat format = block.blockFormat();
        format.setLineHeight(120, QTextBlockFormat::ProportionalHeight);
        if (cursor.currentTable() == nullptr) {
            const bool heading = format.headingLevel() > 0;
            const bool code = format.hasProperty(QTextFormat::BlockCodeFence) ||
                              format.hasProperty(QTextFormat::BlockCodeLanguage);
            const bool listGoesOn =
                block.textList() != nullptr && block.next().textList() == block.textList();
            format.setTopMargin(heading && block.blockNumber() > 0 ? 2 * Theme::margin : 0);
            format.setBottomMargin(heading      ? Theme::space
                                   : code       ? 0
                                   : listGoesOn ? Theme::gap
                                                : Theme::margin);
        }
        cursor.setBlockFormat(format);
    }
    layOutTables(document->rootFrame());
}

QString around(const QString& text, qsizetype at, qsizetype length) {
    constexpr qsizetype room = 40;
    qsizetype from = std::max<qsizetype>(at - room, 0);
    qsizetype to = std::min(at + length + room, text.size());
    if (from > 0) {
        from = std::min(text.indexOf(QLatin1Char(' '), from) + 1, at);
    }
    if (to < text.size()) {
        to = std::max(text.lastIndexOf(QLatin1Char(' '), to), at + length);
    }
    QString part = text.mid(from, to - from).simplified();
    part.remove(QChar::ObjectReplacementCharacter);
    return (from > 0 ? QStringLiteral("… ") : QString()) + part +
           (to < text.size() ? QStringLiteral(" …") : QString());
}

}  // namespace

QStringList helpTopics() {
    QStringList topics;
    for (const SceneInfo& info : sceneList()) {
        topics << info.name;
    }
    topics << QStringLiteral("case-files") << QStringLiteral("variants")
           << QStringLiteral("tolerances") << QStringLiteral("keys");
    return topics;
}

bool loadHelp(const QString& topic, QTextDocument* document) {
    QFile file(QStringLiteral(":/help/%1.%2.md").arg(topic, currentLanguage()));
    if (!file.exists()) {
        file.setFileName(QStringLiteral(":/help/%1.md").arg(topic));
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return false;
    }
    document->setMarkdown(QString::fromUtf8(file.readAll()));
    layOut(document);
    return true;
}

QString helpTitle(const QTextDocument& document) {
    return document.begin().text();
}

std::vector<HelpHit> findInHelp(const QTextDocument& document, const QString& words) {
    const QString phrase = words.simplified();
    std::vector<HelpHit> hits;
    if (phrase.isEmpty()) {
        return hits;
    }
    const QStringList each = phrase.split(QLatin1Char(' '));
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const QString text = block.text();
        const auto add = [&](qsizetype at, qsizetype length) {
            hits.push_back({block.position() + static_cast<int>(at), static_cast<int>(length),
                            around(text, at, length)});
        };
        qsizetype at = text.indexOf(phrase, 0, Qt::CaseInsensitive);
        if (at >= 0) {
            for (; at >= 0; at = text.indexOf(phrase, at + phrase.size(), Qt::CaseInsensitive)) {
                add(at, phrase.size());
            }
        } else if (std::all_of(each.begin(), each.end(), [&](const QString& word) {
                       return text.contains(word, Qt::CaseInsensitive);
                   })) {
            add(text.indexOf(each.constFirst(), 0, Qt::CaseInsensitive), each.constFirst().size());
        }
    }
    return hits;
}

}  // namespace ravnoves
