// The command line as a user or a script runs it: what goes to which stream, the exit status, and
// what is left on disk. Whole results are compared as truth values: they run to thousands of lines.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "case-file/json.h"
#include "command_line.h"

namespace ravnoves {
namespace {

namespace fs = std::filesystem;

using test::CommandLine;
using test::lines_of;
using test::Outcome;
using test::read_all;

TEST_F(CommandLine, SolvesToStandardOutput) {
    write("case.json", example().dump());
    const Outcome outcome = run("solve case.json");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("format"), "ravnoves-result");
    EXPECT_EQ(result.at("version"), 1);
    EXPECT_EQ(result.at("scene"), "balance-shaft");
    EXPECT_EQ(result.at("title"), example().at("title"));
    EXPECT_TRUE(result.at("result").is_object());
    EXPECT_EQ(outcome.out.back(), '\n');
}

TEST_F(CommandLine, WritesTheSameToAFile) {
    write("case.json", example().dump());
    const Outcome printed = run("solve case.json");
    const Outcome written = run("solve case.json -o result.json");
    EXPECT_EQ(written.status, 0);
    EXPECT_EQ(written.out + written.err, "");
    EXPECT_TRUE(read_all(folder / "result.json") == printed.out);
    EXPECT_EQ(run("solve case.json --output=again.json").status, 0);
    EXPECT_TRUE(read_all(folder / "again.json") == printed.out);
    // /dev/stdout is a link, here to a pipe.
    EXPECT_EQ(run("solve case.json -o /dev/stdout | cat > again").status, 0);
    EXPECT_TRUE(read_all(folder / "again") == printed.out);
}

TEST_F(CommandLine, BadInputIsOneLineAndLeavesTheResultFileAsItWas) {
    Json bad = example();
    bad["input"]["crank_radius_mm"] = -46;
    write("case.json", bad.dump());
    write("result.json", "kept");
    const Outcome outcome = run("solve case.json -o result.json");
    expect_rejected(outcome, "case.json: /input/crank_radius_mm: must be ");
    EXPECT_NE(outcome.err.find(", got -46\n"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_all(folder / "result.json"), "kept");
    expect_rejected(run("solve case.json -o new.json"), "case.json: /input/crank_radius_mm: ");
    EXPECT_FALSE(fs::exists(folder / "new.json"));
}

TEST_F(CommandLine, NeverWritesTheResultOverTheCaseOrAFileThatItReads) {
    const std::string table = "0;0\n180;100\n360;50,5\n540;-20\n720;0\n";
    fs::create_directory(folder / "study");
    write("study/torque.csv", table);
    fs::create_symlink("study/torque.csv", folder / "link.csv");
    fs::create_symlink("link.csv", folder / "link-to-link.csv");
    fs::create_hard_link(folder / "study/torque.csv", folder / "hard.csv");
    Json measured = example();
    measured["input"]["torque"] = {{"csv", "torque.csv"}};
    const std::string text = measured.dump();
    write("study/case.json", text);
    fs::create_hard_link(folder / "study/case.json", folder / "hard.json");
    for (const std::string name : {"study/torque.csv", "study/../study/torque.csv", "link.csv",
                                   "link-to-link.csv", "hard.csv"}) {
        expect_rejected(run("solve study/case.json -o " + name),
                        name + ": is a file that the case reads");
        EXPECT_TRUE(fs::equivalent(folder / name, folder / "study/torque.csv")) << name;
    }
    fs::create_symlink("study/case.json", folder / "link.json");
    for (const std::string name :
         {"study/case.json", "./study/case.json", "link.json", "hard.json"}) {
        expect_rejected(run("solve study/case.json -o " + name), name + ": is the case itself");
    }
    measured["input"]["torque"] = {
        {"pressure", {{"csv", "../hard.csv"}, {"bore_mm", 95.5}, {"rod_length_mm", 150}}}};
    write("study/pressure.json", measured.dump());
    expect_rejected(run("solve study/pressure.json -o study/torque.csv"),
                    "study/torque.csv: is a file that the case reads");
    EXPECT_EQ(read_all(folder / "study/torque.csv"), table);
    EXPECT_TRUE(read_all(folder / "study/case.json") == text);
}

TEST_F(CommandLine, RejectsFilesThatHoldNoCase) {
    expect_rejected(run("solve missing.json"), "missing.json: cannot be read: ");
    expect_rejected(run("solve ."), ".: must be a file, not a folder");
    write("cut.json", example().dump(2).substr(0, 200));
    expect_rejected(run("solve cut.json"), "cut.json: line ");
    write("list.json", "[1, 2]");
    expect_rejected(run("solve list.json"), "list.json: must be an object, got ");
}

// Each of them would be waited for, or read, for ever.
TEST_F(CommandLine, RejectsPipesAndDevicesAtOnce) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    Json piped = example();
    for (const std::string name : {"pipe", "/dev/zero"}) {
        const std::string said = name + ": must be a file, not a pipe or a device\n";
        expect_rejected(run("solve " + name, "", "true | timeout 300 "), said);
        piped["input"]["torque"] = {{"csv", name}};
        write("piped.json", piped.dump());
        expect_rejected(run("solve piped.json", "", "timeout 300 "),
                        "piped.json: /input/torque/csv: " + said);
    }
}

TEST_F(CommandLine, ReadsStandardInputAsACase) {
    write("torque.csv", "0;0\n180;100\n360;0\n540;-100\n720;0\n");
    Json document = example();
    document["input"]["torque"] = {{"csv", "torque.csv"}};
    const std::string text = document.dump();
    write("case.json", text);
    const std::string solved = run("solve case.json").out;
    EXPECT_EQ(Json::parse(solved).at("format"), "ravnoves-result");
    for (const std::string name : {"-", "/dev/stdin"}) {
        EXPECT_EQ(run("solve " + name, text).out, solved);
        EXPECT_EQ(run("solve " + name, "", "cat case.json | ").out, solved);
        EXPECT_EQ(run("solve " + name + " -o r.json", text).status, 0);
        EXPECT_EQ(read_all(folder / "r.json"), solved);
        expect_rejected(run("solve " + name, "{"), name + ": line 1");
        expect_rejected(run("solve " + name, "", "head -c 68000000 /dev/zero | "),
                        name + ": must be at most 64 MiB");
    }
}

TEST_F(CommandLine, ShowsNamesOfFilesPrintable) {
    write("case.json", example().dump());
    for (const char* arguments : {"solve 'no\x1b[31m\nsuch.json'",
                                  "study case.json --shard '\x1b[31m'", "'--x\x1b[31m\n'"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    }
}

// 100 MB in 300 MB of memory: the line is not held. A sanitizer itself takes more.
#if defined(RAVNOVES_SANITIZED)
constexpr const char* little_memory = "";
#else
constexpr const char* little_memory = "ulimit -v 300000; ";
#endif
TEST_F(CommandLine, BatchAnswersALineThatIsTooLongAndGoesOn) {
    const Outcome outcome = run(
        "solve --batch", std::string(100'000'000, 'x') + "\n" + example().dump(), little_memory);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    const auto lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], R"({"error":"must be at most 64 MiB","line":1})");
    EXPECT_EQ(Json::parse(lines[1]).at("scene"), "balance-shaft");
}

