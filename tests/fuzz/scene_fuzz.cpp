// SPDX-License-Identifier: MIT
// Fuzz target: a scene file (JSON) from a stranger, beside a sound OBJ and a sound sky. A few paths go through what
// loads.
#include <cmath>

#include "fuzz_folder.h"
#include "lumi/baker/scene.h"
#include "math/warp.h"
#include "trace/path_tracer.h"

namespace lumi::fuzz
{
size_t inputs_read = 0;  // for replay_main.cpp
}

namespace
{

struct Sound {
    Sound()
    {
        folder.write("o.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2 3\n");
        folder.write("m.mtl", "newmtl a\nKd 0.5 0.4 0.3\n");
        folder.write("e.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x81");
    }
    lumi::fuzz::FuzzFolder folder;
};

void trace_some(const lumi::baker::Scene& scene)
{
    using namespace lumi::baker;
    const PathTracer tracer(scene.data());
    for (uint32_t k = 0; k < 16; ++k) {
        Sampler sampler(5, k, 0);
        const Vec3 start = square_to_sphere(sampler.next_2d());
        const Vec3 target = square_to_sphere(sampler.next_2d()) * 0.3f;
        if (std::isnan(luminance(tracer.trace({start, normalized(target - start)}, sampler).radiance))) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static Sound sound;
    std::vector<std::string> warnings;
    try {
        trace_some(lumi::baker::load_scene(
            sound.folder.write("s.json", std::string(reinterpret_cast<const char*>(data), size)), {}, warnings));
        ++lumi::fuzz::inputs_read;
    } catch (const lumi::baker::SceneError& refused) {
        lumi::fuzz::check_message(refused);
    }
    return 0;
}
