// SPDX-License-Identifier: MIT
// Which triangles belong together as one sheet, and which of them are wound against it.
#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace lumi::baker
{

struct SheetPlace {
    uint32_t sheet;  // the number of one of its triangles
    bool reversed;   // wound against that triangle
};

// Triangles are of one sheet if they share an edge with each other alone. Where that cannot make all of a sheet face
// one way (a Moebius strip), it is torn somewhere. Edges of more than two triangles part sheets. Degenerate triangles
// are sheets of their own.
class Sheets
{
public:
    explicit Sheets(const Mesh& mesh);  // reads positions and corners only

    SheetPlace of(uint32_t triangle) const;

private:
    void join(uint32_t a, uint32_t b, bool reversed);

    std::vector<uint32_t> parent_, size_;
    std::vector<bool> reversed_;  // against the parent
};

}  // namespace lumi::baker
