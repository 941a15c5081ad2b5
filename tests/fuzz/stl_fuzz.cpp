// SPDX-License-Identifier: MIT
// Fuzz target: a STL file from a stranger.
#include "fuzz_folder.h"
#include "model/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static lumi::fuzz::FuzzFolder folder;
    std::vector<std::string> warnings;
    try {
        lumi::baker::read_stl(folder.write("m.stl", std::string(reinterpret_cast<const char*>(data), size)), warnings);
    } catch (const lumi::baker::SceneError& refused) {
        lumi::fuzz::check_message(refused);
    }
    return 0;
}
