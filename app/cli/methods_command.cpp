#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "given_case.h"
#include "methods/case_budget.h"
#include "methods/report.h"
#include "output.h"

namespace ravnoves::cli {

namespace {

std::string kernel_names() {
    std::string names;
    for (const methods::Kernel& kernel : methods::kernels()) {
        names += (names.empty() ? "" : ", ") + kernel.id;
    }
    return names;
}

/// Lines on standard error: a kernel's name once, then every tenth part as it is done.
class ProgressLines {
  public:
    explicit ProgressLines(const std::string& name) { std::cerr << name << ": 0 %" << std::flush; }
    ProgressLines(const ProgressLines&) = delete;
    ProgressLines& operator=(const ProgressLines&) = delete;
    ~ProgressLines() { std::cerr << '\n'; }

    bool operator()(double part) {
        const int tenth = static_cast<int>(std::floor(10.0 * part + 1e-9));
        if (tenth > last_) {
            last_ = tenth;
            std::cerr << " … " << 10 * tenth << " %" << std::flush;
        }
        return true;
    }

  private:
    int last_ = 0;
};

methods::KernelReport measure(const methods::Kernel& kernel) {
    ProgressLines lines(kernel.id);
    return methods::measure_kernel(kernel, {}, [&](double part) { return lines(part); });
}

class MethodsCommand final : public Command {
  public:
    explicit MethodsCommand(CLI::App& app) {
        app_ = app.add_subcommand(
            "methods", "Measure time, error and limits of each numerical method on this machine");
        // Made when it is read: to have the kernels' names is to prepare the kernels.
        app_->footer([] {
            return "Kernels: " + kernel_names() +
                   ".\nTimes are of this machine; errors are against 50 digits. Progress: "
                   "standard error.\n";
        });
        CLI::Option* kernel = app_->add_option("--kernel", kernel_, "One kernel instead of all");
        kernel->type_name("NAME");
        CLI::Option* csv =
            app_->add_option("--csv", csv_path_, "Write the tables to this file too");
        csv->type_name("FILE")->check(names_a_file);
        app_->add_option("--case", case_path_,
                         "Print instead what each choice and tolerance of this case contributes to "
                         "its leading results")
            ->type_name("CASE")
            ->check(names_a_file)
            ->excludes(kernel)
            ->excludes(csv);
    }

    void check() const override {
        if (kernel_ && methods::find_kernel(*kernel_) == nullptr) {
            throw CLI::ValidationError("--kernel",
                                       "must be one of " + kernel_names() + ", got " + *kernel_);
        }
    }

    int run() override {
        if (!case_path_.empty()) {
            return with_case(
                case_path_, "", "",
                [](const CaseFile& file, const CaseContext& context, const std::string&) {
                    return print(methods::write_text(methods::case_budget(file, context)));
                });
        }
        if (!csv_path_.empty() && !can_write_file(csv_path_)) {
            return exit_bad_input;
        }
        std::vector<methods::KernelReport> reports;
        for (const methods::Kernel& kernel : methods::kernels()) {
            if (kernel_ && kernel.id != *kernel_) {
                continue;
            }
            const std::string gap = reports.empty() ? "" : "\n";
            reports.push_back(measure(kernel));
            if (const int status = print(gap + methods::write_text(reports.back()))) {
                return status;
            }
        }
        return csv_path_.empty() ? exit_done : write_file(csv_path_, methods::write_csv(reports));
    }

    std::string file() const override { return case_path_; }

  private:
    std::optional<std::string> kernel_;
    std::string csv_path_;
    std::string case_path_;
};

}  // namespace

std::unique_ptr<Command> make_methods_command(CLI::App& app) {
    return std::make_unique<MethodsCommand>(app);
}

}  // namespace ravnoves::cli
