#pragma once

#include <QCoreApplication>
#include <cstdio>
#include <cstdlib>

namespace ravnoves {

/// Ends the program, as a fuzzer wants it, where something does not hold.
inline void require(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "it does not hold: %s\n", what);
        std::abort();
    }
}

/// The application that models and journals need; the first call makes it.
inline void needApplication() {
    static int count = 1;
    static char name[] = "fuzz";
    static char* arguments[] = {name, nullptr};
    static const QCoreApplication application(count, arguments);
}

}  // namespace ravnoves
