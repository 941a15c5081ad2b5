// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace lumi::tools
{

// A new folder for temporary files; others can neither read it nor put a link in its place. Throws Failure.
std::filesystem::path new_temporary_folder(const std::string& mend);

}  // namespace lumi::tools
