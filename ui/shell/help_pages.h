#pragma once

#include <QString>
#include <QStringList>

class QTextDocument;

namespace ravnoves {

/// The pages of the help by their names: the scenes' pages, then the others.
QStringList helpTopics();

/// Puts a page of resources/help into a document: Markdown, in the present language where there is
/// one (TOPIC.LANG.md), else English (TOPIC.md), set with room between paragraphs.
/// @return false without one
bool loadHelp(const QString& topic, QTextDocument* document);
/// Its first heading.
QString helpTitle(const QString& topic);

}  // namespace ravnoves
