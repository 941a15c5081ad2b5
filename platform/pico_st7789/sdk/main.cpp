// SPDX-License-Identifier: MIT
// The example's main() behind the SDK's start-up, as ../bare/start.cpp has it without; and what board.cpp asks of the
// chip: the start-up has set the clocks before main().
#include <hardware/gpio.h>
#include <hardware/timer.h>
#include <hardware/uart.h>

#include "board.h"
#include "paint.h"
#include "rp2040.h"

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

void rp2040::start_clocks()
{
    uart_init(uart0, 115200);
    gpio_set_function(0, GPIO_FUNC_UART);
}

void rp2040::wait_microseconds(uint32_t count)
{
    busy_wait_us_32(count);
}

void rp2040::write(const char* text)
{
    uart_puts(uart0, text);
}
