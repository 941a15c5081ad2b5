// SPDX-License-Identifier: MIT
#include "program/program.h"

#include <fcntl.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "lumi/baker/file_guard.h"
#include "lumi/host/nearest_word.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

// These say what a program answers to a call that it does not understand, and print its help.

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands)
{
    std::vector<std::string> names;
    for (const CLI::App* command : commands) names.push_back(command->get_name());
    return names;
}

// Names the options of the command that was chosen last.
std::vector<std::string> options_of(const CLI::App& app)
{
    const auto chosen = app.get_subcommands();
    if (!chosen.empty()) return options_of(*chosen.front());
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    return names;
}

std::string no_subcommand(const CLI::App& app, const std::string& name)
{
    return "there is no subcommand \"" + name + "\"" + host::meant(name, names_of(app.get_subcommands(nullptr)));
}

// Says what is wrong, and for a mistyped command or option which one may be meant.
std::string problem_of(const CLI::App& app, const CLI::ParseError& error)
{
    const auto rest = app.remaining(true);
    const std::string first = rest.empty() ? "" : rest.front();
    if (!first.empty() && first[0] == '-') return "there is no option " + first + host::meant(first, options_of(app));
    const CLI::App* chosen = &app;
    while (!chosen->get_subcommands().empty()) chosen = chosen->get_subcommands().front();
    const bool has_subcommands = !chosen->get_subcommands(nullptr).empty();
    if (!first.empty() && has_subcommands) return no_subcommand(*chosen, first);
    return first.empty() ? parse_problem(error) : "there is no place for the argument \"" + first + "\"";
}

// Adds `program help` and `program help COMMAND`. Call after all other commands were added.
void add_help_command(CLI::App& app, const std::string& program)
{
    const std::string first = app.get_subcommands(nullptr).front()->get_name();
    auto name = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("help", "Print the help of a command");
    command->add_option("COMMAND", *name, "A command");
    command->footer("Example:\n  " + program + " help " + first);
    command->callback([&app = static_cast<const CLI::App&>(app), name] {
        const CLI::App* described = &app;
        std::string usage = app.get_name();
        for (const CLI::App* each : app.get_subcommands(nullptr))
            if (each->get_name() == *name) described = each;
        if (described == &app && !name->empty()) throw UsageError(no_subcommand(app, *name));
        if (described != &app) usage += " " + *name;
        print(stdout, "%s", app.get_formatter()->make_help(described, usage, CLI::AppFormatMode::Normal).c_str());
    });
}

// It makes help texts fit a terminal. tools/packaging/pages.py reads them.
class HelpFormatter : public CLI::Formatter
{
public:
    HelpFormatter();
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
};

constexpr size_t kOptionColumns = 36, kDescriptionColumns = 64;

// Puts line breaks in place of spaces where a line would be longer than `columns`; longer words stay whole.
std::string wrapped(const std::string& text, size_t columns)
{
    std::istringstream words(text);
    std::string result, word;
    size_t length = 0;
    while (words >> word) {
        const bool fits = length == 0 || length + 1 + word.size() <= columns;
        if (length > 0) result += fits ? ' ' : '\n';
        length = fits && length > 0 ? length + 1 + word.size() : word.size();
        result += word;
    }
    return result;
}

HelpFormatter::HelpFormatter()
{
    column_width(kOptionColumns);
    label("REQUIRED", "(required)");
    label("TEXT", "");
}

