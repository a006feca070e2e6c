#include "shell/help_pages.h"

#include <QFile>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>

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

namespace {

QString markdown(const QString& topic) {
    QFile file(QStringLiteral(":/help/%1.%2.md").arg(topic, currentLanguage()));
    if (!file.exists()) {
        file.setFileName(QStringLiteral(":/help/%1.md").arg(topic));
    }
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

bool loadHelp(const QString& topic, QTextDocument* document) {
    const QString text = markdown(topic);
    document->clear();  // with its pictures, which are in the colours of the theme
    // Else tables are laid out again at each piece inserted.
    document->setLayoutEnabled(false);
    document->setMarkdown(text);
    layOut(document);
    document->setLayoutEnabled(true);
    return !text.isEmpty();
}

QString helpTitle(const QString& topic) {
    static const QRegularExpression heading(QStringLiteral("^#+ *"));
    return markdown(topic).section(QLatin1Char('\n'), 0, 0).remove(heading);
}

}  // namespace ravnoves
