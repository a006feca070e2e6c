#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QtSerialPort/QSerialPort>

#include "shop/model/scale_settings.h"
#include "shop/scale_line.h"

namespace ravnoves {

/// A line of a scale as text: other bytes than printable ASCII as "‹02›".
QString shownLine(const QByteArray& raw);

/// Listens to the scale at a serial port. A missing port, also one unplugged later, is looked for
/// again every second until it is back.
class ScaleReader : public QObject {
    Q_OBJECT

  public:
    explicit ScaleReader(QObject* parent = nullptr);

    /// Takes a scale in the place of that before; without a port none. The same settings again
    /// listen to another scale at that port: the form of the lines before is forgotten.
    void use(const ScaleSettings& settings);
    const ScaleSettings& settings() const { return settings_; }

    bool isConnected() const { return port_.isOpen(); }
    /// Why it is not connected, as text; empty where it is, or shall not be.
    QString trouble() const { return trouble_; }
    /// Why the weight read last is not used: a line such as that before is awaited, which says more
    /// of itself. Empty where there is no such reason.
    const QString& rejection() const { return rejection_; }

  Q_SIGNALS:
    /// It was connected or removed: see isConnected() and trouble().
    void connectionChanged();
    /// A line as it came, whatever it is.
    void lineRead(const QByteArray& raw, const ravnoves::shop::ScaleLine& line);
    /// A weight that counts: stable, and of Print or of a part that was not weighed yet.
    void weighed(const ravnoves::shop::ScaleLine& line);
    /// The same weight again, sooner than a part is changed: it is not taken.
    void repeated(const ravnoves::shop::ScaleLine& line);

  private:
    void open();
    void lose();
    void read();
    void take(const std::string& raw);
    void forgetForm();
    bool isTaken(const shop::ScaleLine& line);
    QString reason(QSerialPort::SerialPortError error) const;

    ScaleSettings settings_;
    QSerialPort port_;
    QTimer retry_;
    QTimer half_;  ///< gives up what has begun and stops
    QString trouble_;
    bool wasConnected_ = false;
    shop::ScaleLines lines_;
    shop::ScaleLine::Form form_ = shop::ScaleLine::Form::number;
    QByteArray fullest_;  ///< the last line of form_
    QString rejection_;
    bool hasTail_ = false;  ///< the connection was lost within a line: its end may come first
    shop::PartByPart parts_;
    QElapsedTimer sinceLast_;
    double last_ = 0.0;  ///< kg
};

}  // namespace ravnoves
