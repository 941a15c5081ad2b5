// SPDX-License-Identifier: MIT
#include "board.h"

int main();

// The linker script defines these; only their addresses mean something.
extern "C" {
extern const uint32_t lumi_data_image[], lumi_hot_image[];
extern uint32_t lumi_data_start[], lumi_data_end[], lumi_hot_start[], lumi_hot_end[];
extern uint32_t lumi_bss_start[], lumi_bss_end[], lumi_stack_limit[], lumi_stack_top[];
extern void (*const lumi_init_array_start[])();
extern void (*const lumi_init_array_end[])();
}

namespace
{

constexpr uint32_t kPaint = 0xC5C5C5C5;
constexpr uint32_t kOwnFrameWords = 32;  // below lumi_start's caller, not painted

void copy_words(uint32_t* to, const uint32_t* end, const uint32_t* from)
{
    while (to < end) *to++ = *from++;
}

void fill_words(uint32_t* to, const uint32_t* end, uint32_t value)
{
    while (to < end) *to++ = value;
}

}  // namespace

uint32_t used_stack_bytes()
{
    const volatile uint32_t* word = lumi_stack_limit;
    while (word != lumi_stack_top && *word == kPaint) ++word;
    return static_cast<uint32_t>(lumi_stack_top - word) * sizeof(uint32_t);
}

extern "C" void lumi_start()
{
    copy_words(lumi_data_start, lumi_data_end, lumi_data_image);
    copy_words(lumi_hot_start, lumi_hot_end, lumi_hot_image);
    fill_words(lumi_bss_start, lumi_bss_end, 0);
    uint32_t* const frame = static_cast<uint32_t*>(__builtin_frame_address(0));
    fill_words(lumi_stack_limit, frame - kOwnFrameWords, kPaint);
    for (auto constructor = lumi_init_array_start; constructor < lumi_init_array_end; ++constructor) (*constructor)();
    board_stop(main());
}
