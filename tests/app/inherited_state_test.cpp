// What whoever starts the program leaves it: ignored signals, closed descriptors, rights of new
// files, limits. For each command.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <string>
#include <vector>

#include "case-file/json.h"
#include "command_line.h"

namespace ravnoves {
namespace {

namespace fs = std::filesystem;

using test::CommandLine;
using test::lines_of;
using test::Outcome;
using test::read_all;

class InheritedState : public CommandLine {
  protected:
    void write_cases() const {
        Json document = example();
        write("case.json", document.dump());
        document["study"] = {{"vary", {{"/crank_radius_mm", {{"plus_minus", 0.02}}}}},
                             {"watch", {{"/metrics/M_ups/range_Nm", Json::object()}}},
                             {"samples", 500}};
        write("study.json", document.dump());
        document["study"]["samples"] = 100'000;
        write("long.json", document.dump());
    }

    /// Each command that writes a file named "out".
    static std::vector<std::string> writing() {
        return {"solve case.json -o out", "study study.json -o out",
                "study study.json --shard 1/2 -o out", "validate --csv out",
                "methods --kernel cycle-mean --csv out"};
    }

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder)) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }
};

// nohup, and the shells of batch systems, let a program ignore what would end it.
TEST_F(InheritedState, IgnoredSignalsStayIgnored) {
    write_cases();
    const std::string whole = run("study long.json").out;
    for (const char* signal : {"HUP", "INT", "TERM"}) {
        const Outcome outcome =
            run(std::string("study long.json --threads 1 -o out & sleep 0.1; ") + "kill -" +
                    signal + " $!; wait $!",
                "", std::string("trap '' ") + signal + "; ");
        EXPECT_EQ(outcome.status, 0) << signal;
        EXPECT_TRUE(read_all(folder / "out") == whole) << signal;
        fs::remove(folder / "out");
    }
    // Nobody reads any more: where that does not end the program, it says so.
    for (const char* command : {"solve case.json", "study study.json", "validate",
                                "methods --kernel cycle-mean", "solve --batch < case.json"}) {
        run(std::string(command) + " 2>errors; echo $? >status; } | true", "", "trap '' PIPE; { ");
        const std::string status = read_all(folder / "status");
        EXPECT_TRUE(status == "0\n" || status == "2\n") << command << ": " << status;
    }
}

TEST_F(InheritedState, ClosedDescriptorsGoToNoFile) {
    write_cases();
    for (const std::string& command : writing()) {
        const bool prints = command.find("--csv") != std::string::npos;
        ASSERT_EQ(run(command).status, 0) << command;
        const std::string expected = read_all(folder / "out");
        fs::remove(folder / "out");
        const auto before = names();
        const Outcome outcome = run(command + " <&- >&- 2>&-");
        EXPECT_EQ(outcome.status, prints ? 2 : 0) << command;
        if (!prints) {
            EXPECT_TRUE(read_all(folder / "out") == expected) << command;
        }
        fs::remove(folder / "out");
        EXPECT_EQ(names(), before) << command;
    }
    for (const auto& [command, start] :
         {std::pair{"solve -", "-: cannot be read"}, std::pair{"study -", "-: cannot be read"},
          std::pair{"solve --batch", "ravnoves-cli: standard input cannot be read: "}}) {
        expect_rejected(run(std::string(command) + " <&-"), start);
        expect_rejected(run(std::string(command) + " < ."), start);
    }
}

TEST_F(InheritedState, NewFilesHaveTheRightsThatAreLeft) {
    write_cases();
    for (const auto& [mask, rights] : {std::pair{"077", 0600U}, std::pair{"002", 0664U}}) {
        for (const std::string& command : writing()) {
            EXPECT_EQ(run(command, "", std::string("umask ") + mask + "; ").status, 0) << command;
            struct stat status {};
            ASSERT_EQ(::stat((folder / "out").c_str(), &status), 0) << command;
            EXPECT_EQ(status.st_mode & 0777U, rights) << command;
            fs::remove(folder / "out");
        }
    }
}

// The disk is as good as full: nothing half-written stays.
TEST_F(InheritedState, ALimitOfFilesIsSaid) {
    write_cases();
    for (const std::string& command : writing()) {
        run("solve missing");  // the files of the test's own are there
        const auto before = names();
        // What is said goes by a pipe, which has no limit.
        const Outcome outcome =
            run(command + " 2>&1 >/dev/null; echo $?) | cat >&2", "", "(ulimit -f 0; ");
        EXPECT_NE(outcome.err.find("out: cannot be written: File too large\n2\n"),
                  std::string::npos)
            << command << outcome.err;
        EXPECT_EQ(names(), before) << command;
    }
}

TEST_F(InheritedState, AClosedOutputAndAFullDiskAreSaid) {
    write_cases();
    for (const char* command :
         {"solve case.json", "study study.json", "validate", "methods --kernel cycle-mean",
          "solve --batch < case.json", "--help", "solve --help", "--version"}) {
        for (const std::string output : {" >&-", " >/dev/full"}) {
            const Outcome outcome = run(command + output);
            EXPECT_EQ(outcome.status, 2) << command;
            const bool says_progress = std::string(command).starts_with("methods");
            EXPECT_EQ(lines_of(outcome.err).size(), says_progress ? 2U : 1U) << outcome.err;
            EXPECT_NE(outcome.err.find("standard output cannot be written"), std::string::npos)
                << command << outcome.err;
        }
    }
}

}  // namespace
}  // namespace ravnoves
