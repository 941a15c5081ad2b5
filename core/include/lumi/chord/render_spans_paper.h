// SPDX-License-Identifier: MIT
// For render_spans(): the reconstruction that compares distances, Paper<K>. What a firmware does not include is not
// linked.
#pragma once
#pragma GCC system_header

#include "lumi/chord/detail/kernel/kernel.h"
#include "lumi/chord/render_spans.h"
