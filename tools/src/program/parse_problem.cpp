// SPDX-License-Identifier: MIT
#include "program/parse_problem.h"

#include <cmath>
#include <cstdlib>

namespace lumi::tools
{

namespace
{

// Why no option that takes a number takes this one.
std::string takes(const std::string& value)
{
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0') return "takes a number";
    if (number < 0 || number != std::floor(number)) return "takes a whole number from 0 on";
    return "takes a smaller number";
}

}  // namespace

std::string parse_problem(const CLI::ParseError& error)
{
    const std::string text = error.what(), start = "Could not convert: ", middle = " = ";
    const size_t at = text.find(middle);
    if (text.compare(0, start.size(), start) != 0 || at == std::string::npos) return text;
    const std::string option = text.substr(start.size(), at - start.size()), value = text.substr(at + middle.size());
    return option + " " + takes(value) + ", not \"" + value + "\"";
}

std::string whole_number(const std::string& word)
{
    return word.empty() || word[0] != '-' ? "" : "takes a whole number from 0 on, not \"" + word + "\"";
}

}  // namespace lumi::tools
