// SPDX-License-Identifier: MIT
// Where QEMU's mps2-an385 begins: all of the program lies in its 4 MB of RAM from address 0 on.
#include <stdint.h>

extern "C" void _start();  // newlib's, with semihosting

using Start = void (*)();
struct Vectors {
    uintptr_t stack;
    Start reset;
};
extern const Vectors vectors;
__attribute__((section(".vectors"), used)) const Vectors vectors = {0x400000, _start};
