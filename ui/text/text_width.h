#pragma once

#include <QFont>
#include <QString>

namespace ravnoves {

/// How wide a text is, pixels. Each is measured once: to lay a text out takes longer than to paint
/// it. All digits are of one width, so that a drag's numbers have been measured before.
qreal textWidth(const QFont& font, const QString& text);

}  // namespace ravnoves
