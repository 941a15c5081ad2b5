// SPDX-License-Identifier: MIT
// For render_spans(): the reconstructions that compare distances, Paper<K> and NearestVoronoi. What a firmware does not
// include is not linked.
#pragma once

#include "lumi/detail/chord/kernel/kernel.h"
#include "lumi/render_spans.h"
