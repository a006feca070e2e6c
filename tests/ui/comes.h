#pragma once

#include <QTest>

namespace ravnoves::test {

inline constexpr int patience = 60'000;  ///< ms: the machine may be busy

/// Waits until it holds, as long as a busy machine may take.
template <typename Holds>
bool comes(Holds holds) {
    return QTest::qWaitFor(holds, patience);
}

/// Brings a window to the front: without that keys are not its actions'.
template <typename Window>
bool becomesActive(Window& window) {
    window.activateWindow();
    return comes([&] { return window.isActiveWindow(); });
}

}  // namespace ravnoves::test
