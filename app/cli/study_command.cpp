#include <signal.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/json_text.h"
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
        const auto per_thousand = 1000 * (part.done - part.from) / (part.to - part.from);
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

bool is_same_work(const Part& one, const Part& other) {
    return one.origin == other.origin && one.study == other.study && one.shard == other.shard &&
           one.shards == other.shards;
}

class StudyCommand final : public Command {
  public:
    explicit StudyCommand(CLI::App& app) {
        app_ = app.add_subcommand(
            "study", "Vary a case's inputs as its \"study\" says, and print what that does");
        app_->footer(
            "Any number of shards, put together by --merge, prints what one run prints, to the\n"
            "last digit. With -o a run that was interrupted goes on where it stopped.\n");
        CLI::Option* case_option = app_->add_option(
            "CASE", case_path_, "Case file (JSON) with a study; - is standard input");
        case_option->type_name("");
        app_->add_option("-o,--output", output_path_, "Write to this file instead")
            ->type_name("FILE")
            ->check(names_a_file);
        CLI::Option* shard_option =
            app_->add_option("--shard", shard_text_,
                             "Take the K-th of N parts of the samples and print its counts")
                ->type_name("K/N");
        app_->add_option("--merge", parts_, "Put the parts of a study together")
            ->type_name("PART...")
            ->expected(1, -1)
            ->excludes(case_option)
            ->excludes(shard_option);
        app_->add_option("--threads", threads_, "Work with so many threads; usually one a core")
            ->type_name("COUNT")
            ->check(CLI::Range(1, 1024));
    }

    void check() const override {
        if (parts_.empty() && case_path_.empty()) {
            throw CLI::RequiredError("CASE or --merge");
        }
        if (!shard_text_.empty()) {
            read_shard();
        }
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
        if (shard_text_.empty()) {
            return shard;
        }
        const char* const end = shard_text_.data() + shard_text_.size();
        const auto first = std::from_chars(shard_text_.data(), end, shard.number);
        const bool slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
        const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.of) : first;
        if (!slash || second.ec != std::errc{} || second.ptr != end || shard.number < 1 ||
            shard.number > shard.of || shard.of > studies::most_shards) {
            throw CLI::ValidationError("--shard",
                                       "must be K/N with K from 1 to N, got " + shard_text_);
        }
        return shard;
    }

    int deliver(const Part& part) const {
        const std::string text = shard_text_.empty()
                                     ? json_text(studies::write_results(part), JsonLayout::lines)
                                     : json_text(studies::write_part(part), JsonLayout::one_line);
        return output_path_.empty() ? print(text + "\n") : write_file(output_path_, text + "\n");
    }

    int run_case() {
        if (is_same_file(case_path_, output_path_)) {
            complain(output_path_, "is the case itself; the study must go to another file");
            return exit_bad_input;
        }
        if (!output_path_.empty() && !can_write_file(output_path_)) {
            return exit_bad_input;
        }
        try {
            const auto [text, context] = read_given_case(case_path_);
            const CaseFile file = parse_case(text);
            if (is_named_by(file, context, output_path_)) {
                complain(output_path_,
                         "is a file that the case reads; the study must go to another file");
                return exit_bad_input;
            }
            return run_problem(studies::problem_of(file, context, text));
        } catch (const InputError& error) {
            complain(error.where() == unfinished_path() ? "" : case_path_, error.what());
            return exit_bad_input;
        }
    }

    int run_problem(const studies::Problem& problem) {
        Part part = resumed(problem);
        const bool keeps = keeps_what_is_done();
        auto kept = Clock::now();
        {
            ProgressLine line;
            const std::optional<StopNoted> noted =
                keeps ? std::optional<StopNoted>(std::in_place) : std::nullopt;
            if (part.shard == 1 && !part.robust_best && studies::asks_for_robust_best(problem)) {
                part.robust_best =
                    studies::find_robust_best(problem, threads_, [] { return stop_signal == 0; });
            }
            studies::run_part(problem, part, threads_, [&](const Part& now) {
                line.show(now);
                constexpr auto often = std::chrono::seconds(5);
                if (keeps && (stop_signal != 0 || Clock::now() - kept > often) && !now.finished()) {
                    write_text_file(
                        unfinished_path(),
                        json_text(studies::write_part(now), JsonLayout::one_line) + "\n");
                    kept = Clock::now();
                }
                return stop_signal == 0;
            });
        }
        if (stop_signal != 0 && !part.finished()) {
            std::raise(stop_signal);
            return exit_bad_input;
        }
        const int status = deliver(part);
        if (status == exit_done && keeps) {
            std::error_code ignored;
            std::filesystem::remove(unfinished_path(), ignored);
        }
        return status;
    }

    bool keeps_what_is_done() const {
        std::error_code ignored;
        return !output_path_.empty() && (!std::filesystem::exists(output_path_, ignored) ||
                                         std::filesystem::is_regular_file(output_path_, ignored));
    }
    std::string unfinished_path() const { return output_path_ + ".unfinished"; }

    /// The part as an interrupted run left it, or a new one.
    Part resumed(const studies::Problem& problem) const {
        const Shard shard = read_shard();
        std::error_code ignored;
        if (keeps_what_is_done() && std::filesystem::exists(unfinished_path(), ignored)) {
            try {
                Part part = studies::read_part(parse_json(read_text_file(unfinished_path())));
                Part wanted;
                wanted.origin = problem.origin;
                wanted.study = problem.study;
                wanted.shard = shard.number;
                wanted.shards = shard.of;
                if (is_same_work(part, wanted)) {
                    return part;
                }
            } catch (const InputError&) {
                throw InputError(unfinished_path(),
                                 "is not what an interrupted study leaves, and would be written "
                                 "over; move it or choose another file");
            }
        }
        return studies::begin_part(problem, shard.number, shard.of, threads_);
    }

    int merge() {
        studies::PartMerger merger;
        std::string path;
        try {
            for (const std::string& each : parts_) {
                path = each;
                if (is_same_file(each, output_path_)) {
                    complain(output_path_,
                             "is one of the parts; the study must go to another file");
                    return exit_bad_input;
                }
                merger.add(studies::read_part(parse_json(read_text_file(each))), each);
            }
            path.clear();
            return deliver(merger.finish());
        } catch (const InputError& error) {
            // The merger names the part itself.
            const bool named = error.where() == path;
            complain(path.empty() ? "--merge" : named ? "" : path, error.what());
            return exit_bad_input;
        }
    }

    using Clock = std::chrono::steady_clock;

    std::string case_path_;
    std::string output_path_;
    std::string shard_text_;
    std::vector<std::string> parts_;
    int threads_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_study_command(CLI::App& app) {
    return std::make_unique<StudyCommand>(app);
}

}  // namespace ravnoves::cli
