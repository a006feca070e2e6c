#pragma once

#include <ctime>

namespace ravnoves::test {

/// What the processor has worked for this program since it was made: unlike time, the same however
/// busy the machine is.
class ProcessorTime {
  public:
    double seconds() const { return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

  private:
    std::clock_t begin_ = std::clock();
};

}  // namespace ravnoves::test
