// SPDX-License-Identifier: MIT
// What a chord bake's settings ask for, and what makes it the bake that it is.
#pragma once

#include "chord/field_writer.h"
#include "store/bake_identity.h"

namespace lumi::baker
{

// Without centre and radius. Throws BakeError for settings that no field can hold.
FieldLayout checked_layout(const BakeSettings& settings);

// The layout of a chord bake's field. Throws BakeError for settings or shards that cannot be.
FieldLayout layout_of(const BakeIdentity& identity);

// Throws BakeError for settings or shards that cannot be.
BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard);

}  // namespace lumi::baker
