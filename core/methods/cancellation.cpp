#include "methods/cancellation.h"

#include <chrono>
#include <utility>

namespace ravnoves::methods {

namespace {

using Clock = std::chrono::steady_clock;

struct Asked {
    std::function<bool()> goes_on;
    Clock::time_point last;
};

Asked& asked() {
    static thread_local Asked state;
    return state;
}

}  // namespace

CancelScope::CancelScope(std::function<bool()> goes_on) {
    asked() = {std::move(goes_on), Clock::now()};
}

CancelScope::~CancelScope() {
    asked().goes_on = nullptr;
}

void check_cancelled() {
    Asked& state = asked();
    if (!state.goes_on) {
        return;
    }
    constexpr std::chrono::milliseconds pause(20);
    const auto now = Clock::now();
    if (now - state.last < pause) {
        return;
    }
    state.last = now;
    if (!state.goes_on()) {
        throw Cancelled{};
    }
}

}  // namespace ravnoves::methods
