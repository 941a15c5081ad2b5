// SPDX-License-Identifier: MIT
#include "planner/chips.h"

#include <algorithm>

namespace lumi::planner
{

constexpr uint32_t kKiB = 1024;

// Clocks per instruction: Arm's tables give the M0+ 2 clocks for a load and for a taken branch, the M3/M4 2 for a load
// that does not follow another and 2 to 4 for a taken branch, else 1; about one instruction in three is one or the
// other. The M7 issues two at a time and rarely finds a pair. These are estimates: this machine has no such chip.
// docs/log/tradeoff.md names the manual and the section for clock, wait states and cache of each part, and what was
// chosen where a manual was not at hand. Caches and miss costs: RP2040 datasheet 2.6.3 (XIP), RP2350 datasheet 4.4
// (XIP), RM0090 3.4.2 (ART: the data side holds 8 lines of 128 bits, and 5 wait states at 168 MHz), RM0433 (L1),
// ESP32-S3 TRM (data cache as configured). RAM: RP2040 and RP2350 datasheets (SRAM: the banks follow each other),
// RM0090 2.1 (SRAM1 and SRAM2; 64 KiB more lie apart, which DMA does not reach), RM0433 (AXI SRAM; SRAM1 to SRAM4 and
// the TCM have 544 KiB more in four places), ESP32-S3 TRM (SRAM1; the data cache takes the beginning of SRAM2 behind
// it, and code in RAM takes some of SRAM1). nRF52840: the flash's cache serves the ICODE bus alone (PS, NVMC), so each
// word of the field waits; 3 wait states (PS, CPU: W_FLASHCACHE). STM32U585: ICACHE holds what the C bus reads, data
// too, in lines of 128 bits (AN5212); 4 wait states and 4 words, as if nothing overlapped, are 8 clocks. ESP32-C3: one
// cache for code and data (datasheet 3.1.5), a line by the same flash reads as the ESP32-S3. QEMU counted 0.97 to 1.21
// RISC-V instructions for one of M4 code, of the desk clock of platform/README.md in three modes and two views: 1.3
// × 1.2 clocks.
const std::array<Chip, kChips> kChipList = {{
    {"rp2040", "RP2040", "m0plus", 133, 1.35, {16384, 2, 8}, 400, "one core of two", 264 * kKiB, 2},
    {"rp2350",
     "RP2350",
     "m4",
     150,
     1.3,
     {16384, 2, 8},
     465,
     "one core of two; Cortex-M33, counted with M4 code",
     520 * kKiB,
     2},
    {"stm32f4",
     "STM32F407",
     "m4",
     168,
     1.3,
     {128, 8, 16},
     30,
     "field in internal flash of at most 1 MB: scale M, N",
     128 * kKiB,
     1,
     1024 * kKiB},
    {"stm32h7", "STM32H743", "m7", 480, 0.8, {16384, 4, 32}, 700, "field in QSPI flash", 512 * kKiB},
    {"esp32s3",
     "ESP32-S3",
     "m4",
     240,
     1.3,
     {32768, 8, 32},
     1050,
     "one core of two; Xtensa LX7, M4 counts stand in for its own; quad flash at 80 MHz",
     416 * kKiB,
     2,
     0,
     true},
    {"nrf52840",
     "nRF52840",
     "m4",
     64,
     1.3,
     {4, 1, 4},
     47,
     "field in internal flash of at most 1 MB, whose cache holds code alone",
     256 * kKiB,
     1,
     1024 * kKiB},
    {"stm32u5",
     "STM32U585",
     "m4",
     160,
     1.3,
     {8192, 2, 16},
     50,
     "field in internal flash of at most 2 MB; Cortex-M33, counted with M4 code",
     768 * kKiB,
     1,
     2048 * kKiB},
    {"esp32c3",
     "ESP32-C3",
     "m4",
     160,
     1.56,
     {16384, 8, 32},
     1050,
     "RISC-V, M4 counts stand in for its own; quad flash at 80 MHz",
     384 * kKiB,
     1,
     0,
     true},
}};

std::string marked_title(const Chip& chip)
{
    return std::string(chip.title) + (chip.is_estimated ? "*" : "");
}

double frames_per_second(const Chip& chip, uint64_t instructions, uint64_t misses, double pixels)
{
    constexpr double kMega = 1e6, kNano = 1e-9;
    const double computing = static_cast<double>(instructions) * chip.clocks_per_instruction / (chip.clock_mhz * kMega);
    const double waiting = static_cast<double>(misses) * chip.miss_ns * kNano;
    return std::min(1 / (computing + waiting), display_frames_per_second(pixels));
}

namespace
{

constexpr uint32_t kEmpty = 0xFFFFFFFF;  // no line has this number: addresses are bytes, lines hold several

}  // namespace

CacheModel::CacheModel(const CacheShape& shape) : shape_(shape), lines_(size_t{shape.bytes / shape.line_bytes}, kEmpty)
{
}

void CacheModel::read(const Read& read)
{
    const uint32_t last = (read.address + read.bytes - 1) / shape_.line_bytes;
    for (uint32_t line = read.address / shape_.line_bytes; line <= last; ++line) touch(line);
}

void CacheModel::touch(uint32_t line)
{
    const auto set = lines_.begin() + static_cast<std::ptrdiff_t>(size_t{line % shape_.sets()} * shape_.ways);
    const auto end = set + static_cast<std::ptrdiff_t>(shape_.ways);
    auto found = std::find(set, end, line);
    if (found == end) {
        ++misses_;
        found = end - 1;
    }
    std::copy_backward(set, found, found + 1);
    *set = line;
}

Misses misses_by_chip(const std::vector<Read>& reads)
{
    Misses misses;
    for (size_t i = 0; i < misses.size(); ++i) {
        CacheModel cache(kChipList[i].cache);
        for (const Read& read : reads) cache.read(read);
        misses[i] = cache.misses();
    }
    return misses;
}

}  // namespace lumi::planner
