// SPDX-License-Identifier: MIT
// The double-precision twin, which the bench shares (tools/lab/twin).
#pragma once

#include "lumi/twin/geometry.h"
#include "lumi/twin/weights.h"
