// SPDX-License-Identifier: MIT
// The Pico SDK does what board.cpp asks of the chip: its start-up has set the clocks before main().
#include <hardware/gpio.h>
#include <hardware/timer.h>
#include <hardware/uart.h>

#include "rp2040.h"

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
