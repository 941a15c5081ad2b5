// SPDX-License-Identifier: MIT
// Other programs of this machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumi::tools
{

// Runs a program of PATH with these arguments and waits for its end. Throws Failure where it is not installed or does
// not end with 0; `mend` then says what to do instead.
void run_program(std::string name, std::vector<std::string> arguments, const std::string& mend);

// A new folder for temporary files; others can neither read it nor put a link in its place. Throws Failure.
std::filesystem::path new_temporary_folder(const std::string& mend);

}  // namespace lumi::tools
