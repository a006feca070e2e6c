// Lines of a batch, through a pipe: every line comes out whole, in its order.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include "case-file/text_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    int ends[2];
    if (pipe(ends) != 0) {
        std::abort();
    }
    std::thread writer([&] {
        for (std::size_t at = 0; at < size;) {
            const ssize_t written =
                write(ends[1], data + at, std::min<std::size_t>(size - at, 999));
            if (written <= 0) {
                std::abort();
            }
            at += static_cast<std::size_t>(written);
        }
        close(ends[1]);
    });
    ravnoves::LineReader lines(ends[0]);
    std::string joined, line;
    while (lines.next(line)) {
        joined += line + '\n';
    }
    writer.join();
    close(ends[0]);
    std::string expected(text);
    if (!expected.empty() && expected.back() != '\n') {
        expected += '\n';
    }
    if (joined != expected || lines.number() != std::count(joined.begin(), joined.end(), '\n')) {
        std::abort();
    }
    return 0;
}