TEST_F(CommandLine, RejectsAPlaceThatCannotBeWritten) {
    write("case.json", example().dump());
    expect_rejected(run("solve case.json -o no/such/folder/result.json"),
                    "no/such/folder/result.json: cannot be written: ");
    fs::create_directory(folder / "folder");
    expect_rejected(run("solve case.json -o folder"), "folder: cannot be written");
    expect_rejected(run("solve case.json -o /dev/full"), "/dev/full: cannot be written");
    // Nothing half-written stays behind.
    for (const auto& entry : fs::directory_iterator(folder)) {
        EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
}

TEST_F(CommandLine, BatchAnswersEveryLineInItsPlace) {
    const std::string good = example().dump();
    Json bad = example();
    bad["input"]["crank_radius_mm"] = 0;
    Json moved = example();
    moved["title"] = "second";
    moved["input"]["shaft_angle_deg"] = 10;
    // Blank lines count as lines and get no answer; the last line needs no newline.
    const Outcome outcome =
        run("solve --batch", good + "\n" + bad.dump() + "\r\n\nnot json\n" + moved.dump());
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    const auto lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), 4U);

    write("case.json", good);
    EXPECT_TRUE(Json::parse(lines[0]) == Json::parse(run("solve case.json").out));

    const Json error = Json::parse(lines[1]);
    EXPECT_EQ(error.at("line"), 2);
    EXPECT_EQ(error.at("error").get<std::string>().find("/input/crank_radius_mm: must be "), 0U);
    EXPECT_EQ(Json::parse(lines[2]).at("line"), 4);
    EXPECT_EQ(Json::parse(lines[3]).at("title"), "second");
}

