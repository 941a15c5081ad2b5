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
    std::error_code missing;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(missing);
    if (missing) {
        const char* const named = std::getenv("TMPDIR");
        throw Failure(named == nullptr ? "/tmp" : named, "is no folder for temporary files", mend);
    }
    std::string pattern = (parent / "lumi-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        throw Failure(parent.string(), std::string("takes no temporary folder (") + std::strerror(errno) + ")", mend);
    return pattern;
}

}  // namespace lumi::tools
