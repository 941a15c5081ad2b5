// SPDX-License-Identifier: MIT
// Checks and choices of the words that options take, and headings in the help of a command.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lumi::tools
{

// Checks of an option's word, for CLI::Option::check: empty if all is well, otherwise "takes ..., not ...". The whole
// word is a decimal number, without spaces. CLI11's own ranges let "nan" pass, and its whole numbers wrap or saturate.
using WordCheck = std::function<std::string(const std::string&)>;

WordCheck whole_number(uint64_t least, uint64_t most);
// The word is a finite number.
WordCheck number(double least, double most);
WordCheck any_number();
WordCheck one_of(const std::vector<int>& numbers);

// The word is the name of a page, or of a device or a pipe.
std::string wrong_page_name(const std::string& word);

// The most light paths for a texel or a pixel, and the most threads, that options take.
constexpr uint64_t kMostPaths = uint64_t{1} << 24;
constexpr uint64_t kMostThreads = 1024;

// Adds to every option and argument of `app` and its subcommands that takes words: none is empty or has a control
// character, such as the line break of a file's name that a script cut wrongly. None is "-", which would be the name of
// a file.
void require_plain_words(CLI::App& app);

// Says what is wrong in our words, "NAME takes ..." where a check or a choice failed.
std::string parse_problem(const CLI::ParseError& error);

// Adds an option that takes words with commas between them, and may be given again; `set` gets each word and throws
// CLI::ValidationError for a wrong one.
CLI::Option* add_list(CLI::App& command, const std::string& name, const std::function<void(const std::string&)>& set,
                      const std::string& description);

// The words of an option that takes one of a list.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

// Returns "a, b or c".
template <class Value>
std::string words_of(const Choices<Value>& choices)
{
    std::string text;
    for (size_t i = 0; i < choices.size(); ++i)
        text += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i].first;
    return text;
}

// Adds an option that sets `value`, which must outlive the parse; another word is refused with the list.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& value, const Choices<Value>& choices,
                        const std::string& description)
{
    std::string listed;
    for (const auto& choice : choices) listed += (listed.empty() ? "" : "|") + choice.first;
    const auto set = [name, choices, &value](const std::string& word) {
        for (const auto& [choice, meaning] : choices)
            if (choice == word) {
                value = meaning;
                return;
            }
        throw CLI::ValidationError(name, "takes " + words_of(choices) + ", not \"" + word + "\"");
    };
    return command.add_option_function<std::string>(name, set, description)->type_name(listed);
}

// The options that a command gets while this lives stand under one heading of its help.
class OptionGroup
{
public:
    OptionGroup(CLI::App& command, std::string heading)
        : command_(command), heading_(std::move(heading)), begin_(command.get_options().size())
    {
    }
    OptionGroup(const OptionGroup&) = delete;
    OptionGroup& operator=(const OptionGroup&) = delete;
    // Does nothing while an exception passes: CLI11 then holds a null pointer for the option that it could not make.
    ~OptionGroup() noexcept(false)
    {
        if (std::uncaught_exceptions() > exceptions_) return;
        const std::vector<CLI::Option*> options = command_.get_options([](CLI::Option*) { return true; });
        for (size_t k = begin_; k < options.size(); ++k)
            if (!options[k]->get_positional()) options[k]->group(heading_);
    }

private:
    CLI::App& command_;
    const std::string heading_;
    const size_t begin_;
    const int exceptions_ = std::uncaught_exceptions();
};

}  // namespace lumi::tools
