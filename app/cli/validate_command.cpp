#include <string>

#include "command.h"
#include "methods/validation/validation.h"
#include "output.h"

namespace ravnoves::cli {

namespace {

class ValidateCommand final : public Command {
  public:
    explicit ValidateCommand(CLI::App& app) {
        app_ = app.add_subcommand("validate",
                                  "Compute every number printed in the four papers and compare");
        app_->footer(
            "Verdicts: reproduced; artefact (of the paper's way of computing); misprint;\n"
            "not derivable (necessary data are not printed); given (stated by the paper, or the\n"
            "inverse of another number).\n"
            "Exit status: 0 each printed number has one of these, else 1.\n");
        app_->add_option("--csv", csv_path_, "Write the table to this file too")
            ->type_name("FILE")
            ->check(names_a_file);
    }

    int run() override {
        if (!csv_path_.empty() && !can_write_file(csv_path_)) {
            return exit_bad_input;
        }
        const methods::ValidationReport report = methods::validate();
        if (!csv_path_.empty()) {
            if (const int status = write_file(csv_path_, methods::write_csv(report))) {
                return status;
            }
        }
        if (const int status = print(methods::write_text(report))) {
            return status;
        }
        return report.count(methods::Verdict::differs) == 0 ? exit_done : exit_our_fault;
    }

  private:
    std::string csv_path_;
};

}  // namespace

std::unique_ptr<Command> make_validate_command(CLI::App& app) {
    return std::make_unique<ValidateCommand>(app);
}

}  // namespace ravnoves::cli