TEST_F(CommandLine, OnlyWhatIsAskedForIsPrintedUnderItsOwnPath) {
    write("case.json", example().dump());
    const Json whole = Json::parse(run("solve case.json").out).at("result");
    const Outcome some = run(
        "solve case.json --only /optimum/range/range_Nm,/metrics/M_ups --only /curves/M_s_Nm/3");
    EXPECT_EQ(some.status, 0);
    EXPECT_EQ(Json::parse(some.out).at("scene"), "balance-shaft");
    EXPECT_EQ(Json::parse(some.out).at("result"),
              (Json{{"optimum", {{"range", {{"range_Nm", whole["optimum"]["range"]["range_Nm"]}}}}},
                    {"metrics", {{"M_ups", whole["metrics"]["M_ups"]}}},
                    {"curves", {{"M_s_Nm", {{"3", whole["curves"]["M_s_Nm"][3]}}}}}}));
    // Each takes one list, and what follows is the case.
    EXPECT_EQ(run("solve --only /optimum/range/range_Nm,/metrics/M_ups --only /curves/M_s_Nm/3 "
                  "case.json")
                  .out,
              some.out);
}

TEST_F(CommandLine, OnlyRejectsWhatTheResultHasNot) {
    write("case.json", example().dump());
    expect_rejected(run("solve case.json --only /relieved_shaft"),
                    "case.json: /result/relieved_shaft: must be a value that the result has\n");
    expect_rejected(run("solve case.json --only optimum"),
                    "--only: must be a JSON pointer below the result");
    const auto lines = lines_of(
        run("solve --batch --only /no,/such", example().dump() + "\n" + example().dump()).out);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[1], R"({"error":"/result/no: must be a value that the result has","line":2})");
}

TEST_F(CommandLine, BatchReadsNoFilesOfOtherFolders) {
    fs::create_directory(folder / "service");
    write("secret.csv", "0;1\n360;5\n720;1\n");
    write("service/own.csv", "0;1\n360;5\n720;1\n");
    fs::create_symlink(folder / "secret.csv", folder / "service" / "link.csv");
    Json named = example();
    std::string cases;
    for (const std::string& name : {std::string("own.csv"), std::string("../secret.csv"),
                                    (folder / "secret.csv").string(), std::string("link.csv")}) {
        named["input"]["torque"] = {{"csv", name}};
        cases += named.dump() + "\n";
    }
    const auto lines = lines_of(run("solve --batch", cases, "cd service; ").out);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_TRUE(Json::parse(lines[0]).contains("result")) << lines[0];
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_EQ(Json::parse(lines[i]).at("error").get<std::string>().find(
                      "/input/torque/csv: must be a file in the folder of the case"),
                  0U)
            << lines[i];
    }
    for (const std::string& line :
         lines_of(run("solve --batch --allow-files", cases, "cd service; ").out)) {
        EXPECT_TRUE(Json::parse(line).contains("result")) << line;
    }
    // A case that one names oneself may.
    write("service/case.json", named.dump());
    EXPECT_EQ(run("solve service/case.json").status, 0);
    expect_rejected(run("solve service/case.json --allow-files"), "ravnoves-cli: ");
}

TEST_F(CommandLine, MistakesInTheCommandAreOneLineThatSaysWhatToDo) {
    for (const char* arguments : {"", "slove case.json", "solve", "solve one.json two.json",
                                  "solve case.json --no-such-option", "solve case.json -o"}) {
        const Outcome outcome = run(arguments);
        expect_rejected(outcome, "ravnoves-cli: ");
        EXPECT_NE(outcome.err.find("--help"), std::string::npos) << outcome.err;
    }
    EXPECT_NE(run("slove case.json").err.find("slove"), std::string::npos);
}

