// SPDX-License-Identifier: MIT
#include "viewer/browser.h"

#include "files/output_file.h"
#include "terminal/child_program.h"

namespace lumi::tools
{

std::string show_in_browser(const std::string& name, const std::string& html)
{
    constexpr char kMend[] = "install a browser and xdg-utils, or write the page to a file with -o view.html";
    const std::string path = (new_temporary_folder(kMend) / (name + ".html")).string();
    write_output(path, html);
    run_program("xdg-open", {path}, kMend);
    return path;
}

}  // namespace lumi::tools
