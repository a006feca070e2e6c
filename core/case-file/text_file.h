#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/text.h"

namespace ravnoves {

inline constexpr Text not_a_file = Text::tr("must be a file, not a pipe or a device");

/// @throws InputError for a text of more than 64 MiB, which is not read again
void check_text_size(std::size_t bytes);

/// The whole file as bytes: the one way in which the programs read a file that they are given. What
/// might never end is rejected: a pipe, a device, a file of the system that makes one wait.
/// @throws InputError where it cannot be read, is no such file or is larger than 64 MiB
std::string read_text_file(const std::filesystem::path& path);
/// All that comes by an open file or pipe, however long it takes.
/// @throws InputError where nothing can be read, or it is larger than 64 MiB
std::string read_text(int descriptor);
/// Writes beside the target, then renames: a file already there stays whole when anything fails or
/// the machine stops, and nothing is left behind when a signal ends the program. A file that is
/// replaced keeps its rights, a read-only one stays. A link is followed; a device or a pipe is
/// written straight through.
/// @throws InputError where the place cannot be written
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// The lines of an open file or pipe, as bytes, one at a time. Of a line longer than 64 MiB, the
/// limit of a file, or for which there is no memory, nothing is kept.
class LineReader {
  public:
    explicit LineReader(int descriptor);
    /// The next line, without its line feed; false at the end.
    /// @throws InputError where nothing can be read: a folder, a closed descriptor
    bool next(std::string& line);
    /// @throws InputError where the last line was too long, std::bad_alloc where it needs more
    ///         memory than there is
    void check_kept() const;
    int number() const { return number_; }  ///< of the last line, from 1

  private:
    int descriptor_;
    std::vector<char> block_;
    std::size_t at_ = 0;   ///< start of the part of the block not yet handed out
    std::size_t end_ = 0;  ///< end of the part that was read
    int number_ = 0;
    std::exception_ptr fault_;  ///< why nothing of the last line is kept
};

}  // namespace ravnoves
