// SPDX-License-Identifier: MIT
// Fuzz target: a scene file (JSON) from a stranger, beside a sound OBJ and a sound sky.
#include "fuzz_folder.h"
#include "lumi/baker/scene.h"

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    static Sound sound;
    std::vector<std::string> warnings;
    try {
        lumi::baker::load_scene(sound.folder.write("s.json", std::string(reinterpret_cast<const char*>(data), size)),
                                {}, warnings);
    } catch (const lumi::baker::SceneError&) {
    }
    return 0;
}
