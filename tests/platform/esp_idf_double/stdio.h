// SPDX-License-Identifier: MIT
// The toolchain comes without a C library.
#pragma once

extern "C" int printf(const char* format, ...);
