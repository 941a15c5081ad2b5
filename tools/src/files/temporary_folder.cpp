// SPDX-License-Identifier: MIT
#include "files/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "terminal/failure.h"

namespace lumi::tools
{

std::filesystem::path new_temporary_folder(const std::string& mend)
{
    const char* const named = std::getenv("TMPDIR");  // an empty one is none, as for mktemp(1)
    const std::filesystem::path parent = named == nullptr || *named == 0 ? "/tmp" : named;
    std::error_code ignored;
    if (!std::filesystem::is_directory(parent, ignored))
        throw Failure(parent.string(), "is no folder for temporary files", mend);
    std::string pattern = (parent / "lumi-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        throw Failure(parent.string(), std::string("takes no temporary folder (") + std::strerror(errno) + ")", mend);
    return pattern;
}

}  // namespace lumi::tools
