#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
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

/// A line on a terminal that says how far the work is, once it has taken a while.
class ProgressLine {
  public:
    void show(double done) {
        const auto now = Clock::now();
        if (!to_terminal_ || now - last_ < std::chrono::seconds(1)) {
            return;
        }
        last_ = now;
        shown_ = true;
        const auto per_thousand = static_cast<int>(1000.0 * done);
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

class StudyCommand final : public Command {
  public:
    explicit StudyCommand(CLI::App& app) {
        app_ = app.add_subcommand(
            "study", "Vary the inputs of a case by its \"study\" and print the effect");
        app_->footer(
            "Any number of shards, combined by --merge, prints the same digits as one run.\n");
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
        return write_file(output_path_, text + "\n");
    }

    int run_case() {
        if (!is_same_file(case_path_, output_path_) && !output_path_.empty() &&
            !can_write_file(output_path_)) {
            return exit_bad_input;
        }
        return with_case(
            case_path_, output_path_, "study",
            [this](const CaseFile& file, const CaseContext& context, const std::string& text) {
                return run_problem(studies::problem_of(file, context, text));
            });
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
        if (would_destroy(problem)) {
            return complain(
                output_path_,
                "has the study of another case, or of this one before it changed; move it "
                "or choose another file");
        }
        return deliver(solved(problem));
    }

    Part solved(const studies::Problem& problem) const {
        const Shard shard = read_shard();
        ProgressLine line;
        return *studies::run_study(problem, shard.number, shard.of, threads(), [&](double done) {
            line.show(done);
            return true;
        });
    }

    int merge() {
        for (const std::string& each : parts_) {
            if (is_same_file(each, output_path_)) {
                return complain(output_path_,
                                "is one of the parts; write the study to another file");
            }
        }
        std::string path;  // of the part that is read
        try {
            return deliver(studies::merge_parts(parts_, [&](const std::string& each) {
                path = each;
                Part part = studies::read_part(parse_json(read_text_file(each)));
                path.clear();
                return part;
            }));
        } catch (const InputError& error) {
            // A part that does not fit is named, missing ones are not.
            const bool named = path.empty() ? !error.where().empty() : error.where() == path;
            return complain(named ? "" : path.empty() ? "--merge" : path, error.what());
        }
    }

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
