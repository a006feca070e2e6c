// A table of torque or pressure as a file or a clipboard has it: read or refused, and what was read
// reads back the same.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "balance-shaft/torque_table.h"
#include "case-file/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ravnoves;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const auto table = balance_shaft::parse_torque_table(text).table;
        if (!(balance_shaft::parse_torque_table(balance_shaft::write_torque_table(table)).table ==
              table)) {
            std::abort();
        }
    } catch (const InputError&) {
        // refused in words
    }
    try {
        balance_shaft::parse_pressure_trace(text);
    } catch (const InputError&) {
        // refused in words
    }
    return 0;
}
