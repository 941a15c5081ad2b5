// SPDX-License-Identifier: MIT
#include "program/pages.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "files/output_file.h"
#include "program/choice.h"
#include "program/help_formatter.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

// Text for troff: hyphens that can be copied, and no line that looks like a macro.
std::string troff(const std::string& text)
{
    std::string result;
    bool begins_line = true;
    for (const char c : text) {
        if (begins_line && (c == '.' || c == '\'')) result += "\\&";
        result += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
        begins_line = c == '\n';
    }
    return result;
}

std::string full_name(const CLI::App& app, const char* between)
{
    const CLI::App* const parent = app.get_parent();
    return parent == nullptr ? app.get_name() : full_name(*parent, between) + between + app.get_name();
}

std::string item(const std::string& name, const std::string& rest, const std::string& description)
{
    return ".TP\n\\fB" + troff(name) + "\\fR" + troff(rest) + "\n" + troff(description) + "\n";
}

std::string section(const std::string& title, const std::string& text)
{
    return text.empty() ? "" : ".SH " + title + "\n" + text;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string arguments_section(const CLI::App& app, bool positional)
{
    const HelpFormatter formatter;
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional() != positional) continue;
        text += item(option->get_name(positional, true), formatter.make_option_opts(option), option->get_description());
    }
    return section(positional ? "ARGUMENTS" : "OPTIONS", text);
}

std::string commands_section(const CLI::App& app)
{
    std::string text;
    for (const CLI::App* command : commands_of(app))
        text += item(full_name(*command, "-") + "(1)", "", command->get_description());
    return section("COMMANDS", text);
}

std::string synopsis(const CLI::App& app)
{
    std::string text = ".B " + full_name(app, " ") + "\n[OPTIONS]";
    for (const CLI::Option* option : app.get_options())
        if (option->get_positional()) text += " " + troff(option->get_name(true));
    return text + (commands_of(app).empty() ? "" : " COMMAND") + "\n";
}

// The words that an option takes; none if they are not a list.
std::vector<std::string> choices_of(CLI::Option& option)
{
    const std::string type = option.get_type_name();
    const size_t begin = type.find('{'), end = type.find('}');
    if (begin != std::string::npos && end != std::string::npos)
        return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
    return choice_words(option);
}

bool is_number(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    return type.find("INT") != std::string::npos || type.find("FLOAT") != std::string::npos;
}

std::vector<std::string> flags_of(const CLI::Option& option)
{
    std::vector<std::string> flags;
    for (const std::string& name : option.get_lnames()) flags.push_back("--" + name);
    for (const std::string& name : option.get_snames()) flags.push_back("-" + name);
    return flags;
}

void add_flags(const CLI::App& app, std::vector<std::string>& flags)
{
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& flag : flags_of(*option))
            if (std::find(flags.begin(), flags.end(), flag) == flags.end()) flags.push_back(flag);
    }
}

std::string flags_of(const CLI::App& program)
{
    std::vector<std::string> flags;
    add_flags(program, flags);
    return CLI::detail::join(flags, " ");
}

// Of a command and of those that it has, each once.
std::string flags_of_command(const CLI::App& command)
{
    std::vector<std::string> flags;
    add_flags(command, flags);
    for (const CLI::App* below : commands_of(command)) add_flags(*below, flags);
    return CLI::detail::join(flags, " ");
}

// Cases of what follows an option: one of its words, nothing for a number; files where no case says otherwise. After a
// command that has commands of its own, those.
std::string value_cases(const CLI::App& command, const std::string& name)
{
    std::string text, names;
    for (const CLI::App* below : commands_of(command)) {
        names += below->get_name() + " ";
        text += value_cases(*below, name);
    }
    if (!names.empty())
        text += "    " + name + "," + name + ") words=\"" + names + flags_of_command(command) + "\" ;;\n";
    for (const CLI::Option* option : command.get_options()) {
        const std::vector<std::string> words = choices_of(const_cast<CLI::Option&>(*option));
        if (words.empty() && !is_number(*option)) continue;
        std::vector<std::string> patterns;
        for (const std::string& flag : flags_of(*option)) patterns.push_back(name + "," + flag);
        if (patterns.empty()) continue;
        text += "    " + CLI::detail::join(patterns, "|") + ") words=\"" + CLI::detail::join(words, " ") +
                "\" only=yes ;;\n";
    }
    return text;
}

