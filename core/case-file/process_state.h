#pragma once

#include <fcntl.h>

#include <csignal>

namespace ravnoves {

/// What a program adopts from whoever starts it, before anything else.
inline void prepare_process() {
    // The next file would get a standard descriptor that is closed, and messages would go into it.
    // So to read or to write it fails, as if it was closed.
    for (int descriptor = 0; descriptor <= 2; ++descriptor) {
        if (::fcntl(descriptor, F_GETFD) < 0) {
            ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
        }
    }
    // A file that may not become larger is a fault of writing, after which nothing half-written
    // stays.
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace ravnoves
