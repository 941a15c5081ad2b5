// SPDX-License-Identifier: MIT
// Planted for the test of the proof: the C heap.
#include <cstdlib>

void* planted(size_t bytes);
void* planted(size_t bytes)
{
    return std::malloc(bytes);
}
