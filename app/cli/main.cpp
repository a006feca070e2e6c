#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "case-file/case_file.h"
#include "case-file/input_error.h"

namespace {

using ravnoves::CaseContext;
using ravnoves::InputError;
using ravnoves::Json;

constexpr int exit_solved = 0;
constexpr int exit_our_fault = 1;
constexpr int exit_bad_input = 2;

void complain(const std::string& file, const std::string& text) {
    std::cerr << (file.empty() ? text : file + ": " + text) << '\n';
}

int solve_file(const std::string& case_path, const std::string& result_path) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(result_path, ignored) &&
        std::filesystem::equivalent(case_path, result_path, ignored)) {
        complain(result_path, "is the case itself; the result must go to another file");
        return exit_bad_input;
    }
    std::string text;
    try {
        const ravnoves::CaseFile file = ravnoves::parse_case(ravnoves::read_text_file(case_path));
        const CaseContext context{std::filesystem::path(case_path).parent_path()};
        text = ravnoves::solve_case(file, context).dump(2) + "\n";
    } catch (const InputError& error) {
        complain(case_path, error.what());
        return exit_bad_input;
    }
    if (result_path.empty()) {
        std::cout << text << std::flush;
        if (!std::cout) {
            complain("ravnoves-cli",
                     std::string("standard output cannot be written: ") + std::strerror(errno));
            return exit_bad_input;
        }
        return exit_solved;
    }
    try {
        ravnoves::write_text_file(result_path, text);
    } catch (const InputError& error) {
        complain(result_path, error.what());
        return exit_bad_input;
    }
    return exit_solved;
}

int solve_batch(std::istream& in, std::ostream& out) {
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) {
            continue;
        }
        Json answer;
        try {
            answer = ravnoves::solve_case(ravnoves::parse_case(line), CaseContext{});
        } catch (const std::exception& error) {  // a bad line is answered in its place
            answer = Json{{"error", error.what()}, {"line", number}};
        }
        out << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
        if (!out) {
            complain("ravnoves-cli",
                     std::string("standard output cannot be written: ") + std::strerror(errno));
            return exit_bad_input;
        }
    }
    return exit_solved;
}

}  // namespace

int main(int argc, char** argv) {
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
        return "ravnoves-cli: " + text + "; run with --help for what there is\n";
    });

    CLI::App* solve = app.add_subcommand(
        "solve", "Solve a case file and print its result, as JSON, on standard output");
    solve->footer(
        "Exit status: 0 solved (a design that cannot exist is a result that says so),\n"
        "2 bad input, named on standard error; nothing is written then.\n");
    std::string case_path;
    std::string result_path;
    bool batch = false;
    CLI::Option* case_option = solve->add_option("CASE", case_path, "Case file (JSON)");
    case_option->type_name("");
    CLI::Option* output_option =
        solve->add_option("-o,--output", result_path, "Write the result to this file instead");
    output_option->type_name("FILE");
    solve
        ->add_flag("--batch", batch,
                   "Read one case per line from standard input, print one result per line")
        ->excludes(case_option)
        ->excludes(output_option);

    try {
        app.parse(argc, argv);
        if (solve->parsed() && !batch && case_path.empty()) {
            throw CLI::RequiredError("CASE or --batch");
        }
    } catch (const CLI::ParseError& error) {
        const int status = app.exit(error);
        return status == 0 ? exit_solved : exit_bad_input;
    }

    try {
        if (batch) {
            std::ios::sync_with_stdio(false);
            return solve_batch(std::cin, std::cout);
        }
        return solve_file(case_path, result_path);
    } catch (const std::exception& error) {
        complain(case_path, std::string("internal error: ") + error.what());
        return exit_our_fault;
    }
}
