// SPDX-License-Identifier: MIT
#include "surface/fit_basis.h"

#include <catch2/catch.hpp>

namespace lumi::baker
{

TEST_CASE("fit basis: shards keep every tone curve, and one that is none is refused")
{
    FitBasis basis = {};
    for (int curve = 0; curve <= static_cast<int>(kLastToneCurve) + 1; ++curve) {
        basis.tone = static_cast<ToneCurve>(curve);
        const std::optional<FitBasis> read = decode_basis(encode(basis));
        REQUIRE(read.has_value() == (basis.tone <= kLastToneCurve));
        if (read) CHECK(read->tone == basis.tone);
    }
}

}  // namespace lumi::baker
