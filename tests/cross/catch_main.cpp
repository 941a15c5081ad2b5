// SPDX-License-Identifier: MIT
// Runs Catch2 on an emulated board: newlib's files go through semihosting (librdimon), the result is the exit code.
#define CATCH_CONFIG_RUNNER
#include <cerrno>
#include <cstdio>
#include <iostream>

#include <catch2/catch.hpp>

#include "lumi/mps2/board.h"

extern "C" {

void initialise_monitor_handles();  // librdimon defines it

void lumi_before_constructors()
{
    initialise_monitor_handles();
}

// newlib names it and libstdc++'s random_device asks for it; a board in an emulator has none to give.
int getentropy(void*, size_t)
{
    errno = ENOSYS;
    return -1;
}
}

int main(int argc, char** argv)
{
    const int failures = Catch::Session().run(argc, argv);
    std::cout.flush();
    std::fflush(nullptr);
    return failures;
}
