#pragma once

namespace ravnoves {

/// Keeps Qt from sharing the painting of small shapes among threads: to wake them takes longer than
/// to paint. To be called before the application is made.
void paintInOneThread();

}  // namespace ravnoves
