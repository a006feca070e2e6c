#include <unistd.h>

#include <exception>
#include <new>
#include <string>
#include <vector>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/json_text.h"
#include "case-file/text_file.h"
#include "command.h"
#include "given_case.h"
#include "output.h"
#include "scenes/scenes.h"

namespace ravnoves::cli {

namespace {

std::string rejection_of(const LineReader& lines, const char* why) {
    return json_text({{"error", why}, {"line", lines.number()}}, JsonLayout::one_line) + '\n';
}

/// The answer to the last line, a line itself; empty where that is blank.
/// @throws std::bad_alloc
std::string answer_to(const std::string& line, const LineReader& lines, const CaseContext& context,
                      const Wanted& wanted) {
    try {
        lines.check_kept();
        if (line.find_first_not_of(" \t\r") == std::string::npos) {
            return {};
        }
        return json_text(solve_case(parse_case(line), context, wanted), JsonLayout::one_line) +
               '\n';
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {  // a bad line is answered in its place
        return rejection_of(lines, error.what());
    }
}

/// @throws InputError where standard input cannot be read
int solve_batch(const CaseContext& context, const Wanted& wanted) {
    LineReader lines(STDIN_FILENO);
    std::string line;
    while (lines.next(line)) {
        std::string answer;
        try {
            answer = answer_to(line, lines, context, wanted);
        } catch (const std::bad_alloc&) {
            std::string().swap(line);
            answer = rejection_of(lines, no_memory);
        }
        if (const int status = print(answer)) {
            return status;
        }
    }
    return exit_done;
}

class SolveCommand final : public Command {
  public:
    explicit SolveCommand(CLI::App& app) {
        app_ = app.add_subcommand(
            "solve", "Solve a case file and print its result, as JSON, on standard output");
        app_->footer(
            "Exit status: 0 solved (a design that cannot exist is a result with a reason),\n"
            "2 bad input, named on standard error; nothing is written then.\n");
        CLI::Option* case_option =
            app_->add_option("CASE", case_path_, "Case file (JSON); - is standard input");
        case_option->type_name("")->check(names_a_file);
        CLI::Option* output_option =
            app_->add_option("-o,--output", result_path_, "Write the result to this file instead");
        output_option->type_name("FILE")->check(names_a_file);
        CLI::Option* batch_option =
            app_->add_flag("--batch", batch_,
                           "Read one case per line from standard input, print one result per line")
                ->excludes(case_option)
                ->excludes(output_option);
        app_->add_option("--only", only_,
                         "Compute and print only these values of the result: JSON pointers below "
                         "it, such as /metrics/M_ups/range_Nm,/optimum")
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name("POINTER[,POINTER...]");
        app_->add_flag("--allow-files", allow_files_,
                       "Let the cases of --batch read files outside the working directory")
            ->needs(batch_option);
    }

    void check() const override {
        if (!batch_ && case_path_.empty()) {
            throw CLI::RequiredError("CASE or --batch");
        }
    }

    int run() override {
        Wanted wanted;
        try {
            wanted = Wanted(only_);
        } catch (const InputError& error) {
            return complain("--only", error.what());
        }
        if (batch_) {
            CaseContext context;
            context.stays_in_directory = !allow_files_;
            try {
                return solve_batch(context, wanted);
            } catch (const InputError& error) {
                return complain("ravnoves-cli", std::string("standard input ") + error.what());
            }
        }
        return with_case(
            case_path_, result_path_, "result",
            [&](const CaseFile& file, const CaseContext& context, const std::string&) {
                return write_file(
                    result_path_,
                    json_text(solve_case(file, context, wanted), JsonLayout::lines) + "\n");
            });
    }

    std::string file() const override { return case_path_; }

  private:
    std::string case_path_;
    std::string result_path_;
    std::vector<std::string> only_;
    bool batch_ = false;
    bool allow_files_ = false;
};

}  // namespace

std::unique_ptr<Command> make_solve_command(CLI::App& app) {
    return std::make_unique<SolveCommand>(app);
}

}  // namespace ravnoves::cli
