#pragma once

#include <QImage>
#include <QString>

namespace ravnoves {

/// Whose card it is, set once.
struct Shop {
    QString name;
    QString logo;  ///< file of a picture

    static Shop kept();
    /// Of a file; null for any other. A picture that never ends is not waited for.
    static QImage read(const QString& file);
    /// With a copy of the picture, independent of its file.
    /// @return an empty string, or why it could not be copied
    QString keep() const;
    /// That the picture cannot be read; empty where it can, or without one.
    QString trouble() const;
};

}  // namespace ravnoves
