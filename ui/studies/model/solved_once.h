#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "studies/study_run.h"

namespace ravnoves {

/// Solves a problem unless it is one of the latest, whose answers are kept, so that a window that
/// is opened again or a report of the same case, with the same files, need not solve it again. In
/// any thread.
/// @param watched  how many of the watched values are asked for
/// @param solve    returns nothing where it was stopped
template <typename Found, typename Solve>
std::optional<Found> solvedOnce(const studies::Problem& problem, std::size_t watched,
                                const Solve& solve) {
    static std::mutex mutex;
    static std::deque<std::pair<std::pair<studies::Origin, std::size_t>, Found>> latest;
    constexpr std::size_t kept = 8;
    const std::pair asked(problem.origin, watched);
    {
        const std::lock_guard lock(mutex);
        for (const auto& [known, found] : latest) {
            if (known == asked) {
                return found;
            }
        }
    }
    std::optional<Found> found = solve();
    if (found) {
        const std::lock_guard lock(mutex);
        latest.emplace_back(asked, *found);
        if (latest.size() > kept) {
            latest.pop_front();
        }
    }
    return found;
}

}  // namespace ravnoves
