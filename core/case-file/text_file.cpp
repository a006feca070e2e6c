#include "case-file/text_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "case-file/input_error.h"

namespace ravnoves {

namespace {

InputError not_written(const std::string& reason) {
    return {"", {CORE_TEXT("core", "cannot be written: %1"), reason}};
}

InputError not_read() {
    return {"", {CORE_TEXT("core", "cannot be read: %1"), std::strerror(errno)}};
}

constexpr std::size_t block_size = 1U << 16U;
constexpr std::size_t largest_text = 64U << 20U;  // bytes
constexpr Text too_large = CORE_TEXT("core", "must be at most 64 MiB");
constexpr Text not_a_file = CORE_TEXT("core", "must be a file, not a pipe or a device");

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

/// Waits for the next bytes; 0 at the end.
std::size_t read_some(int descriptor, std::vector<char>& block) {
    while (true) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count >= 0) {
            return static_cast<std::size_t>(count);
        }
        if (errno == EAGAIN || errno == EWOULDBLOCK) {  // a pipe that somebody made so
            pollfd wait{descriptor, POLLIN, 0};
            ::poll(&wait, 1, -1);
        } else if (errno != EINTR) {
            throw not_read();
        }
    }
}

}  // namespace

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
        throw InputError("", CORE_TEXT("core", "must be a file, not a folder"));
    }
    if (!S_ISREG(status.st_mode)) {
        throw InputError("", not_a_file);
    }
    std::string text;
    std::vector<char> block(block_size);
    while (const std::size_t count = read_some(file.number, block)) {
        if (text.size() + count > largest_text) {
            throw InputError("", too_large);
        }
        text.append(block.data(), count);
    }
    return text;
}

LineReader::LineReader(int descriptor) : descriptor_(descriptor), block_(block_size) {}

bool LineReader::next(std::string& line) {
    line.clear();
    bool any = false;
    bool whole = true;
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
        whole = whole && line.size() + count <= largest_text;
        if (whole) {
            line.append(begin, count);
        } else {
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
    too_long_ = !whole;
    return any;
}

void LineReader::check_length() const {
    if (too_long_) {
        throw InputError("", too_large);
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
        // A device or a pipe has no place beside it: write straight through.
        std::ofstream stream(path, std::ios::binary);
        stream << text << std::flush;
        if (!stream) {
            throw not_written(std::strerror(errno));
        }
        return;
    }
    std::filesystem::path partial = target;
    partial += ".part" + std::to_string(::getpid());
    {
        std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
        stream << text << std::flush;
        if (!stream) {
            const std::string reason = std::strerror(errno);
            stream.close();
            std::filesystem::remove(partial, error);
            throw not_written(reason);
        }
    }
    std::filesystem::rename(partial, target, error);
    if (error) {
        const std::string reason = error.message();
        std::filesystem::remove(partial, error);
        throw not_written(reason);
    }
}

}  // namespace ravnoves
