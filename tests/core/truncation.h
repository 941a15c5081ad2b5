// SPDX-License-Identifier: MIT
// Files of the wrong size.
#pragma once

#include <catch2/catch.hpp>

#include "field_bytes.h"
#include "lumi/field.h"

namespace lumi::test
{

// `open` refuses whatever is left of a file that is cut short, and one byte too many by name.
template <class Open>
void check_other_sizes_are_refused(const Bytes& bytes, Open open)
{
    uint32_t accepted = 0;
    for (size_t size = 0; size < bytes.size(); ++size)
        accepted += open(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size))) == FieldError::none;
    CHECK(accepted == 0);
    Bytes longer = bytes;
    longer.push_back(0);
    CHECK(open(longer) == FieldError::trailing_bytes);
}

}  // namespace lumi::test
