#pragma once

#include <sys/resource.h>

#include <csignal>

namespace ravnoves::test {

/// While it lives, no file of this process becomes longer, as on a full disk.
class FullDisk {
  public:
    /// @param room  bytes that a file may still have
    explicit FullDisk(rlim_t room = 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit none{room, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &none);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

  private:
    rlimit before_{};
};

}  // namespace ravnoves::test
