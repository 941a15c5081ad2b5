// SPDX-License-Identifier: MIT
// Lines to patches whose light is too noisy for the lines that chance sends there: insides that few lines reach, gloss,
// light through small holes.
#pragma once

#include "fit/fit_shape.h"
#include "geometry/accelerator.h"
#include "math/sampler.h"

namespace lumi::baker
{

// Draws extra lines. To a patch they come as all lines do that meet it: from places that are uniform over its triangles
// and from directions by their cosine, those left out that something else stops. So they change no mean.
class ExtraLines
{
public:
    // `chances`: by patch (fit/path_plan.h); without any it is empty.
    ExtraLines(const FitShape& shape, const std::vector<float>& chances);

    bool empty() const { return ends_.empty(); }

    struct Line {
        Ray ray;  // from the unit sphere
        uint32_t patch;
    };
    // Precondition: not empty.
    Line draw(Sampler& sampler) const;

private:
    Mesh triangles_;
    std::vector<uint32_t> numbers_;  // the mesh's triangle for each of these
    std::vector<float> ends_;        // by triangle: the sum of chances up to it, its own among them
};

// By patch, square radii.
std::vector<float> patch_areas(const PatchMesh& mesh);

}  // namespace lumi::baker
