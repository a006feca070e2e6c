#include "case-file/text_file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "case-file/input_error.h"

namespace ravnoves {

namespace {

constexpr std::size_t largest_text = 64U << 20U;  ///< bytes

/// What the operating system says of a file, by its errno: "No space left on device". The common
/// ones are translated, the others as the system has them.
Message system_fault(int error) {
    struct Fault {
        int error;
        Text text;
    };
    static constexpr Fault faults[] = {
        {ENOENT, Text::tr("No such file or directory")},
        {EACCES, Text::tr("Permission denied")},
        {EPERM, Text::tr("Operation not permitted")},
        {ENOSPC, Text::tr("No space left on device")},
        {EDQUOT, Text::tr("Disk quota exceeded")},
        {EROFS, Text::tr("Read-only file system")},
        {EISDIR, Text::tr("Is a directory")},
        {ENOTDIR, Text::tr("Not a directory")},
        {ENAMETOOLONG, Text::tr("File name too long")},
        {EFBIG, Text::tr("File too large")},
        {EBUSY, Text::tr("Device or resource busy")},
        {ELOOP, Text::tr("Too many levels of symbolic links")},
        {EMFILE, Text::tr("Too many open files")},
        {EIO, Text::tr("Input/output error")},
    };
    for (const Fault& fault : faults) {
        if (fault.error == error) {
            return fault.text;
        }
    }
    return std::strerror(error);
}

InputError not_written() {
    return {"", {Text::tr("cannot be written: %1"), system_fault(errno)}};
}

InputError not_read() {
    return {"", {Text::tr("cannot be read: %1"), system_fault(errno)}};
}

constexpr std::size_t block_size = 1U << 16U;

struct Descriptor {
    explicit Descriptor(int it) : number(it) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) {
            ::close(number);
        }
    }
    int number;
};

/// The next bytes; 0 at the end.
/// @param waits  for those of a pipe that somebody made non-blocking
std::size_t read_some(int descriptor, std::vector<char>& block, bool waits = true) {
    while (true) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count >= 0) {
            return static_cast<std::size_t>(count);
        }
        if (errno == EAGAIN || errno == EWOULDBLOCK) {
            if (!waits) {
                throw InputError("", not_a_file);
            }
            pollfd wait{descriptor, POLLIN, 0};
            ::poll(&wait, 1, -1);
        } else if (errno != EINTR) {
            throw not_read();
        }
    }
}

/// All that comes.
/// @param waits  as of read_some()
std::string read_all(int descriptor, bool waits) {
    std::string text;
    std::vector<char> block(block_size);
    while (const std::size_t count = read_some(descriptor, block, waits)) {
        check_text_size(text.size() + count);
        text.append(block.data(), count);
    }
    return text;
}

void write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(descriptor, text.data(), text.size());
        if (count >= 0) {
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            pollfd wait{descriptor, POLLOUT, 0};
            ::poll(&wait, 1, -1);
        } else if (errno != EINTR) {
            throw not_written();
        }
    }
}

/// While it lives, what asks the program to end waits: no half of a file stays behind.
class SignalsWait {
  public:
    SignalsWait() {
        sigset_t ends;
        sigemptyset(&ends);
        for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
            sigaddset(&ends, each);
        }
        ::pthread_sigmask(SIG_BLOCK, &ends, &before_);
    }
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;
    ~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

/// A new file beside the target under a name that nothing has, also no link that somebody planted
/// there.
int make_beside(const std::filesystem::path& target, std::filesystem::path& partial) {
    constexpr int tries = 1000;
    for (int i = 0; i < tries; ++i) {
        partial = target.parent_path() /
                  ("." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".part");
        const int file =
            ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file >= 0) {
            return file;
        }
        if (errno != EEXIST) {
            break;
        }
    }
    throw not_written();
}

