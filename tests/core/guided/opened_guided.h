// SPDX-License-Identifier: MIT
// A guided field that is open as long as this lives.
#pragma once

#include <catch2/catch.hpp>

#include "aligned_copy.h"
#include "lumi/guided/guided_field.h"

namespace lumi::test
{

struct OpenedGuided {
    AlignedCopy copy;
    GuidedField field;

    explicit OpenedGuided(const Bytes& bytes) : copy(bytes)
    {
        REQUIRE(open_guided(copy.data(), copy.size(), field) == FieldError::none);
    }
};

}  // namespace lumi::test
