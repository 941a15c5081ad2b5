// SPDX-License-Identifier: MIT
// Every option of every command against words that no option takes, found from the help texts; and outputs in places
// where nothing can be written, or where a link leads.
#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

namespace
{

using test::Arguments;
using test::joined;
using test::lumi;
using test::Outcome;

// A command with inputs that do not exist: what options take is checked before they are read.
struct Command {
    Arguments name, inputs;
};
const std::vector<Command> kCommands = {
    {{"bake"}, {"none.obj"}},
    {{"merge"}, {"none.shard"}},
    {{"render"}, {"none.lumi"}},
    {{"view"}, {"none.lumi"}},
    {{"reference"}, {"none.obj"}},
    {{"compare"}, {"none.png", "nor.png"}},
    {{"report"}, {"none.obj", "none.lumi"}},
    {{"inspect"}, {"none.lumi"}},
    {{"embed"}, {"none.lumi", "-o", "none.bin"}},
    {{"filter", "train"}, {"none.obj", "none.lumi"}},
    {{"filter", "judge"}, {"none.weights", "none.lumi", "none.obj"}},
};

// Options that take a word, and what the help calls it. Those that several commands share are tried once.
std::map<std::string, std::string> options_of(const Command& command, std::set<std::string>& shared)
{
    static const std::regex line("  (?:-[a-z],)?(--[a-z-]+)(?: ([^ =:]+))?.*");
    std::map<std::string, std::string> options;
    std::istringstream help(lumi(joined(command.name, {"--help"})).out);
    std::smatch match;
    for (std::string text; std::getline(help, text);)
        if (std::regex_match(text, match, line) && match[2].matched && shared.insert(match.str()).second)
            options[match[1]] = match[2];
    return options;
}

bool is_text(const std::string& type)
{
    static const std::set<std::string> names = {"NAME", "TEXT", "PATH", "FILE", "DIR", "WEIGHTS"};
    return names.count(type) != 0 || type.find('.') != std::string::npos;
}

std::string subcommands(const Arguments& name)
{
    std::string text = lumi(joined(name, {"--help"})).out, names;
    std::istringstream lines(text.substr(std::min(text.size(), text.find("Subcommands:\n"))));
    static const std::regex line("  ([a-z]+) .*");
    std::smatch match;
    for (std::string each; std::getline(lines, each);)
        if (std::regex_match(each, match, line) && match[1] != "lumi") names += match.str(1) + " ";
    return names;
}

std::string last_names(size_t words)
{
    std::string names, before;
    for (const Command& command : kCommands)
        if (words <= command.name.size() && command.name[words - 1] != before)
            names += (before = command.name[words - 1]) + " ";
    return names;
}

}  // namespace

TEST_CASE("no option takes an empty word, a line break, a hyphen, or a number that is none")
{
    REQUIRE(subcommands({}) == last_names(1) + "help ");
    REQUIRE(subcommands({"filter"}) == last_names(2));
    const test::TemporaryFolder folder;
    std::set<std::string> shared;
    size_t tried = 0;
    for (const Command& command : kCommands)
        for (const auto& [option, type] : options_of(command, shared))
            for (const std::string word : {"", "a\nb", "-", "nan", "inf", "-1"}) {
                const Outcome outcome = lumi(joined(joined(command.name, command.inputs), {option, word}));
                INFO(command.name.back() << " " << option << " \"" << word << "\": " << outcome.err);
                const bool is_no_number = word == "nan" || word == "inf";
                const bool is_wrong = word.empty() || word == "a\nb" || word == "-" || (is_no_number && !is_text(type));
                CHECK((outcome.code == 2 || (!is_wrong && outcome.code == 1)));
                CHECK_THAT(outcome.err, Catch::StartsWith("lumi: "));
                if (is_wrong) CHECK_THAT(outcome.err, Catch::Contains(option));
                CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
                ++tried;
            }
    CHECK(tried > 200);
}

namespace
{

// A call of each command that writes a file, with its output at the end.
struct Writer {
    Arguments call;
    std::string ending;
};

std::vector<Writer> writers(const test::TemporaryFolder& folder)
{
    const std::string field = folder / "f.lumi";
    return {{{"render", field, "--size", "8x8", "-o"}, ".png"},
            {{"embed", field, "-o"}, ".c"},
            {{"bake", test::kScene, "--origins", "8", "--directions", "8", "--spp", "1", "-o"}, ".lumi"},
            {{"bake", test::kScene, "--fit", "2kB", "--origins", "8", "--plan-only", "--plan"}, ".json"}};
}

}  // namespace

TEST_CASE("an output follows a link that leads nowhere yet, and refuses one that leads to itself")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    for (const Writer& writer : writers(folder)) {
        const std::string link = folder / ("link" + writer.ending), circle = folder / ("circle" + writer.ending),
                          target = folder / ("target" + writer.ending);
        std::filesystem::create_symlink("target" + writer.ending, link);
        std::filesystem::create_symlink("circle" + writer.ending, circle);
        done(lumi(joined(writer.call, {link})));
        CHECK(std::filesystem::is_symlink(link));
        CHECK(std::filesystem::is_regular_file(target));
        check_refused(lumi(joined(writer.call, {circle})), 1, "remove that link");
        CHECK(std::filesystem::is_symlink(circle));
    }
}

TEST_CASE("a cache behind a link to itself is named, with what to do")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "s.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string circle = folder / "circle";
    std::filesystem::create_symlink("circle", circle);
    check_refused(lumi({"report", folder / "s.obj", "--for", "rp2040", "--cache", circle, "-o", folder / "r.html"}), 1,
                  Catch::Contains("lumi: " + circle + "/") && Catch::Contains("symbolic links); check the path"));
}

TEST_CASE("Ctrl-C ends a command that waits for a pipe's other end")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    const std::string pipe = folder / "pipe.png";
    REQUIRE(mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR) == 0);
    const std::string render = std::string(LUMI_PROGRAM) + " render " + folder / "f.lumi" + " --size 8x8 -o ";
    // Without --foreground timeout sends a second signal, to its group, and that one ends the process without a word.
    const std::string interrupted = "timeout --foreground --preserve-status -k 20 -s INT 3 ";
    for (const std::string& call : {render + pipe, render + folder / "o.png" + " --pose " + pipe})
        check_refused(test::run_program({"sh", "-c", interrupted + call}), 130, "interrupted");
}

TEST_CASE("lumi embed refuses a pipe in its header's place and does not wait for it")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    const std::string header = folder / "o.h";
    REQUIRE(mkfifo(header.c_str(), S_IRUSR | S_IWUSR) == 0);
    check_refused(test::run_program(
                      {"timeout", "-s", "KILL", "20", LUMI_PROGRAM, "embed", folder / "f.lumi", "-o", folder / "o.c"}),
                  1, header + ": is a folder, a device or a pipe; choose another name for");
}

TEST_CASE("a limit of the size of files is told, and no file is left")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    const std::string call =
        std::string("ulimit -f 1; exec ") + LUMI_PROGRAM + " embed " + folder / "f.lumi" + " -o " + folder / "field.c";
    check_refused(test::run_program({"sh", "-c", call}), 1, "raise `ulimit -f`");
    CHECK(folder.entries() == 1);
}

}  // namespace lumi::tools
