#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "case-file/json.h"
#include "temporary_folder.h"

namespace ravnoves::test {

namespace fs = std::filesystem;

inline std::string read_all(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

struct Outcome {
    int status = -1;
    std::string out;
    std::string err;
};

/// The command line as a user or a script runs it, in a folder of the test's own.
class CommandLine : public ::testing::Test {
  protected:
    /// Runs `ravnoves-cli ARGUMENTS` by a shell in the test's folder.
    /// @param before  shell commands or words before the program
    Outcome run(const std::string& arguments, const std::string& input = "",
                const std::string& before = "") const {
        const fs::path in = folder / "stdin";
        const fs::path out = folder / "stdout";
        const fs::path err = folder / "stderr";
        std::ofstream(in, std::ios::binary) << input;
        // In braces, so that arguments may hold a pipe or a redirection of their own.
        const std::string command = "cd '" + folder.string() + "' && { " + before +
                                    "'" RAVNOVES_CLI "' " + arguments +
                                    "; } <stdin 2>stderr >stdout";
        fs::remove(out);
        const int raw = std::system(command.c_str());  // NOLINT(cert-env33-c)
        Outcome outcome;
        outcome.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
        outcome.out = read_all(out);
        outcome.err = read_all(err);
        return outcome;
    }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    }

    /// The document of an example case.
    static Json example() {
        return Json::parse(read_all(fs::path(RAVNOVES_EXAMPLES) / "tmz-650d.case.json"));
    }

    /// One line on standard error that starts with the file, nothing on standard output, status 2.
    static void expect_rejected(const Outcome& outcome, const std::string& start) {
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
        EXPECT_EQ(outcome.err.substr(0, start.size()), start) << outcome.err;
    }

    const TemporaryFolder temporary;
    const fs::path folder = temporary.path();
};

}  // namespace ravnoves::test
