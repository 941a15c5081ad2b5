// SPDX-License-Identifier: MIT
// The module's memory behind its own data: one region after another, given back all at once.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lumi::wasm
{

inline constexpr size_t kAlignment = 8;

// A region of so many bytes at a multiple of kAlignment, or null where the browser has no more. Its bytes are not
// cleared.
uint8_t* reserve(size_t bytes);

// Gives back `region` and all that was reserved after it; null: everything.
void release_from(const uint8_t* region);

}  // namespace lumi::wasm
