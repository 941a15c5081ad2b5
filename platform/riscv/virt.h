// SPDX-License-Identifier: MIT
// QEMU's `virt`: what a program asks of its host by semihosting ("RISC-V Semihosting": three instructions that tell
// such a call from a breakpoint). virt.cpp also has the reset and board_stop of board.h.
#pragma once

#include <stdint.h>

namespace virt
{

enum class Operation : uint32_t { open = 0x01, close = 0x02, write_text = 0x04, write = 0x05, exit_extended = 0x20 };

// The operation's result. Most take a block of words, text is a pointer by itself.
int32_t call(Operation operation, const void* parameters);

uint32_t address(const void* pointer);

}  // namespace virt
