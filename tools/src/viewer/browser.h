// SPDX-License-Identifier: MIT
// Shows a page in the user's browser.
#pragma once

#include <string>

namespace lumi::tools
{

// Writes NAME.html in a new folder for temporary files, and opens it by xdg-open. Returns its path. Throws Failure
// where that cannot be done.
std::string show_in_browser(const std::string& name, const std::string& html);

}  // namespace lumi::tools
