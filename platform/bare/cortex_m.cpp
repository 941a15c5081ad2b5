// SPDX-License-Identifier: MIT
// Vectors of Cortex-M examples: what is not the reset is a fault.
#include "board.h"

extern "C" uint32_t lumi_stack_top[];

extern "C" void board_fault()
{
    board_stop(70);
}

extern "C" void lumi_reset()
{
    lumi_start();
}

using Handler = void (*)();
struct VectorTable {
    uint32_t* stack_top;
    Handler reset, faults[5];  // the last three are reserved on Armv6-M
};
__attribute__((section(".lumi_vectors"), used)) extern const VectorTable vector_table = {
    lumi_stack_top, lumi_reset, {board_fault, board_fault, board_fault, board_fault, board_fault}};
