// SPDX-License-Identifier: MIT
// The example's main() behind the SDK's start-up, as ../bare/start.cpp has it without.
#include "paint.h"
#include "start.h"

extern "C" uint32_t __StackBottom[], __StackTop[];

int firmware_main();  // main() of main.cpp or two_cores.cpp

uint32_t used_stack_bytes()
{
    return used_bytes(__StackBottom, __StackTop);
}

int main()
{
    constexpr uint32_t kOwnFrameWords = 32;
    paint(__StackBottom, static_cast<uint32_t*>(__builtin_frame_address(0)) - kOwnFrameWords);
    board_stop(firmware_main());
}