constexpr char kCompletionBegin[] = R"(# bash completion of lumi, written by `lumi --pages`
_lumi() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words='' flags='' only=''
  [[ $word != = ]] || word=''
  [[ $before != = ]] || before=${COMP_WORDS[COMP_CWORD-2]}
)";
constexpr char kCompletionEnd[] = R"(  if ((COMP_CWORD == 1)) || [[ -n $words ]]; then
    only=yes
  elif [[ -z $only && $word == -* ]]; then
    words=$flags only=yes
  fi
  COMPREPLY=()
  if [[ -n $only ]]; then
    compopt +o default 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  fi
}
complete -o default -F _lumi lumi
)";

void write_pages(const CLI::App& lumi, const std::filesystem::path& share)
{
    std::vector<std::pair<std::filesystem::path, std::string>> files = {
        {share / "bash-completion" / "completions" / "lumi", bash_completion(lumi)},
        {share / "man" / "man1" / "lumi.1", man_page(lumi)}};
    const auto add = [&](const CLI::App& app, const auto& add_below) -> void {
        for (const CLI::App* command : commands_of(app)) {
            files.emplace_back(share / "man" / "man1" / (full_name(*command, "-") + ".1"), man_page(*command));
            add_below(*command, add_below);
        }
    };
    add(lumi, add);
    std::vector<Output> outputs;
    for (const auto& [path, text] : files) {
        std::error_code error;
        std::filesystem::create_directories(path.parent_path(), error);
        if (error) throw Failure(path.parent_path().string(), error.message(), "choose another --pages folder");
        outputs.push_back({path.string(), text});
    }
    write_outputs(outputs);
}

}  // namespace

std::string man_page(const CLI::App& app)
{
    std::string title = full_name(app, "-");
    for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const bool is_program = app.get_parent() == nullptr;
    return ".TH " + title + " 1 \"\" \"lumi " LUMI_VERSION "\" LumiPath\n" +
           section("NAME", troff(full_name(app, "-")) + " \\- " + troff(app.get_description()) + "\n") +
           section("SYNOPSIS", synopsis(app)) + arguments_section(app, true) + arguments_section(app, false) +
           commands_section(app) + section("NOTES", ".nf\n" + troff(app.get_footer()) + "\n.fi\n") +
           (is_program ? "" : section("SEE ALSO", ".BR lumi (1)\n"));
}

std::string bash_completion(const CLI::App& lumi)
{
    std::string names, cases, flags;
    for (const CLI::App* command : commands_of(lumi)) {
        names += command->get_name() + " ";
        cases += value_cases(*command, command->get_name());
        flags += "    " + command->get_name() + ") flags=\"" + flags_of_command(*command) + "\" ;;\n";
    }
    return std::string(kCompletionBegin) + "  ((COMP_CWORD > 1)) || words=\"" + names + flags_of(lumi) + "\"\n" +
           "  case ${COMP_WORDS[1]},$before in\n" + cases + "  esac\n  case ${COMP_WORDS[1]} in\n" + flags +
           "  esac\n" + kCompletionEnd;
}

void add_pages(CLI::App& lumi)
{
    const auto write = [&lumi](const std::string& folder) {
        write_pages(lumi, folder);
        throw CLI::Success();
    };
    lumi.add_option_function<std::string>("--pages", write, "Write man pages and bash completion into a `share` folder")
        ->type_name("FOLDER");
}

}  // namespace lumi::tools
