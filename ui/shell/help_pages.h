#pragma once

#include <QString>
#include <QStringList>
#include <vector>

class QTextDocument;

namespace ravnoves {

/// The pages of the help by their names: those of the scenes, then the others.
QStringList helpTopics();

/// Puts a page of resources/help into a document: Markdown, in the present language where there is
/// one (TOPIC.LANG.md), else English (TOPIC.md), set with room between paragraphs.
/// @return false where there is none
bool loadHelp(const QString& topic, QTextDocument* document);
/// Its first heading.
QString helpTitle(const QTextDocument& document);

/// A place in a page that holds what was looked for.
struct HelpHit {
    int position;     ///< in the document
    int length;       ///< of what was found
    QString context;  ///< some words around it, on one line
};

/// Where a document holds the words: each place where they stand as typed, or each paragraph that
/// holds all of them. Case does not matter.
std::vector<HelpHit> findInHelp(const QTextDocument& document, const QString& words);

}  // namespace ravnoves
