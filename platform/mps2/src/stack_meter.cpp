// SPDX-License-Identifier: MIT
#include "lumi/mps2/stack_meter.h"

namespace lumi::mps2
{
namespace
{

constexpr uint32_t kPaint = 0xC5C5C5C5;
constexpr uint32_t kPaintedWords = StackMeter::kPaintedBytes / sizeof(uint32_t);

}  // namespace

// Neither function may call another or be inlined: paint() would overwrite the callee's frame.
__attribute__((noinline)) void StackMeter::paint()
{
    volatile uint32_t* word;
    __asm volatile("mov %0, sp" : "=r"(word));
    top_ = const_cast<uint32_t*>(word);
    for (uint32_t i = 0; i < kPaintedWords; ++i) *--word = kPaint;
}

__attribute__((noinline)) uint32_t StackMeter::high_water_bytes() const
{
    const volatile uint32_t* word = top_ - kPaintedWords;
    while (word != top_ && *word == kPaint) ++word;
    return static_cast<uint32_t>(top_ - word) * sizeof(uint32_t);
}

}  // namespace lumi::mps2
