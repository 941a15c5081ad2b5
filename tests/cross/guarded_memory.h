// SPDX-License-Identifier: MIT
// Memory behind which nothing may be read: the memory protection unit of an emulated Cortex-M3 or M4 makes a fault of
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "lumi/mps2/board.h"

namespace lumi::test
{

class GuardedMemory
{
public:
    static constexpr uint32_t kBytes = 1024 * 1024;

    // 8 MiB into the PSRAM; fields that the emulator loads lie below.
    GuardedMemory() : end_(const_cast<uint8_t*>(mps2::loaded_field(0).bytes) + 8 * kBytes)
    {
        volatile uint32_t* const mpu = reinterpret_cast<volatile uint32_t*>(0xE000ED94);
        constexpr uint32_t kRegion0Here = 1u << 4, kSize1MiB = 19u << 1, kEnable = 1, kElseAsBefore = 1u << 2;
        mpu[2] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(end_)) | kRegion0Here;
        mpu[3] = kSize1MiB | kEnable;  // nobody may do anything
        mpu[0] = kElseAsBefore | kEnable;
        __asm volatile("dsb\n isb" ::: "memory");
    }

    // Bytes that end where the guard begins.
    uint8_t* put(const uint8_t* bytes, size_t count)
    {
        uint8_t* const at = end_ - count;
        if (count > 0) std::memcpy(at, bytes, count);
        return at;
    }
    uint8_t* end() const { return end_; }

private:
    uint8_t* end_;
};

}  // namespace lumi::test
