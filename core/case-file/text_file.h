#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ravnoves {

/// The whole file as bytes.
/// @throws InputError where it cannot be read or is larger than 64 MiB
std::string read_text_file(const std::filesystem::path& path);
/// Writes beside the target, then renames: a file already there stays whole when anything fails.
/// A link is followed, a device or a pipe written straight through.
/// @throws InputError where the place cannot be written
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace ravnoves
