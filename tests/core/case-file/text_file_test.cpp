#include "case-file/text_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "error_of.h"
#include "temporary_folder.h"

namespace ravnoves {
namespace {

namespace fs = std::filesystem;

class TextFile : public testing::Test {
  protected:
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    static unsigned rights(const fs::path& path) {
        struct stat status {};
        ::stat(path.c_str(), &status);
        return status.st_mode & 07777U;
    }

    const test::TemporaryFolder temporary_;
    const fs::path folder_ = temporary_.path();
    const fs::path path_ = folder_ / "engine.case.json";
};

TEST_F(TextFile, IsReplacedWhole) {
    write_text_file(path_, "one");
    write_text_file(path_, "two, which is longer");
    EXPECT_EQ(read_text_file(path_), "two, which is longer");
    EXPECT_EQ(files(), 1U);
}

TEST_F(TextFile, ANewOneHasTheUsualRights) {
    const mode_t before = ::umask(027);
    write_text_file(path_, "text");
    ::umask(before);
    EXPECT_EQ(rights(path_), 0640U);
}

TEST_F(TextFile, OneThatIsReplacedKeepsItsRights) {
    for (const unsigned mode : {0600U, 0664U, 0755U}) {
        write_text_file(path_, "before");
        ::chmod(path_.c_str(), mode);
        write_text_file(path_, "after");
        EXPECT_EQ(rights(path_), mode);
        EXPECT_EQ(read_text_file(path_), "after");
    }
}

TEST_F(TextFile, AReadOnlyOneStaysAsItIs) {
    write_text_file(path_, "before");
    ::chmod(path_.c_str(), 0444);
    EXPECT_EQ(test::error_of([&] { write_text_file(path_, "after"); }),
              "is read-only and was not changed");
    EXPECT_EQ(read_text_file(path_), "before");
    EXPECT_EQ(files(), 1U);
}

TEST_F(TextFile, PlantedLinksAreNotFollowed) {
    const fs::path victim = folder_ / "victim";
    std::ofstream(victim) << "precious";
    write_text_file(path_, "before");
    const std::string partial = "." + std::to_string(::getpid()) + "-";
    for (int i = 0; i < 20; ++i) {
        fs::create_symlink(victim, folder_ / (partial + std::to_string(i) + ".part"));
    }
    const std::size_t before = files();
    write_text_file(path_, "after");
    EXPECT_EQ(read_text_file(victim), "precious");
    EXPECT_EQ(read_text_file(path_), "after");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path_)));
    EXPECT_EQ(files(), before);
}

TEST_F(TextFile, APipeIsWrittenWhereSomebodyReadsIt) {
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    const std::string why = test::error_of([&] { write_text_file(path_, "text"); });
    EXPECT_NE(why.find("without a reader"), std::string::npos) << why;
    const int reader = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    write_text_file(path_, "text");
    char read[8] = {};
    EXPECT_EQ(::read(reader, read, sizeof read), 4);
    EXPECT_STREQ(read, "text");
    ::close(reader);
}

/// /proc/kmsg is a file to who asks, and makes its reader wait for the kernel's next message.
TEST_F(TextFile, WhatNeverEndsIsRejected) {
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    for (const fs::path& endless : {path_, fs::path("/dev/zero"), fs::path("/proc/kmsg")}) {
        const std::string why = test::error_of([&] { read_text_file(endless); });
        EXPECT_NE(why, "no error") << endless;
    }
}

TEST_F(TextFile, ANameMayBeAsLongAsNamesAre) {
    std::string name(250, 'n');
    write_text_file(folder_ / name, "text");
    EXPECT_EQ(read_text_file(folder_ / name), "text");
    std::string letters;
    for (int i = 0; i < 125; ++i) {
        letters += "ж";
    }
    write_text_file(folder_ / letters, "text");
    EXPECT_EQ(files(), 2U);
}

TEST_F(TextFile, ALinkIsFollowed) {
    const fs::path target = folder_ / "target";
    fs::create_symlink("target", path_);
    for (const char* text : {"new", "replaced"}) {
        write_text_file(path_, text);
        EXPECT_TRUE(fs::is_symlink(fs::symlink_status(path_)));
        EXPECT_EQ(read_text_file(target), text);
    }
}

/// A program that writes again and again is ended at any moment.
class EndedWriter : public TextFile, public testing::WithParamInterface<int> {};

TEST_P(EndedWriter, LeavesAWholeFileAndNothingElse) {
    const std::string texts[] = {std::string(3'000'000, 'a'), std::string(3'000'000, 'b')};
    write_text_file(path_, texts[0]);
    for (int round = 0; round < 25; ++round) {
        // Whoever runs the tests may ignore the signal; the writer must not, from its first moment.
        const auto before = ::signal(GetParam(), SIG_DFL);
        const pid_t writer = ::fork();
        if (writer != 0) {
            ::signal(GetParam(), before);
        }
        ASSERT_GE(writer, 0);
        if (writer == 0) {
            for (unsigned i = 0;; ++i) {
                write_text_file(path_, texts[i % 2]);
            }
        }
        ::usleep(static_cast<useconds_t>(500 + 700 * round));
        ::kill(writer, GetParam());
        int status = 0;
        ::waitpid(writer, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status));
        const std::string found = read_text_file(path_);
        EXPECT_TRUE(found == texts[0] || found == texts[1]);
        EXPECT_EQ(files(), 1U);
    }
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedWriter, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace ravnoves
