// SPDX-License-Identifier: MIT
#include "terminal/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "terminal/failure.h"

namespace lumi::tools
{

void occupy_standard_streams()
{
    // The wrong way round, so that using them fails as it does with a closed stream.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void finish_standard_output()
{
    errno = 0;
    std::cout.flush();
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return;
    const std::string cause = errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : "";
    throw Failure("standard output", "cannot be written" + cause + ", so that what it got is cut",
                  "free some space on that disk, or send it elsewhere");
}

}  // namespace lumi::tools
