// SPDX-License-Identifier: MIT
#include "store/bake_stages.h"

#include "store/settings_codec.h"

namespace lumi::baker
{

BakeStages::BakeStages(const std::filesystem::path& file, const Digest::Value& scene) : file_(file)
{
    scene_.add(std::string(LUMI_VERSION));
    scene_.add(scene);
}

BakeStages::BakeStages(const std::filesystem::path& file, const Digest::Value& scene, SurfaceSettings settings)
    : BakeStages(file, scene)
{
    settings.threads = 0;
    ByteWriter bytes;
    put_settings(bytes, settings);
    scene_.add(bytes.bytes());
}

void BakeStages::require_shape(bool fits) const
{
    if (!fits) throw BakeError(file_.path().string() + ": is damaged; discard it with --restart");
}

}  // namespace lumi::baker
