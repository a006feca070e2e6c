#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json_text.h"
#include "case-file/system_fault.h"
#include "case-file/text_file.h"
#include "command.h"
#include "given_case.h"
#include "output.h"
#include "scenes/case_sources.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

namespace ravnoves::cli {

namespace {

using studies::Part;

volatile std::sig_atomic_t stop_signal = 0;

/// While it lives, the signals that end a program are noted, so that what is done can be kept.
/// What whoever started the program lets it ignore, as nohup does, does not end it.
class StopNoted {
  public:
    StopNoted() {
        handle([](int number) { stop_signal = number; });
    }
    StopNoted(const StopNoted&) = delete;
    StopNoted& operator=(const StopNoted&) = delete;
    ~StopNoted() { handle(SIG_DFL); }

  private:
    static void handle(void (*handler)(int)) {
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
            struct sigaction now {};
            if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) {
                std::signal(signal, handler);
            }
        }
    }
};

/// A line on a terminal that says how far the work is, once it has taken a while.
class ProgressLine {
  public:
    void show(const Part& part) {
        const auto now = Clock::now();
        if (!to_terminal_ || now - last_ < std::chrono::seconds(1)) {
            return;
        }
        last_ = now;
        shown_ = true;
        const auto per_thousand = static_cast<int>(1000.0 * studies::share_done(part));
        std::cerr << "\rstudy: " << per_thousand / 10 << '.' << per_thousand % 10 << " %  "
                  << std::flush;
    }
    ProgressLine() = default;
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() {
        if (shown_) {
            std::cerr << '\n';
        }
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    bool to_terminal_ = ::isatty(STDERR_FILENO) != 0;
    bool shown_ = false;
};

/// Of a file of progress, which its text names.
struct ProgressError : InputError {
    using InputError::InputError;
};

/// The file that a path leads to through links, which may be there later; as given without any.
std::string without_links(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    fs::path file = path;
    constexpr int maximum = 40;
    for (int i = 0; i < maximum && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
        file = file.parent_path() / fs::read_symlink(file, error);
    }
    const fs::path real = fs::weakly_canonical(file, error);
    return error || real == fs::absolute(file, error).lexically_normal() ? file : real;
}

/// What a study with an output has done, in a file beside that, so that it continues from there. No
/// other study touches it: it is locked while a study runs, and is rejected where it is another's.
/// One output has one such file, by whatever links it is named.
class Progress {
  public:
    /// @throws ProgressError where another study is at work for that output
    explicit Progress(const std::string& output)
        : path_(without_links(output) + ".unfinished"), lock_path_(path_ + ".lock") {
        constexpr unsigned rights = 0666;
        lock_ = ::open(lock_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, rights);
        if (lock_ < 0) {
            throw ProgressError(lock_path_,
                                {Text::tr("cannot be written: %1"), system_fault(errno)});
        }
        const bool locked = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        struct stat now {};
        ::fstat(lock_, &now);
        const bool removed = now.st_nlink == 0;  // by one that ends
        if (locked || removed) {
            ::close(lock_);
            throw ProgressError(output, "is being written by another study; choose another file");
        }
        if (!S_ISREG(now.st_mode) || now.st_size != 0) {
            ::close(lock_);
            throw ProgressError(lock_path_, not_left);
        }
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() {
        ::unlink(lock_path_.c_str());
        ::close(lock_);
    }

    /// The part as an interrupted run of the same study left it.
    /// @throws ProgressError where the file is anything else
    std::optional<Part> left_of(const studies::Problem& problem, std::uint64_t shard,
                                std::uint64_t shards) const {
        std::error_code ignored;
        if (!std::filesystem::exists(path_, ignored)) {
            return std::nullopt;
        }
        Part part;
        try {
            part = studies::read_part(parse_json(read_text_file(path_)));
        } catch (const InputError&) {
            throw ProgressError(path_, not_left);
        }
        if (part.origin != problem.origin || part.study != problem.study || part.shard != shard ||
            part.shards != shards) {
            throw ProgressError(path_,
                                "belongs to another study, or to this one before its case "
                                "changed; move it or choose another file");
        }
        return part;
    }
    void keep(const Part& part) const {
        try {
            write_text_file(path_,
                            json_text(studies::write_part(part), JsonLayout::one_line) + "\n");
        } catch (const InputError& error) {
            throw ProgressError(path_, error.allowed_message());
        }
    }
    void remove() const {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }

  private:
    static constexpr const char* not_left =
        "is not an interrupted study and would be overwritten; move it or choose another file";

    std::string path_;
    std::string lock_path_;
    int lock_ = -1;
};

class StudyCommand final : public Command {
  public:
    explicit StudyCommand(CLI::App& app) {
        app_ = app.add_subcommand(
            "study", "Vary the inputs of a case by its \"study\" and print the effect");
        app_->footer(
            "Any number of shards, combined by --merge, prints the same digits as one run.\n"
            "With -o an interrupted run continues where it stopped.\n");
        CLI::Option* case_option = app_->add_option(
            "CASE", case_path_, "Case file (JSON) with a study; - is standard input");
        case_option->type_name("")->check(names_a_file);
        app_->add_option("-o,--output", output_path_, "Write to this file instead")
            ->type_name("FILE")
            ->check(names_a_file);
        CLI::Option* shard_option =
            app_->add_option("--shard", shard_text_,
                             "Compute the K-th of N parts of the samples and print its counts")
                ->type_name("K/N");
        CLI::Option* threads_option =
            app_->add_option("--threads", threads_,
                             "Number of threads; default and maximum: one per core")
                ->type_name("COUNT")
                ->check(CLI::Range(1, 1024));
        app_->add_option("--merge", parts_, "Combine the parts of a study")
            ->type_name("PART...")
            ->expected(1, -1)
            ->check(names_a_file)
            ->excludes(case_option)
            ->excludes(shard_option)
            ->excludes(threads_option);
    }

