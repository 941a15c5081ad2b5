// SPDX-License-Identifier: MIT
// The second core does one job at a time.
#pragma once

#include <stdint.h>

namespace lumi::firmware
{
class TextLine;
}

namespace core1
{

void start();
// Begins job(argument) on core 1. Its stack takes what docs/firmware.md says.
void run(void (*job)(int32_t), int32_t argument);
// Until that job has ended.
void wait();

}  // namespace core1

// Adds how far core 1 used its stack to the line that the board writes after a frame. The board has one that adds
// nothing.
void add_report(lumi::firmware::TextLine& line);
