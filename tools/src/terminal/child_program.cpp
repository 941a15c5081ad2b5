// SPDX-License-Identifier: MIT
#include "terminal/child_program.h"

#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "terminal/failure.h"

extern "C" char** environ;

namespace lumi::tools
{

void run_program(std::string name, std::vector<std::string> arguments, const std::string& mend)
{
    std::vector<char*> words = {name.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    pid_t child = 0;
    if (::posix_spawnp(&child, name.c_str(), nullptr, nullptr, words.data(), environ) != 0)
        throw Failure(name, "this program is not installed", mend);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw Failure(name, std::strerror(errno), mend);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Failure(name, "this program failed", mend);
}

std::filesystem::path new_temporary_folder(const std::string& mend)
{
    std::error_code missing;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(missing);
    if (missing) {
        const char* const named = std::getenv("TMPDIR");
        throw Failure(named == nullptr ? "/tmp" : named, "is no folder for temporary files", mend);
    }
    std::string pattern = (parent / "lumi-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw Failure(pattern, std::strerror(errno), mend);
    return pattern;
}

}  // namespace lumi::tools
