#pragma once

#include <QDBusVariant>
#include <QObject>
#include <QString>

namespace ravnoves {

/// Asks the desktop whether it is set to dark, and follows changes.
///
/// Qt 6.4 does not tell (QStyleHints::colorScheme came with 6.5), so the setting is read from the
/// desktop portal (org.freedesktop.appearance, color-scheme: 1 is dark). Without a session bus or a
/// portal nothing is ever emitted.
class DesktopColourScheme : public QObject {
    Q_OBJECT

  public:
    /// The answer comes later as darkChanged().
    explicit DesktopColourScheme(QObject* parent = nullptr);

  Q_SIGNALS:
    void darkChanged(bool dark);

  private Q_SLOTS:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

  private:
    void report(const QVariant& value);
};

}  // namespace ravnoves
