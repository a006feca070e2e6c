#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <sstream>
#include <string>

#include "case-file/process_state.h"
#include "command.h"
#include "output.h"

namespace ravnoves::cli {
namespace {

int run(int argc, char** argv) {
    CLI::App app{"Ravnoves, the engine-balancing workbench: solves case files without a display."};
    app.name("ravnoves-cli");  // not the path it was started by
    app.set_version_flag("--version", "ravnoves-cli " RAVNOVES_VERSION);
    app.require_subcommand(1);

    // One line, like every other complaint.
    app.failure_message([&](const CLI::App*, const CLI::Error& error) {
        std::string text = error.what();
        if (error.get_name() == "RequiredError" && argc > 1 && app.get_subcommands().empty()) {
            const std::string word = argv[1];
            text = (word.starts_with('-') ? "unknown option '" : "unknown command '") + word + "'";
        }
        return one_line("ravnoves-cli: " + text + "; --help lists the options") + "\n";
    });

    const std::array<std::unique_ptr<Command>, 4> commands{
        make_solve_command(app), make_study_command(app), make_methods_command(app),
        make_validate_command(app)};
    const auto asked_for = [&]() -> Command& {
        return **std::find_if(commands.begin(), commands.end(),
                              [](const auto& command) { return command->asked_for(); });
    };

    try {
        app.parse(argc, argv);
        asked_for().check();
    } catch (const CLI::ParseError& error) {
        std::ostringstream asked;  // the help or the version
        const int status = app.exit(error, asked);
        return status == 0 ? print(asked.str()) : exit_bad_input;
    }

    Command& command = asked_for();
    try {
        return command.run();
    } catch (const std::bad_alloc&) {
        return complain(command.file(), no_memory);
    } catch (const std::exception& error) {
        complain(command.file(), std::string("internal error: ") + error.what());
        return exit_our_fault;
    }
}

}  // namespace
}  // namespace ravnoves::cli

int main(int argc, char** argv) {
    ravnoves::prepare_process();
    try {
        return ravnoves::cli::run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "ravnoves-cli: %s\n", ravnoves::cli::no_memory);
        return ravnoves::cli::exit_bad_input;
    }
}
