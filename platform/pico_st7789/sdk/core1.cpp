// SPDX-License-Identifier: MIT
// core1.h by the Pico SDK: core 1 is launched once and waits for jobs in the FIFO between the cores.
#include "core1.h"

#include <pico/multicore.h>

#include "paint.h"
#include "text_line.h"

extern "C" uint32_t __StackOneBottom[], __StackOneTop[];

namespace
{

using Job = void (*)(int32_t);

void serve()
{
    for (;;) {
        const Job job = reinterpret_cast<Job>(multicore_fifo_pop_blocking());
        job(static_cast<int32_t>(multicore_fifo_pop_blocking()));
        multicore_fifo_push_blocking(0);
    }
}

}  // namespace

void core1::start()
{
    paint(__StackOneBottom, __StackOneTop);
    multicore_launch_core1(serve);
}

void core1::run(Job job, int32_t argument)
{
    multicore_fifo_push_blocking(reinterpret_cast<uint32_t>(job));
    multicore_fifo_push_blocking(static_cast<uint32_t>(argument));
}

void core1::wait()
{
    multicore_fifo_pop_blocking();
}

void add_report(lumi::firmware::TextLine& line)
{
    line.text(" core1-stack ").decimal(used_bytes(__StackOneBottom, __StackOneTop));
}
