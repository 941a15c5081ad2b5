// SPDX-License-Identifier: MIT
// A thread stands for the second core.
#include <thread>

#include "core1.h"

namespace core1
{
namespace
{

std::thread core;

}  // namespace

void start() {}

void run(void (*job)(int32_t), int32_t argument)
{
    core = std::thread(job, argument);
}

void wait()
{
    core.join();
}

}  // namespace core1