    void check() const override {
        if (parts_.empty() && case_path_.empty()) {
            throw CLI::RequiredError("CASE or --merge");
        }
        read_shard();
    }

    int run() override { return parts_.empty() ? run_case() : merge(); }

    std::string file() const override { return case_path_; }

  private:
    struct Shard {
        std::uint64_t number = 1;
        std::uint64_t of = 1;
    };

    Shard read_shard() const {
        Shard shard;
        if (!shard_text_) {
            return shard;
        }
        const char* const end = shard_text_->data() + shard_text_->size();
        const auto first = std::from_chars(shard_text_->data(), end, shard.number);
        const bool slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
        const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.of) : first;
        if (!slash || second.ec != std::errc{} || second.ptr != end || shard.number < 1 ||
            shard.number > shard.of || shard.of > studies::max_blocks) {
            throw CLI::ValidationError("--shard", "must be K/N with K from 1 to N and N at most " +
                                                      std::to_string(studies::max_blocks) +
                                                      ", got " + *shard_text_);
        }
        return shard;
    }

    /// More than there are cores are no faster, and their stacks may leave the work no memory.
    int threads() const {
        return std::min(threads_,
                        static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    }

    int deliver(const Part& part) const {
        const std::string text = !shard_text_
                                     ? json_text(studies::write_results(part), JsonLayout::lines)
                                     : json_text(studies::write_part(part), JsonLayout::one_line);
        return output_path_.empty() ? print(text + "\n") : write_file(output_path_, text + "\n");
    }

    int run_case() {
        if (is_same_file(case_path_, output_path_)) {
            return complain(output_path_, "is the case itself; write the study to another file");
        }
        if (!output_path_.empty() && !can_write_file(output_path_)) {
            return exit_bad_input;
        }
        try {
            const auto [text, context] = read_given_case(case_path_);
            const CaseFile file = parse_case(text);
            if (is_named_by(file, context, output_path_)) {
                return complain(output_path_,
                                "is a file that the case reads; write the study to another file");
            }
            return run_problem(studies::problem_of(file, context, text));
        } catch (const ProgressError& error) {
            return complain("", error.what());
        } catch (const InputError& error) {
            return complain(case_path_, error.what());
        }
    }

    /// Whether the output is there and holds the finished study of another case.
    bool would_destroy(const studies::Problem& problem) const {
        try {
            const std::string its_case =
                studies::case_of_results(parse_json(read_text_file(output_path_)));
            return !its_case.empty() && its_case != problem.origin.case_sha256;
        } catch (const InputError&) {
            return false;  // no JSON, or not there
        }
    }

    int run_problem(const studies::Problem& problem) {
        const Shard shard = read_shard();
        std::error_code ignored;
        const bool keeps =
            !output_path_.empty() && (!std::filesystem::exists(output_path_, ignored) ||
                                      std::filesystem::is_regular_file(output_path_, ignored));
        if (keeps && would_destroy(problem)) {
            return complain(
                output_path_,
                "has the study of another case, or of this one before it changed; move it "
                "or choose another file");
        }
        auto progress = keeps ? std::make_unique<const Progress>(output_path_) : nullptr;
        auto left = keeps ? progress->left_of(problem, shard.number, shard.of) : std::nullopt;
        Part part = left ? std::move(*left)
                         : studies::begin_part(problem, shard.number, shard.of, threads());
        run(problem, part, progress.get());
        if (stop_signal != 0 && !part.finished()) {
            progress.reset();
            std::raise(stop_signal);
            return exit_bad_input;
        }
        const int status = deliver(part);
        if (status == exit_done && keeps) {
            progress->remove();
        }
        return status;
    }

    void run(const studies::Problem& problem, Part& part, const Progress* progress) const {
        auto kept = Clock::now();
        ProgressLine line;
        const auto noted = progress != nullptr ? std::make_unique<StopNoted>() : nullptr;
        studies::run_part(problem, part, threads(), [&](const Part& now) {
            line.show(now);
            constexpr auto often = std::chrono::seconds(5);
            if (progress != nullptr && (stop_signal != 0 || Clock::now() - kept > often) &&
                !now.finished()) {
                progress->keep(now);
                kept = Clock::now();
            }
            return stop_signal == 0;
        });
    }

    int merge() {
        studies::PartMerger merger;
        std::string path;
        try {
            for (const std::string& each : parts_) {
                path = each;
                if (is_same_file(each, output_path_)) {
                    return complain(output_path_,
                                    "is one of the parts; write the study to another file");
                }
                merger.add(studies::read_part(parse_json(read_text_file(each))), each);
            }
            path.clear();
            return deliver(merger.finish());
        } catch (const InputError& error) {
            // The merger names the part itself.
            const bool named = error.where() == path;
            return complain(path.empty() ? "--merge" : named ? "" : path, error.what());
        }
    }

    using Clock = std::chrono::steady_clock;

    std::string case_path_;
    std::string output_path_;
    std::optional<std::string> shard_text_;
    std::vector<std::string> parts_;
    int threads_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_study_command(CLI::App& app) {
    return std::make_unique<StudyCommand>(app);
}

}  // namespace ravnoves::cli
