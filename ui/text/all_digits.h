#pragma once

namespace ravnoves {

/// While one lives, numbers are written with all the digits they have: for texts that nobody sees,
/// but that are read back and compared.
class AllDigits {
  public:
    AllDigits() { ++count(); }
    ~AllDigits() { --count(); }
    AllDigits(const AllDigits&) = delete;
    AllDigits& operator=(const AllDigits&) = delete;

    static bool areWanted() { return count() > 0; }

  private:
    static int& count() {
        thread_local int alive = 0;
        return alive;
    }
};

}  // namespace ravnoves
