// SPDX-License-Identifier: MIT
// A grid of metallic and roughness is the same material from a GLB and from the MTL that describes it.
#include <catch2/catch.hpp>

#include "model/readers.h"
#include "support/gltf_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

constexpr double kBaseColour[] = {0.5, 0.25, 1};
constexpr double kSteps[] = {0, 0.25, 0.5, 0.75, 1};

std::string three(const double (&c)[3], double factor, const char* separator)
{
    return std::to_string(c[0] * factor) + separator + std::to_string(c[1] * factor) + separator +
           std::to_string(c[2] * factor);
}

Material of_glb(double metallic, double roughness)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const testing::GltfMaker maker =
        testing::square("\"pbrMetallicRoughness\":{\"baseColorFactor\":[" + three(kBaseColour, 1, ",") +
                        ",1],\"metallicFactor\":" + std::to_string(metallic) +
                        ",\"roughnessFactor\":" + std::to_string(roughness) + "}");
    const SceneParts parts = read_gltf(folder.write("m.glb", maker.glb()), warnings);
    CHECK(warnings.empty());
    return parts.materials.at(0);
}

// Kd is what the body shows through a skin of index 1.5, which reflects 0.04 from straight above; metal has no skin.
Material of_mtl(double metallic, double roughness)
{
    constexpr double kReflectance = 0.04;
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    folder.write("m.mtl", "newmtl x\nKd " + three(kBaseColour, 1 - kReflectance * (1 - metallic), " ") + "\nPm " +
                              std::to_string(metallic) + "\nPr " + std::to_string(roughness) + "\nKs 0.5 0.5 0.5\n");
    const SceneParts parts =
        read_obj(folder.write("m.obj", "mtllib m.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"), warnings);
    CHECK(warnings.empty());
    return parts.materials.at(0);
}

void check_equal(const Rgb& a, const Rgb& b)
{
    constexpr float kRounding = 1e-6f;  // of numbers near 1, written with six decimals
    CHECK(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= kRounding);
}

void check_equal(float a, float b)
{
    check_equal(grey(a), grey(b));
}

}  // namespace

TEST_CASE("glTF: metallic and roughness give the material of an MTL whose Kd is the base colour times 1 - F0")
{
    for (const double metallic : kSteps) {
        for (const double roughness : kSteps) {
            INFO("metallic " << metallic << ", roughness " << roughness);
            const Material glb = of_glb(metallic, roughness), mtl = of_mtl(metallic, roughness);
            for (const MaterialParameter& parameter : kMaterialParameters) {
                INFO("parameter " << &parameter - kMaterialParameters);
                std::visit([&](const auto& member) { check_equal(glb.*member, mtl.*member); }, parameter.member);
            }
            CHECK(glb.specular == mtl.specular);
            CHECK(glb.rough_body == mtl.rough_body);
            CHECK(glb.glass == mtl.glass);
        }
    }
}

}  // namespace lumi::baker
