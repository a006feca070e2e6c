#include "case-file/text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "case-file/input_error.h"

namespace ravnoves {

namespace {

InputError not_written(const std::string& reason) {
    return {"", {CORE_TEXT("core", "cannot be written: %1"), reason}};
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path) {
    constexpr std::uintmax_t largest = 64U << 20U;
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw InputError("", CORE_TEXT("core", "must be a file, not a folder"));
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw InputError("", {CORE_TEXT("core", "cannot be read: %1"), std::strerror(errno)});
    }
    std::string text;
    std::vector<char> block(1U << 16U);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
           stream.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > largest) {
            throw InputError("", CORE_TEXT("core", "must be at most 64 MiB"));
        }
    }
    if (stream.bad()) {
        throw InputError("", CORE_TEXT("core", "cannot be read to its end"));
    }
    return text;
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
