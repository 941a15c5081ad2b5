// SPDX-License-Identifier: MIT
// Options that take one word of a list.
#pragma once

#include <CLI/CLI.hpp>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace lumi::tools
{

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

// "a, b or c".
template <class Value>
std::string words_of(const Choices<Value>& choices)
{
    std::string text;
    for (size_t i = 0; i < choices.size(); ++i)
        text += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i].first;
    return text;
}

// Before the words in the name of a validator that lets all pass: where CLI11 keeps a text for us.
constexpr char kChoicePrefix[] = "choices: ";

// Adds an option that sets `value`, which must outlive the parse; another word is refused with the list.
template <class Value>
void add_choice(CLI::App& command, const std::string& name, Value& value, const Choices<Value>& choices,
                const std::string& type, const std::string& description)
{
    std::string listed;
    for (const auto& choice : choices) listed += (listed.empty() ? "" : " ") + choice.first;
    const auto set = [name, choices, &value](const std::string& word) {
        for (const auto& [choice, meaning] : choices)
            if (choice == word) {
                value = meaning;
                return;
            }
        throw CLI::ValidationError(name, "takes " + words_of(choices) + ", not \"" + word + "\"");
    };
    command.add_option_function<std::string>(name, set, description)
        ->type_name(type)
        ->check(CLI::Validator([](std::string&) { return std::string(); }, "", kChoicePrefix + listed));
}

// The words of an option of add_choice; none of another option.
inline std::vector<std::string> choice_words(CLI::Option& option)
{
    try {
        const std::string name = option.get_validator(0)->get_name();
        if (name.rfind(kChoicePrefix, 0) == 0) return CLI::detail::split(name.substr(std::strlen(kChoicePrefix)), ' ');
    } catch (const CLI::OptionNotFound&) {
        // it has no validator
    }
    return {};
}

}  // namespace lumi::tools
