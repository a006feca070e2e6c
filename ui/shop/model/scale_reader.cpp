#include "shop/model/scale_reader.h"

#include <cmath>
#include <utility>

namespace ravnoves {

using namespace std::chrono_literals;
using shop::ScaleLine;

namespace {

constexpr auto retryAfter = 1s;
/// A line comes in one go, even at 300 baud.
constexpr auto longestPause = 500ms;
/// No part is changed as fast: the same weight so soon again is Print pressed twice. Another one is
/// another part, unless it comes as fast as nobody presses a key: the scale sends all the time.
constexpr int fastestChange = 1500;  // ms
constexpr int fastestPrint = 400;    // ms
constexpr double wander = 3.5;       // last digits that a weight sent all the time may differ by

}  // namespace

QString shownLine(const QByteArray& raw) {
    QString shown;
    for (const char byte : raw) {
        const auto code = static_cast<unsigned char>(byte);
        const bool isPrintable = code >= 0x20 && code < 0x7F;
        shown += isPrintable ? QString(QLatin1Char(byte))
                             : QStringLiteral("‹%1›").arg(code, 2, 16, QLatin1Char('0'));
    }
    return shown;
}

ScaleReader::ScaleReader(QObject* parent) : QObject(parent) {
    retry_.setInterval(retryAfter);
    half_.setInterval(longestPause);
    half_.setSingleShot(true);
    connect(&retry_, &QTimer::timeout, this, &ScaleReader::open);
    connect(&half_, &QTimer::timeout, this, [this] {
        if (lines_.is_half()) {
            // Said as it is, not read: half a number is another number.
            rejection_.clear();
            Q_EMIT lineRead(QByteArray::fromStdString(lines_.drop()), {});
        }
    });
    connect(&port_, &QSerialPort::readyRead, this, &ScaleReader::read);
    connect(&port_, &QSerialPort::errorOccurred, this, [this](QSerialPort::SerialPortError error) {
        if (error == QSerialPort::ResourceError || error == QSerialPort::ReadError) {
            lose();
        }
    });
}

void ScaleReader::use(const ScaleSettings& settings) {
    const bool sameWay = settings.port == settings_.port && settings.baud == settings_.baud &&
                         settings.parity == settings_.parity;
    settings_ = settings;
    forgetForm();
    if (sameWay) {
        return;
    }
    retry_.stop();
    port_.close();
    lines_.drop();
    trouble_.clear();
    wasConnected_ = false;
    if (settings_.port.isEmpty()) {
        Q_EMIT connectionChanged();
    } else {
        open();
    }
}

void ScaleReader::open() {
    port_.setPortName(settings_.port);
    port_.setBaudRate(settings_.baud);
    if (!port_.open(QIODevice::ReadOnly)) {
        retry_.start();
        const QString why = wasConnected_ ? trouble_ : reason(port_.error());
        if (why != trouble_ || why.isEmpty()) {
            trouble_ = why;
            Q_EMIT connectionChanged();
        }
        return;
    }
    // A port that cannot do it sends as it can: what comes shows whether it is understood.
    const bool isSeven =
        settings_.parity == ScaleSettings::Even7 || settings_.parity == ScaleSettings::Odd7;
    const bool isOdd =
        settings_.parity == ScaleSettings::Odd7 || settings_.parity == ScaleSettings::Odd8;
    port_.setDataBits(isSeven ? QSerialPort::Data7 : QSerialPort::Data8);
    port_.setParity(settings_.parity == ScaleSettings::None8 ? QSerialPort::NoParity
                    : isOdd                                  ? QSerialPort::OddParity
                                                             : QSerialPort::EvenParity);
    retry_.stop();
    wasConnected_ = true;
    trouble_.clear();
    Q_EMIT connectionChanged();
}

void ScaleReader::lose() {
    if (!port_.isOpen()) {
        return;
    }
    half_.stop();
    hasTail_ = lines_.is_half();
    lines_.drop();  // what had begun does not go on after it
    if (!hasTail_) {
        forgetForm();
    }
    trouble_ = tr("The scale was unplugged. It reconnects automatically.");
    // Not in its own signal.
    QMetaObject::invokeMethod(
        &port_, [this] { port_.close(); }, Qt::QueuedConnection);
    retry_.start();
    QMetaObject::invokeMethod(this, &ScaleReader::connectionChanged, Qt::QueuedConnection);
}

/// Another scale may be plugged in.
void ScaleReader::forgetForm() {
    form_ = ScaleLine::Form::number;
    fullest_.clear();
    parts_ = {};
    hasTail_ = false;
}

QString ScaleReader::reason(QSerialPort::SerialPortError error) const {
    switch (error) {
        case QSerialPort::DeviceNotFoundError:
            return tr("%1 does not exist: check that the scale is plugged in.").arg(settings_.port);
        case QSerialPort::PermissionError:
            return tr("%1 cannot be opened: another program uses it, or you are not in the group "
                      "dialout.")
                .arg(settings_.port);
        default:
            return tr("%1 cannot be opened: %2").arg(settings_.port, port_.errorString());
    }
}

void ScaleReader::read() {
    const QByteArray bytes = port_.readAll();
    lines_.add({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    for (std::string line; lines_.next(line);) {
        take(line);
    }
    lines_.is_half() ? half_.start() : half_.stop();
}

void ScaleReader::take(const std::string& raw) {
    ScaleLine line = shop::parse_scale_line(raw, settings_.unit());
    // One scale has one form: what says less of itself than the lines before is not whole.
    rejection_.clear();
    const QByteArray bytes = QByteArray::fromStdString(raw);
    if (line.has_weight() && line.form < form_) {
        line.kind = ScaleLine::Kind::garbled;
        rejection_ =
            tr("Expected lines such as “%1”, got “%2”. For another scale open Edit ▸ Scale….")
                .arg(shownLine(fullest_), shownLine(bytes));
    } else if (line.has_weight()) {
        form_ = line.form;
        fullest_ = bytes;
    }
    if (std::exchange(hasTail_, false) && !line.has_weight()) {
        forgetForm();  // that was the end of the lost line: what comes next is whole
    }
    Q_EMIT lineRead(bytes, line);
    if (isTaken(line)) {
        Q_EMIT weighed(line);
    }
}

bool ScaleReader::isTaken(const ScaleLine& line) {
    if (settings_.taking == ScaleSettings::EachPart) {
        return parts_.takes(line);
    }
    if (line.kind != ScaleLine::Kind::stable) {
        return false;
    }
    const double digits = std::abs(line.mass() - last_) / line.last_digit();
    const bool isRepeated =
        sinceLast_.isValid() && ((digits < 0.5 && sinceLast_.elapsed() < fastestChange) ||
                                 (digits < wander && sinceLast_.elapsed() < fastestPrint));
    sinceLast_.start();
    last_ = line.mass();
    if (isRepeated) {
        Q_EMIT repeated(line);
    }
    return !isRepeated;
}

}  // namespace ravnoves
