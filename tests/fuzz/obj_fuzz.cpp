// SPDX-License-Identifier: MIT
// Fuzz target: an OBJ and its MTL from a stranger; a byte 0xFF divides them.
#include "fuzz_folder.h"
#include "model/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static lumi::fuzz::FuzzFolder folder;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const size_t end = std::min(bytes.find('\xFF'), bytes.size());
    folder.write("m.mtl", bytes.substr(std::min(end + 1, bytes.size())));
    std::vector<std::string> warnings;
    try {
        lumi::baker::read_obj(folder.write("s.obj", bytes.substr(0, end)), warnings);
    } catch (const lumi::baker::SceneError& refused) {
        lumi::fuzz::check_message(refused);
    }
    return 0;
}
