#pragma once

#include <cstddef>
#include <future>
#include <vector>

namespace ravnoves::studies {

/// Calls work(0), work(1), … at once, the first in the thread that calls, and returns when all have
/// ended. What one throws is thrown again then. For what the machine gives no thread, that thread
/// does the work in the end.
template <typename Work>
void run_workers(std::size_t count, const Work& work) {
    std::vector<std::future<void>> others;
    for (std::size_t worker = 1; worker < count; ++worker) {
        others.push_back(std::async(work, worker));
    }
    work(0);
    for (std::future<void>& other : others) {
        other.get();
    }
}

}  // namespace ravnoves::studies
