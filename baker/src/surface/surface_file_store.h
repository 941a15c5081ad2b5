// SPDX-License-Identifier: MIT
// The blocks of a surface bake's checkpoint or shard.
//
//   size    of the block "basis"
//   basis   the mesh and what else a merge needs, the same in all shards
//   places  two of them, written in turn: where the newest state lies. A state is written beside the one before it, so
//           that a bake that is killed meanwhile goes on from that one. States are packed (util/gzip.h).
#pragma once

#include <optional>

#include "pack/solution.h"
#include "shadow/ground_shadow.h"
#include "shadow/part_shadows.h"
#include "store/block_file.h"

namespace lumi::baker
{

// The part of a bake that all its shards share, since a merge has no scene.

struct FitBasis {
    PatchMesh mesh;
    std::vector<float> densities;  // texels a radius, by patch
    MeshLoss loss;
    ToneCurve tone;
    FieldSphere sphere;
    std::vector<SeeThroughTexel> see_through;  // FitShape
    PartShadows shadows;
    GroundShadow ground;
    Gloss gloss = {};
};

// As bytes for checkpoints and shards.
std::vector<uint8_t> encode(const FitBasis& basis);
// Nothing if the bytes are of no basis.
std::optional<FitBasis> decode_basis(const std::vector<uint8_t>& bytes);

class SurfaceFileStore
{
public:
    explicit SurfaceFileStore(BlockFile& file) : file_(file) {}  // borrows

    // Nothing where it is not there or damaged.
    std::optional<FitBasis> read_basis();
    void write_basis(const FitBasis& basis);

    // After the basis is read or written. False where no whole state is there.
    bool read_state(std::vector<uint8_t>& bytes);
    void write_state(const std::vector<uint8_t>& state);

private:
    struct Place {
        uint64_t turn = 0, offset = 0, size = 0;
    };
    Block basis_block() const;
    Block place_block(uint64_t turn) const;
    Block state_block(const Place& place) const;
    std::optional<Place> place(uint64_t turn) const;

    BlockFile& file_;
    uint64_t basis_size_ = 0;
    Place newest_;
};

}  // namespace lumi::baker
