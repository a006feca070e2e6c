#pragma once

#include <QObject>

namespace ravnoves {

/// Whether pages show what the tolerances of their case do: one for the program, kept for the next
/// start.
class ToleranceSwitch : public QObject {
    Q_OBJECT

  public:
    static ToleranceSwitch& instance();

    bool isOn() const { return on_; }
    void setOn(bool on);

  Q_SIGNALS:
    void changed(bool on);

  private:
    ToleranceSwitch();

    bool on_;
};

}  // namespace ravnoves
