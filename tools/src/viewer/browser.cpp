// SPDX-License-Identifier: MIT
#include "viewer/browser.h"

#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "files/output_file.h"
#include "terminal/failure.h"

extern "C" char** environ;

namespace lumi::tools
{

namespace
{

constexpr char kNoBrowserMend[] = "write the page to a file with -o view.html";

// Others can neither read it nor put a link in its place.
std::filesystem::path new_folder()
{
    std::string pattern = (std::filesystem::temp_directory_path() / "lumi-view-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw Failure(pattern, std::strerror(errno), kNoBrowserMend);
    return pattern;
}

// Ends when the browser has the page.
void open_page(const std::string& path)
{
    constexpr char kOpener[] = "xdg-open";
    std::string program = kOpener, argument = path;
    char* const arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    if (::posix_spawnp(&child, kOpener, nullptr, nullptr, arguments, environ) != 0)
        throw Failure(kOpener, "is not installed, so no browser can be opened", kNoBrowserMend);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw Failure(kOpener, std::strerror(errno), kNoBrowserMend);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw Failure(kOpener, "could not open a browser", kNoBrowserMend);
}

}  // namespace

std::string show_in_browser(const std::string& name, const std::string& html)
{
    const std::string path = (new_folder() / (name + ".html")).string();
    write_output(path, html);
    open_page(path);
    return path;
}

}  // namespace lumi::tools
