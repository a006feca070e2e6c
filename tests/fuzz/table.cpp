// A table of torque or pressure as a file or a clipboard has it: read or rejected, and what was
// read reads back the same.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "balance-shaft/dead_centre.h"
#include "balance-shaft/table_reading.h"
#include "case-file/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ravnoves;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const auto table = balance_shaft::parse_cycle(balance_shaft::Measured::torque, text).table;
        if (!(balance_shaft::parse_cycle(balance_shaft::Measured::torque,
                                         balance_shaft::write_torque_table(table))
                  .table == table)) {
            std::abort();
        }
    } catch (const InputError&) {
        // rejected in words
    }
    try {
        const auto trace =
            balance_shaft::parse_cycle(balance_shaft::Measured::pressure, text).trace;
        balance_shaft::check_pressure_trace(trace, "");
    } catch (const InputError&) {
        // rejected in words
    }
    // As a case names the columns.
    for (const auto& [angle, value] :
         {std::pair("1", "0"), std::pair("0", "1"), std::pair("2", "1")}) {
        balance_shaft::TableReading reading;
        reading.columns = {angle, value};
        try {
            const auto table =
                balance_shaft::parse_cycle(balance_shaft::Measured::torque, text, reading).table;
            balance_shaft::check_torque_table(table, "");
        } catch (const InputError&) {
            // rejected in words
        }
    }
    for (const auto what : {balance_shaft::Measured::torque, balance_shaft::Measured::pressure}) {
        try {
            const auto proposal = balance_shaft::propose_reading(text, what);
            // What is proposed without a doubt about the rows is what the reader takes.
            if (proposal.reading.strokes && what == balance_shaft::Measured::pressure) {
                const auto trace = balance_shaft::parse_cycle(balance_shaft::Measured::pressure,
                                                              text, proposal.reading)
                                       .trace;
                balance_shaft::check_pressure_trace(trace, "");
                balance_shaft::find_dead_centre({0.046, 0.150, 0.0}, trace);
            }
        } catch (const InputError&) {
            // rejected in words
        }
    }
    return 0;
}
