#pragma once

#include <QString>

#include "shop/scale_line.h"

namespace ravnoves {

/// The scale as the user has set it up; kept for the next start.
struct ScaleSettings {
    QString port;  ///< name or path of the serial port; empty: no scale is connected
    int baud = 9600;
    enum Parity { None8, Even7, Odd7, Even8, Odd8 } parity = None8;  ///< with the bits of data
    enum UsualUnit { Gram, Kilogram, Ounce, Pound } usualUnit = Gram;
    /// When a weight is taken: at each line, which the Print key sends, or of a scale that sends
    /// all the time, once for each part.
    enum Taking { EachLine, EachPart } taking = EachLine;
    double resolution = 0.0;  ///< last digit d of its display, kg; 0: not known

    /// Of a number without a unit.
    const Unit& unit() const;

    static ScaleSettings load();
    void save() const;

    bool operator==(const ScaleSettings&) const = default;
};

}  // namespace ravnoves
