#pragma once

#include <optional>

#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/input.h"
#include "case-file/message.h"

namespace ravnoves::balance_shaft {

/// Compression of a measured trace: p + p_zero = K (V + V_c)⁻ⁿ, 80° to 30° before the firing top
/// dead centre, where no valve or port is open and nothing burns yet.
struct CompressionFit {
    /// n with p_zero = 0 and V_c fitted (compression ratio 4…30): 1.25 to 1.42 for a sane trace.
    double exponent = 0.0;
    double residual = 0.0;  ///< RMS of ln p
    /// p_zero with n = 1.35 fixed: the difference of the trace from absolute pressure, Pa.
    double missing_pressure = 0.0;
};

/// Nothing where the trace is not positive there.
std::optional<CompressionFit> fit_compression(const CylinderGas& gas);

/// What looks wrong in a measured pressure trace, as a sentence; empty where nothing does: a peak
/// far from the firing top dead centre (phase), a pressure at bottom dead centre before compression
/// that is no such pressure (unit), a trace that lacks the atmosphere (gauge pressure), a
/// polytropic exponent of compression that no gas has (phase by a few degrees, zero of the
/// pressure). The first of them: the others would follow from it. Supercharged, throttled, motored
/// and two-stroke traces are sane.
///
/// A trace out of phase by 5° changes the exponent by about 0.15, gauge pressure makes it 1.7 to 3.
Message check_trace(const Input& input, const CylinderGas& gas);
/// That its rows about the peak are too far apart for peak and work; empty where they are not.
Message coarse_rows(const PressureTrace& trace);
/// Whether its peak is beside the top dead centre of the gas exchange.
bool peaks_a_turn_off(const Input& input, const IndicatedCycle& cycle);

}  // namespace ravnoves::balance_shaft
