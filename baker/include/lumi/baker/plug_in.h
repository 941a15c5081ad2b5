// SPDX-License-Identifier: MIT
// Modules that a program loads only when it needs them, so that it starts without the libraries behind them.
#pragma once

#include <stdexcept>
#include <string>

namespace lumi::baker
{

// A module that is not there, does not load, or lacks the symbol: "PATH: PROBLEM".
struct NoPlugIn : std::runtime_error {
    NoPlugIn(const std::string& of, const std::string& what)
        : std::runtime_error(of + ": " + what), path(of), problem(what)
    {
    }

    std::string path, problem;
};

// The address of `symbol` in the module `file`, which lies beside the program, or where `cmake --install` puts modules.
// `part` is what the program calls it, such as "its learned filter". The module stays loaded. Throws NoPlugIn.
void* symbol_of_plug_in(const std::string& file, const char* symbol, const std::string& part);

}  // namespace lumi::baker
