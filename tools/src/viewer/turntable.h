// SPDX-License-Identifier: MIT
// Reads a folder of pictures that `lumi reference --turntable` wrote, and shows a page in the user's browser.
#pragma once

#include <string>
#include <vector>

namespace lumi::tools
{

// The bytes of NAME-000.png, NAME-001.png, … in order; other files are left out. Throws Failure where the folder holds
// no turntable or more than one, one of its pictures is missing or no PNG, or their sizes differ.
std::vector<std::string> read_turntable(const std::string& folder);

// Writes NAME.html in a new folder for temporary files, and opens it by xdg-open. Returns its path. Throws Failure
// where that cannot be done.
std::string show_in_browser(const std::string& name, const std::string& html);

}  // namespace lumi::tools
