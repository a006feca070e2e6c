#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QtSerialPort/QSerialPort>

#include "shop/scale_line.h"
#include "workshop/model/scale_settings.h"

namespace ravnoves {

/// Listens to the scale at a serial port. A port that is not there, or goes away in the middle, is
/// looked for again every second until it is back.
class ScaleReader : public QObject {
    Q_OBJECT

  public:
    explicit ScaleReader(QObject* parent = nullptr);

    /// Takes a scale in the place of that before; without a port none.
    void use(const ScaleSettings& settings);
    const ScaleSettings& settings() const { return settings_; }

    bool isConnected() const { return port_.isOpen(); }
    /// Why it is not connected, in words; empty where it is, or shall not be.
    QString trouble() const { return trouble_; }

  Q_SIGNALS:
    /// It was connected or has gone: isConnected() and trouble() say which.
    void connectionChanged();
    /// A line as it came, whatever it is.
    void lineRead(const QByteArray& raw, const ravnoves::shop::ScaleLine& line);
    /// A weight that counts: stable, and of Print or of a part that was not weighed yet.
    void weighed(const ravnoves::shop::ScaleLine& line);
    /// The same weight again, sooner than a part is changed: it is not taken.
    void repeated(const ravnoves::shop::ScaleLine& line);

  private:
    void open();
    void lose(QSerialPort::SerialPortError error);
    void read();
    void take(const std::string& raw);
    bool isTaken(const shop::ScaleLine& line);
    QString reason(QSerialPort::SerialPortError error) const;

    ScaleSettings settings_;
    QSerialPort port_;
    QTimer retry_;
    QTimer half_;  ///< gives up what has begun and does not go on
    QString trouble_;
    bool wasConnected_ = false;
    shop::ScaleLines lines_;
    shop::ScaleLine::Form form_ = shop::ScaleLine::Form::number;
    shop::PartByPart parts_;
    QElapsedTimer sinceLast_;
    double last_ = 0.0;  ///< kg
};

}  // namespace ravnoves
