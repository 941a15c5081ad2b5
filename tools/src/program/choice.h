// SPDX-License-Identifier: MIT
// Options that take one word of a list.
#pragma once

#include <CLI/CLI.hpp>
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

// Adds an option that sets `value`, which must outlive the parse; another word is refused with the list.
template <class Value>
void add_choice(CLI::App& command, const std::string& name, Value& value, const Choices<Value>& choices,
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
    command.add_option_function<std::string>(name, set, description)->type_name(listed);
}

}  // namespace lumi::tools
