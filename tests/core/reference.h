// SPDX-License-Identifier: MIT
// The double-precision reference, which the bench shares (platform/reference).
#pragma once

#include "lumi/reference/geometry.h"
#include "lumi/reference/weights.h"
