// SPDX-License-Identifier: MIT
// Headings in the help of a command.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

namespace lumi::tools
{

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
    ~OptionGroup()
    {
        const std::vector<CLI::Option*> options = command_.get_options([](CLI::Option*) { return true; });
        for (size_t k = begin_; k < options.size(); ++k)
            if (!options[k]->get_positional()) options[k]->group(heading_);
    }

private:
    CLI::App& command_;
    const std::string heading_;
    const size_t begin_;
};

}  // namespace lumi::tools
