// SPDX-License-Identifier: MIT
// lumi_baker_bench share|matt|convergence|threads SCENE ROWS, adaptive SCENE TEXELS, or memory TRIANGLES
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "commands.h"

namespace
{

using SceneCommand = void(const char*, unsigned);

struct Named {
    const char* name;
    SceneCommand* run;
};

constexpr Named kCommands[] = {{"share", lumi::baker::bench::print_share},
                               {"matt", lumi::baker::bench::print_matt_share},
                               {"convergence", lumi::baker::bench::print_convergence},
                               {"adaptive", lumi::baker::bench::print_adaptive},
                               {"threads", lumi::baker::bench::print_threads}};

unsigned count_of(const char* word)
{
    const long count = std::strtol(word, nullptr, 10);
    return count > 0 && count < 1 << 30 ? static_cast<unsigned>(count) : 0;
}

bool run(int words, char** word)
{
    if (words == 3 && std::strcmp(word[1], "memory") == 0 && count_of(word[2]) > 0) {
        lumi::baker::bench::print_memory(count_of(word[2]));
        return true;
    }
    for (const Named& command : kCommands) {
        if (words == 4 && std::strcmp(word[1], command.name) == 0 && count_of(word[3]) > 0) {
            command.run(word[2], count_of(word[3]));
            return true;
        }
    }
    return false;
}

}  // namespace

int main(int words, char** word)
{
    try {
        if (run(words, word)) return 0;
        std::fprintf(
            stderr,
            "lumi_baker_bench share|matt|convergence|threads SCENE ROWS\nlumi_baker_bench adaptive SCENE TEXELS\n"
            "lumi_baker_bench memory TRIANGLES\n");
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lumi_baker_bench: %s\n", error.what());
        return 1;
    }
}
