// SPDX-License-Identifier: MIT
// Fuzz target: a NIfTI file from a stranger, packed or not.
#include <cmath>
#include <cstdlib>

#include "fuzz_folder.h"
#include "lumi/baker/scene.h"
#include "volume/nifti_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    using namespace lumi::baker;
    try {
        const Grid grid = parse_nifti("n", std::string(reinterpret_cast<const char*>(data), size));
        if (grid.values.size() != size_t{grid.nx} * grid.ny * grid.nz) abort();
        for (const float value : grid.values)
            if (!std::isfinite(value)) abort();
    } catch (const SceneError& refused) {
        lumi::fuzz::check_message(refused);
    }
    return 0;
}
