#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ravnoves::studies {

/// Calls work(0), work(1), … at once, the first in the thread that calls, and returns when all have
/// ended. What one throws is thrown again then. For what the machine gives no thread, the caller's
/// does the work, after its own.
/// @param stop  called at once where one has thrown, so that the others end
template <typename Work, typename Stop>
void run_workers(std::size_t count, const Work& work, const Stop& stop) {
    std::exception_ptr fault;
    std::mutex guard;
    const auto guarded = [&](std::size_t worker) {
        try {
            work(worker);
        } catch (...) {
            const std::lock_guard lock(guard);
            fault = std::current_exception();
            stop();
        }
    };
    std::vector<std::thread> others;
    others.reserve(count);
    std::size_t started = 1;
    try {
        for (; started < count; ++started) {
            others.emplace_back(guarded, started);
        }
    } catch (const std::exception&) {
        // no memory for its stack, or as many threads as this user may have
    }
    guarded(0);
    for (; started < count; ++started) {
        guarded(started);
    }
    for (std::thread& other : others) {
        other.join();
    }
    if (fault) {
        std::rethrow_exception(fault);
    }
}

}  // namespace ravnoves::studies
