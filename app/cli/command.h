#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace ravnoves::cli {

/// One command of the program: its options, and what it does with them.
class Command {
  public:
    Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
    virtual ~Command() = default;

    /// Checks what the options mean together.
    /// @throws CLI::ParseError
    virtual void check() const {}
    /// @return the exit status
    virtual int run() = 0;
    /// The file that complaints about a fault of ours begin with; may be empty.
    virtual std::string file() const { return {}; }
    bool asked_for() const { return app_ != nullptr && app_->parsed(); }

  protected:
    CLI::App* app_ = nullptr;  ///< its part of the command line
};

std::unique_ptr<Command> make_solve_command(CLI::App& app);
std::unique_ptr<Command> make_study_command(CLI::App& app);
std::unique_ptr<Command> make_methods_command(CLI::App& app);
std::unique_ptr<Command> make_validate_command(CLI::App& app);

}  // namespace ravnoves::cli
