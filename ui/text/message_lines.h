#pragma once

#include <QStringList>
#include <vector>

#include "text/message_text.h"

namespace ravnoves {

/// A line for each message.
inline QString messageLines(const std::vector<Message>& messages) {
    QStringList lines;
    for (const Message& message : messages) {
        lines << messageText(message);
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace ravnoves
