// What a scale sends, cut anywhere: a weight that was read is a finite number.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "shop/scale_line.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ravnoves::shop;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    ScaleLines lines;
    const std::size_t step = size == 0 ? 1 : 1 + data[0] % 16;
    for (std::size_t at = 0; at < size; at += step) {
        lines.add(bytes.substr(at, step));
        for (std::string line; lines.next(line);) {
            const ScaleLine read = parse_scale_line(line);
            if (!std::isfinite(read.mass()) || !std::isfinite(read.last_digit())) {
                std::abort();
            }
        }
    }
    return 0;
}
