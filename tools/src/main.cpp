// SPDX-License-Identifier: MIT
// The `lumi` command line: subcommands in commands/, exit codes in terminal/failure.h.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <system_error>

#include "commands/commands.h"
#include "commands/help_formatter.h"
#include "commands/pages.h"
#include "commands/parse_problem.h"
#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"
#include "terminal/standard_streams.h"

namespace lumi::tools
{
namespace
{

int report(const char* message, ExitCode code)
{
    std::fprintf(stderr, "lumi: %s\n", message);
    return code;
}

// Which help to read after a wrong call.
std::string help_call(const CLI::App& lumi)
{
    const auto chosen = lumi.get_subcommands();
    return chosen.empty() ? "lumi --help" : "lumi " + chosen.front()->get_name() + " --help";
}

constexpr char kOutOfMemory[] = "out of memory; choose a smaller scene, field or picture, or raise `ulimit -v`";

// CLI11 and TBB allocate in functions that promise not to throw: where memory ends there, the run-time library calls
// this.
[[noreturn]] void on_terminate()
{
    try {
        if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        if (is_work_done() && std::fflush(stdout) == 0) std::_Exit(kExitOk);
        report(kOutOfMemory, kExitFailed);
        std::_Exit(kExitFailed);
    } catch (...) {
        // a defect: what follows says so
    }
    std::abort();
}

int report_parse_error(const CLI::App& lumi, const CLI::ParseError& error)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
        return lumi.exit(error);  // --help or --version: prints to stdout
    const auto rest = lumi.remaining();
    const bool unknown = lumi.get_subcommands().empty() && !rest.empty();
    const std::string problem = unknown ? "there is no subcommand \"" + rest.front() + "\"" : parse_problem(error);
    report((problem + "; see `" + help_call(lumi) + "`").c_str(), kExitUsage);
    return kExitUsage;
}

void describe_program(CLI::App& lumi)
{
    lumi.name("lumi");
    lumi.set_version_flag("--version", LUMI_VERSION);
    lumi.require_subcommand(1);
    lumi.formatter(std::make_shared<HelpFormatter>());
    lumi.footer(
        "Exit codes: 0 done, 1 failed, 2 wrong call, 130 interrupted.\n"
        "Example:\n  lumi bake product.obj -o product.lumi && lumi render product.lumi -o product.png");
}

int run(int argc, char** argv)
{
    CLI::App lumi("Bakes path-traced scenes into fields for microcontrollers, and draws, measures and embeds them.");
    describe_program(lumi);
    for (const auto add : {add_bake, add_merge, add_render, add_reference, add_compare, add_report, add_inspect,
                           add_embed, add_filter, add_bench})
        add(lumi);
    add_pages(lumi);
    const baker::FileGuard guard;
    try {
        lumi.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return report_parse_error(lumi, error);
    } catch (const UsageError& error) {
        return report((std::string(error.what()) + "; see `" + help_call(lumi) + "`").c_str(), kExitUsage);
    } catch (const Interrupted& error) {
        return report(error.what(), kExitInterrupted);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::resource_unavailable_try_again) return report(error.what(), kExitFailed);
        return report(
            "the system gives no further thread; choose fewer --threads, or raise `ulimit -v` and `ulimit -u`",
            kExitFailed);
    } catch (const std::exception& error) {
        return report(error.what(), kExitFailed);
    }
    return kExitOk;
}

int run_guarded(int argc, char** argv)
{
    std::set_terminate(on_terminate);
    occupy_standard_streams();
    catch_interrupts();
    int code = kExitFailed;
    try {
        code = run(argc, argv);
        finish_standard_output();
    } catch (const Failure& error) {
        report(error.what(), kExitFailed);
        return code == kExitOk ? kExitFailed : code;
    } catch (const std::bad_alloc&) {
        return report(kOutOfMemory, kExitFailed);
    }
    return code;
}

}  // namespace
}  // namespace lumi::tools

int main(int argc, char** argv)
{
    return lumi::tools::run_guarded(argc, argv);
}