/// The bytes are on the disk before their name is, and the name before this returns.
void replace_file(const std::filesystem::path& target, std::string_view text) {
    struct stat old {};
    const bool is_there = ::stat(target.c_str(), &old) == 0;
    constexpr mode_t anybody_writes = S_IWUSR | S_IWGRP | S_IWOTH;
    if (is_there && ((old.st_mode & anybody_writes) == 0 || ::access(target.c_str(), W_OK) != 0)) {
        throw InputError("", Text::tr("is read-only and was not changed"));
    }
    const SignalsWait wait;
    std::filesystem::path partial;
    const Descriptor file(make_beside(target, partial));
    try {
        if (is_there) {
            // Its rights, and as far as that is allowed its owner.
            [[maybe_unused]] const int owned = ::fchown(file.number, old.st_uid, old.st_gid);
            if (::fchmod(file.number, old.st_mode & 07777U) != 0) {
                throw not_written();
            }
        }
        write_all(file.number, text);
        if (::fsync(file.number) != 0 || ::rename(partial.c_str(), target.c_str()) != 0) {
            throw not_written();
        }
    } catch (...) {
        ::unlink(partial.c_str());
        throw;
    }
    const std::filesystem::path folder =
        target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
    const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.number >= 0) {
        ::fsync(directory.number);  // some file systems have no such thing
    }
}

}  // namespace

void check_text_size(std::size_t bytes) {
    if (bytes > largest_text) {
        throw InputError("", Text::tr("must be at most 64 MiB"));
    }
}

std::string read_text_file(const std::filesystem::path& path) {
    // Non-blocking: opening a pipe that nobody writes to would wait for ever.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat status {};
    if (file.number < 0 || ::fstat(file.number, &status) != 0) {
        // A socket cannot be opened at all.
        if (errno == ENXIO) {
            throw InputError("", not_a_file);
        }
        throw not_read();
    }
    if (S_ISDIR(status.st_mode)) {
        throw InputError("", Text::tr("must be a file, not a folder"));
    }
    if (!S_ISREG(status.st_mode)) {
        throw InputError("", not_a_file);
    }
    // Some files of the system never end, or make one wait for what comes: they say so.
    return read_all(file.number, false);
}

std::string read_text(int descriptor) {
    return read_all(descriptor, true);
}

LineReader::LineReader(int descriptor) : descriptor_(descriptor), block_(block_size) {}

bool LineReader::next(std::string& line) {
    line.clear();
    bool any = false;
    fault_ = nullptr;
    while (true) {
        if (at_ == end_) {
            at_ = 0;
            end_ = read_some(descriptor_, block_);
            if (end_ == 0) {
                break;
            }
        }
        any = true;
        const char* const begin = block_.data() + at_;
        const auto* const feed = static_cast<const char*>(std::memchr(begin, '\n', end_ - at_));
        const std::size_t count =
            feed != nullptr ? static_cast<std::size_t>(feed - begin) : end_ - at_;
        try {
            if (!fault_) {
                check_text_size(line.size() + count);
                line.append(begin, count);
            }
        } catch (...) {
            fault_ = std::current_exception();
            std::string().swap(line);
        }
        at_ += count;
        if (feed != nullptr) {
            ++at_;
            break;
        }
    }
    if (any) {
        ++number_;
    }
    return any;
}

void LineReader::check_kept() const {
    if (fault_) {
        std::rethrow_exception(fault_);
    }
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    std::error_code error;
    // What a link points to is replaced, never the link: as root, /dev/stdout would be a file then.
    std::filesystem::path target = path;
    bool in_place =
        std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
    if (!in_place && std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) {
        target = std::filesystem::canonical(path, error);
        in_place = static_cast<bool>(error);  // a link to nothing yet
    }
    if (in_place) {
        // A device or a pipe has no place beside it: write straight through. Opening a pipe that
        // nobody reads would wait for ever.
        const int waits_not = std::filesystem::is_fifo(path, error) ? O_NONBLOCK : 0;
        const Descriptor device(::open(
            path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY | O_CLOEXEC | waits_not, 0666));
        if (device.number < 0) {
            if (waits_not != 0 && errno == ENXIO) {
                throw InputError("", Text::tr("is a pipe without a reader"));
            }
            throw not_written();
        }
        write_all(device.number, text);
        return;
    }
    replace_file(target, text);
}

}  // namespace ravnoves