// Whatever takes a value rejects an empty one, and what is no value of it.
TEST_F(CommandLine, EveryOptionRejectsNonsense) {
    write("case.json", example().dump());
    int tried = 0;
    for (const std::string command : {"solve", "study", "methods", "validate"}) {
        const bool takes_case = command == "solve" || command == "study";
        for (const std::string& line : lines_of(run(command + " --help").out)) {
            const std::size_t name = line.find("--");
            const std::size_t end = line.find(' ', name);
            if (!line.starts_with("  -") || end == std::string::npos || line[end + 1] < 'A' ||
                line[end + 1] > 'Z' || line.substr(end + 1, 8) == "Excludes" ||
                line.substr(end + 1, 5) == "Needs") {
                continue;  // no option, or it takes no value
            }
            const std::string option = line.substr(name, end - name);
            const std::string words =
                command + (takes_case && option != "--merge" ? " case.json " : " ") + option;
            for (const std::string value : {" ''", "=", " no/such/place"}) {
                const Outcome outcome = run(words + value);
                EXPECT_EQ(outcome.status, 2) << words << value;
                EXPECT_EQ(outcome.out, "") << words << value;
                EXPECT_EQ(lines_of(outcome.err).size(), 1U) << words << value << outcome.err;
                ++tried;
            }
        }
        if (takes_case) {
            expect_rejected(run(command + " ''"), "ravnoves-cli: CASE: must name a file");
        }
    }
    EXPECT_GE(tried, 3 * 8);
    for (const char* arguments :
         {"solve case.json --only /a --only ''", "solve --batch case.json",
          "solve --batch -o result.json", "study case.json --shard 0/1",
          "study case.json --shard 2", "study case.json --shard 1/2x", "study",
          "study case.json --shard 4/3", "study case.json --shard 1/1025",
          "study case.json --merge part", "study case.json --threads 0",
          "study case.json --threads 1.5", "study --merge a --threads 2", "study --merge a ''",
          "solve case.json --batch=maybe", "methods --kernel Slider-Crank", "methods case.json",
          "validate case.json"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << arguments << outcome.err;
    }
}

TEST_F(CommandLine, SaysItsVersion) {
    const Outcome version = run("--version");
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out, "ravnoves-cli " RAVNOVES_VERSION "\n");
}

// Work without end is rejected at the input that asks for it, after some seconds of the processor.
TEST_F(CommandLine, RejectsCasesThatTakeTooMuchWork) {
    const char* const some_seconds = "ulimit -t 120; ";
    Json motion = Json::parse(read_all(fs::path(RAVNOVES_EXAMPLES) / "zotov-as-printed.case.json"));
    motion["input"]["kinematics"] = "exact";
    motion["input"]["lambda"] = 0.9999999999999999;
    motion["input"]["motion"] = Json::object();
    write("locked.json", motion.dump());
    expect_rejected(run("solve locked.json", "", some_seconds),
                    "locked.json: /input/lambda: must be further from 1 for a motion: ");
    motion["input"]["lambda"] = 0.3;
    motion["input"]["profile_error_um"] = 5;
    motion["input"]["profile_error_waves"] = 1000;
    motion["input"]["motion"] = {
        {"turns", 1000}, {"crank_torque_Nm", 1}, {"with_profile_error", true}};
    write("waves.json", motion.dump());
    expect_rejected(run("solve waves.json", "", some_seconds),
                    "waves.json: /input/motion/turns: must be less for this motion: ");
}

// A file's name is bytes to us: Cyrillic, spaces and quotes are the user's business.
TEST_F(CommandLine, TakesAnyFileName) {
    write("ТМЗ 650 (копия).json", example().dump());
    EXPECT_EQ(run("solve 'ТМЗ 650 (копия).json' -o 'итог.json'").status, 0);
    EXPECT_TRUE(fs::exists(folder / "итог.json"));
}

}  // namespace
}  // namespace ravnoves
