#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ravnoves::studies {

/// Calls work(0), work(1), … at once, the first in the thread that calls, and returns when all have
/// ended. What one throws is thrown again then.
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
    for (std::size_t i = 1; i < count; ++i) {
        others.emplace_back(guarded, i);
    }
    guarded(0);
    for (std::thread& other : others) {
        other.join();
    }
    if (fault) {
        std::rethrow_exception(fault);
    }
}

}  // namespace ravnoves::studies