// At least two spaces stand before a description.
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const
{
    return CLI::Formatter::make_option_opts(option) + " ";
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const
{
    return wrapped(CLI::Formatter::make_option_desc(option), kDescriptionColumns);
}

const char* program_name = "lumi";  // in messages

// A stream that the caller closed (`lumi … >&-`) stays unusable, but its number is taken: no file that a command opens
// can get it, and receive what is meant for the stream.
void occupy_standard_streams()
{
    // The wrong way round, so that using them fails as it does with a closed stream.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

// Throws Failure if something that was printed to standard output did not arrive there.
void finish_standard_output()
{
    errno = 0;
    std::cout.flush();
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return;
    const std::string cause = errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : "";
    throw Failure("standard output", "cannot be written" + cause + ", so that what it got is cut",
                  "free some space on that disk, or send it elsewhere");
}

int report(const char* message, ExitCode code)
{
    print(stderr, "%s: %s\n", program_name, message);
    return code;
}

// Which help to read after a wrong call.
std::string help_call(const CLI::App& app)
{
    const auto chosen = app.get_subcommands();
    const std::string name = program_name;
    return chosen.empty() ? name + " --help" : name + " " + chosen.front()->get_name() + " --help";
}

constexpr char kOutOfMemory[] = "out of memory; choose a smaller scene, field or picture, or raise `ulimit -v`";

constexpr char kNoThread[] =
    "the system gives no further thread; choose fewer --threads, or raise `ulimit -v` and `ulimit -u`";

// CLI11 and TBB allocate in functions that promise not to throw, and TBB begins threads there: where memory or threads
// end, the run-time library calls this.
[[noreturn]] void on_terminate()
{
    const auto leave = [](const char* message) {
        if (is_work_done() && std::fflush(stdout) == 0) std::_Exit(kExitOk);
        report(message, kExitFailed);
        std::_Exit(kExitFailed);
    };
    try {
        if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        leave(kOutOfMemory);
    } catch (const std::exception& error) {  // TBB says no more than the words of the system
        if (std::strstr(error.what(), std::strerror(EAGAIN)) != nullptr) leave(kNoThread);
    } catch (...) {
        // a defect: what follows says so
    }
    std::abort();
}

int report_parse_error(const CLI::App& app, const CLI::ParseError& error)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
        return app.exit(error);  // --help or --version: prints to stdout
    report((problem_of(app, error) + "; see `" + help_call(app) + "`").c_str(), kExitUsage);
    return kExitUsage;
}

// In the order in which CLI11 takes them, the last first. Behind "--" no word is an option, as everywhere: what begins
// with a hyphen there is a file.
std::vector<std::string> words_of(int argc, char** argv)
{
    std::vector<std::string> words(argv + 1, argv + argc);
    const auto mark = std::find(words.begin(), words.end(), "--");
    for (auto word = mark; word != words.end(); ++word)
        if (word->rfind('-', 0) == 0) word->insert(0, "./");
    if (mark != words.end()) words.erase(mark);
    std::reverse(words.begin(), words.end());
    return words;
}

int run(const std::function<void(CLI::App&)>& describe, int argc, char** argv)
{
    CLI::App app;
    app.name(program_name);
    app.require_subcommand(1);
    app.formatter(std::make_shared<HelpFormatter>());
    describe(app);
    add_help_command(app, program_name);
    require_plain_words(app);
    const baker::FileGuard guard;
    try {
        app.parse(words_of(argc, argv));
    } catch (const CLI::ParseError& error) {
        return report_parse_error(app, error);
    } catch (const UsageError& error) {
        return report((std::string(error.what()) + "; see `" + help_call(app) + "`").c_str(), kExitUsage);
    } catch (const Interrupted& error) {
        return report(error.what(), kExitInterrupted);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::filesystem::filesystem_error& error) {
        const std::string place = error.path1().empty() ? "the folder for temporary files" : error.path1().string();
        const Failure failure(place, "cannot be looked up (" + error.code().message() + ")", "check the path");
        return report(failure.what(), kExitFailed);
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::resource_unavailable_try_again) return report(error.what(), kExitFailed);
        return report(kNoThread, kExitFailed);
    } catch (const std::exception& error) {
        if (interrupt_flag()) return report(Interrupted().what(), kExitInterrupted);  // the wait failed
        return report(error.what(), kExitFailed);
    }
    return kExitOk;
}

}  // namespace

int run_program(const char* name, const std::function<void(CLI::App&)>& describe, int argc, char** argv)
{
    program_name = name;
    std::set_terminate(on_terminate);
    occupy_standard_streams();
    catch_interrupts();
    int code = kExitFailed;
    try {
        code = run(describe, argc, argv);
        finish_standard_output();
    } catch (const Failure& error) {
        report(error.what(), kExitFailed);
        return code == kExitOk ? kExitFailed : code;
    } catch (const std::bad_alloc&) {
        return report(kOutOfMemory, kExitFailed);
    }
    return code;
}

}  // namespace lumi::tools
