#pragma once

#include <QString>
#include <QStringList>

class QTextDocument;

namespace ravnoves {

/// The pages of the help by their names: those of the scenes, then the others.
QStringList helpTopics();

/// Puts a page of resources/help into a document: Markdown, in the present language where there is
/// one (TOPIC.LANG.md), else English (TOPIC.md), set with room between paragraphs.
/// @return false where there is none
bool loadHelp(const QString& topic, QTextDocument* document);
/// Its first heading.
QString helpTitle(const QString& topic);

}  // namespace ravnoves
