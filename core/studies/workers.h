#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <vector>

namespace ravnoves::studies {

/// Sees how much of some work is done, 0…1, and may stop it by false; may be empty.
using KeepGoing = std::function<bool(double done)>;

/// The progress of work that several workers share.
class Progress {
  public:
    /// @param keep_going  must outlive this
    /// @param total       steps of the whole work
    Progress(const KeepGoing& keep_going, std::uint64_t total)
        : keep_going_(keep_going), total_(static_cast<double>(total)) {}

    /// After a step of a worker; the first one tells of all steps now and then, in its thread.
    /// @return false where the work is to stop
    bool step(std::size_t worker) {
        constexpr auto often = std::chrono::milliseconds(50);
        const auto done = static_cast<double>(++done_);
        if (worker == 0 && keep_going_ && Clock::now() - told_ > often) {
            told_ = Clock::now();
            stopped_ = !keep_going_(done / total_);
        }
        return !stopped_;
    }
    bool is_stopped() const { return stopped_; }

  private:
    using Clock = std::chrono::steady_clock;

    const KeepGoing& keep_going_;
    double total_;
    std::atomic<std::uint64_t> done_{0};
    std::atomic<bool> stopped_{false};
    Clock::time_point told_ = Clock::now();
};

/// Calls work(worker, i) for each i below count until one returns false: each worker takes the next
/// free one. The first worker is the thread that calls, which does the work of those for
/// which the machine gives no thread. What one throws is thrown again when all have ended.
template <typename Work>
void share_out(std::size_t workers, std::uint64_t count, const Work& work) {
    std::atomic<std::uint64_t> next{0};
    std::atomic<bool> stopped{false};
    const auto take = [&](std::size_t worker) {
        for (std::uint64_t i = next++; i < count && !stopped; i = next++) {
            if (!work(worker, i)) {
                stopped = true;
            }
        }
    };
    std::vector<std::future<void>> others;
    for (std::size_t worker = 1; worker < workers; ++worker) {
        others.push_back(std::async(take, worker));
    }
    take(0);
    for (std::future<void>& other : others) {
        other.get();
    }
}

}  // namespace ravnoves::studies
