#include "output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "case-file/input_error.h"
#include "case-file/object_reader.h"
#include "case-file/text_file.h"

namespace ravnoves::cli {

std::string one_line(const std::string& text) {
    return printable(text, std::string::npos);
}

int complain(const std::string& file, const std::string& text) {
    std::cerr << one_line(file.empty() ? text : file + ": " + text) << '\n';
    return exit_bad_input;
}

namespace {

int end_of_output() {
    std::cout << std::flush;
    if (!std::cout) {
        return complain("ravnoves-cli",
                        std::string("standard output cannot be written: ") + std::strerror(errno));
    }
    return exit_done;
}

}  // namespace

int print(const std::string& text) {
    std::cout << text;
    return end_of_output();
}

int write_file(const std::string& path, const std::string& text) {
    if (path.empty()) {
        return print(text);
    }
    try {
        write_text_file(path, text);
    } catch (const InputError& error) {
        return complain(path, error.what());
    }
    return exit_done;
}

bool can_write_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        complain(path, "must be a file, not a folder");
        return false;
    }
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
        return true;  // a device or a pipe
    }
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) {
        folder = ".";
    }
    // Files are written beside their place first, so the folder is what counts.
    if (!std::filesystem::is_directory(folder, error) || ::access(folder.c_str(), W_OK) != 0) {
        const std::string reason =
            std::filesystem::exists(folder, error) ? std::strerror(errno) : "no such folder";
        complain(path, "cannot be written: " + reason);
        return false;
    }
    return true;
}

std::string names_a_file(const std::string& path) {
    return path.empty() ? "must name a file" : "";
}

}  // namespace ravnoves::cli
