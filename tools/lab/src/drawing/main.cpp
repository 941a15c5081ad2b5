// SPDX-License-Identifier: MIT
// lumi_tools_bench draw FIELD WIDTH HEIGHT | plot DATA.json OUT.svg
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "commands.h"

namespace
{

bool run(int words, char** word)
{
    if (words == 5 && std::strcmp(word[1], "draw") == 0) {
        lumi::tools::bench::print_drawing(word[2], std::atoi(word[3]), std::atoi(word[4]));
        return true;
    }
    if (words == 4 && std::strcmp(word[1], "plot") == 0) {
        lumi::tools::bench::write_plot(word[2], word[3]);
        return true;
    }
    return false;
}

}  // namespace

int main(int words, char** word)
{
    try {
        if (run(words, word)) return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lumi_tools_bench: %s\n", error.what());
        return 1;
    }
    std::fprintf(stderr, "lumi_tools_bench draw FIELD WIDTH HEIGHT | plot DATA.json OUT.svg\n");
    return 2;
}
