// SPDX-License-Identifier: MIT
#include "program/wrong_call.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "program/option_checks.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

// Wagner and Fischer's table; letters that changed places are one edit, as Damerau counts them.
size_t edits_between(const std::string& a, const std::string& b)
{
    std::vector<std::vector<size_t>> edits(a.size() + 1, std::vector<size_t>(b.size() + 1));
    for (size_t i = 0; i <= a.size(); ++i) {
        for (size_t j = 0; j <= b.size(); ++j) {
            size_t& least = edits[i][j] = std::max(i, j);
            if (i == 0 || j == 0) continue;
            const size_t exchanged = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            least = std::min({exchanged, edits[i][j - 1] + 1, edits[i - 1][j] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least = std::min(least, edits[i - 2][j - 2] + 1);
        }
    }
    return edits.back().back();
}

// Finds the word that fewest edits of a letter lead to (put in, left out, exchanged, or two that changed places): at
// most one for three letters, though one is always allowed. Empty if none is that near; the first of several.
std::string nearest_word(const std::string& typed, const std::vector<std::string>& words)
{
    constexpr size_t kLettersPerEdit = 3;
    size_t least = std::max<size_t>(1, typed.size() / kLettersPerEdit) + 1;
    std::string nearest;
    for (const std::string& word : words)
        if (const size_t edits = edits_between(typed, word); edits < least) {
            least = edits;
            nearest = word;
        }
    return nearest;
}

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

// " (did you mean --orbit?)" where one of the words is near.
std::string meant(const std::string& typed, const std::vector<std::string>& words)
{
    const std::string nearest = nearest_word(typed, words);
    return nearest.empty() ? "" : " (did you mean " + nearest + "?)";
}

std::string no_subcommand(const CLI::App& app, const std::string& name)
{
    return "there is no subcommand \"" + name + "\"" + meant(name, names_of(app.get_subcommands(nullptr)));
}

}  // namespace

std::string problem_of(const CLI::App& app, const CLI::ParseError& error)
{
    const auto rest = app.remaining(true);
    const std::string first = rest.empty() ? "" : rest.front();
    if (!first.empty() && first[0] == '-') return "there is no option " + first + meant(first, options_of(app));
    if (!first.empty() && app.get_subcommands().empty()) return no_subcommand(app, first);
    return parse_problem(error);
}

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
        std::fputs(app.get_formatter()->make_help(described, usage, CLI::AppFormatMode::Normal).c_str(), stdout);
    });
}

}  // namespace lumi::tools
