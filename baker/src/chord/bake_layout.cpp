// SPDX-License-Identifier: MIT
#include "chord/bake_layout.h"

#include "chord/tracing_fingerprint.h"
#include "lumi/detail/lattice.h"
#include "store/settings_codec.h"
#include "store/shard_rows.h"

namespace lumi::baker
{
namespace
{

std::string lattice_range(const char* name)
{
    return std::string("the number of ") + name + " must lie in 1 to " + std::to_string(detail::kMaxLatticeSize);
}

}  // namespace

FieldLayout checked_layout(const BakeSettings& s)
{
    require(s.origins >= 1 && s.origins <= detail::kMaxLatticeSize, lattice_range("origins"));
    require(s.directions >= 1 && s.directions <= detail::kMaxLatticeSize, lattice_range("directions"));
    require(s.used_origins <= s.origins, "the cap holds " + std::to_string(s.used_origins) + " origins of " +
                                             std::to_string(s.origins) + "; choose at most all of them, or 0 for all");
    require(s.samples >= 1, "the number of samples must be at least 1");
    require(s.max_error_levels >= 0 && s.max_error_levels <= 255,
            "the error at which a texel is settled must lie in 0 to 255 levels");
    require(static_cast<uint32_t>(s.texel) < detail::format::kTexelFormats, "there is no such texel format");
    require(s.footprint <= Footprint::both, "there is no such footprint");
    require(s.beam <= Beam::parallel, "there is no such beam");
    const FieldLayout layout = {s.origins, s.directions, s.used_origins ? s.used_origins : s.origins, s.texel, {}, 1};
    require(file_bytes(layout) <= UINT32_MAX, "the field would have " + std::to_string(file_bytes(layout)) +
                                                  " bytes, and a field file holds less than 4 GiB; choose fewer "
                                                  "origins or directions, a smaller cap or a smaller texel format");
    return layout;
}

FieldLayout layout_of(const BakeIdentity& identity)
{
    check_shard(identity.shard);
    FieldLayout result = checked_layout(std::get<BakeSettings>(identity.settings));
    result.centre = identity.centre;
    result.radius = identity.radius;
    return result;
}

BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard)
{
    BakeSettings resolved = settings;
    resolved.used_origins = checked_layout(settings).used_origins;
    return identity_of(scene, resolved, shard, tracing_fingerprint(scene.data()));
}

}  // namespace lumi::baker
