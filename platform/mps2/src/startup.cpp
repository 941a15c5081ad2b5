// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "lumi/mps2/board.h"

int main(int argc, char** argv);

// The linker script defines these; only their addresses mean something.
extern "C" {
extern uint32_t lumi_stack_top;
extern const uint32_t lumi_data_image;
extern uint32_t lumi_data_start, lumi_data_end, lumi_bss_start, lumi_bss_end;
extern void (*const lumi_init_array_start)();
extern void (*const lumi_init_array_end)();

void lumi_reset();
void lumi_systick_handler();
}

namespace lumi::mps2
{
namespace
{

constexpr size_t kMaxCommandLineBytes = 1024;
constexpr int kMaxArguments = 32;

char command_line_text[kMaxCommandLineBytes];
char* arguments[kMaxArguments + 1];

void copy_words(uint32_t* to, const uint32_t* end, const uint32_t* from)
{
    while (to < end) *to++ = *from++;
}

void clear_words(uint32_t* to, const uint32_t* end)
{
    while (to < end) *to++ = 0;
}

// Splits the command line at spaces, in place. There is no quoting.
int split_command_line()
{
    if (!command_line(command_line_text, sizeof(command_line_text))) return 0;
    int count = 0;
    char* at = command_line_text;
    while (*at != '\0' && count < kMaxArguments) {
        arguments[count++] = at;
        while (*at != '\0' && *at != ' ') ++at;
        while (*at == ' ') *at++ = '\0';
    }
    return count;
}

#if defined(__ARM_ARCH_6M__)
// QEMU has no ARMv6-M board with memory enough, so that code runs on a Cortex-M3. ARMv6-M faults on unaligned access,
// so the M3 is told to do the same (CCR.UNALIGN_TRP): what runs here does not run by luck.
void trap_what_the_core_lacks()
{
    constexpr uint32_t kConfigurationControl = 0xE000ED14;
    constexpr uint32_t kUnalignTrap = 1u << 3;
    volatile uint32_t& ccr = *reinterpret_cast<volatile uint32_t*>(kConfigurationControl);
    ccr = ccr | kUnalignTrap;
}
#else
void trap_what_the_core_lacks() {}
#endif

[[noreturn]] void fault()
{
    write("fault: the program was stopped by a processor exception\n");
    exit_with(kFaultExitCode);
}

using Handler = void (*)();

struct VectorTable {
    uint32_t* stack_top;
    Handler reset, nmi, hard_fault, memory_fault, bus_fault, usage_fault;
    Handler reserved_7_to_10[4];
    Handler supervisor_call, debug_monitor, reserved_13, pend_sv, systick;
};

__attribute__((section(".lumi_vectors"), used)) const VectorTable vector_table = {
    &lumi_stack_top, lumi_reset,          fault, fault, fault, fault, fault, {}, fault, fault, nullptr,
    fault,           lumi_systick_handler};

}  // namespace

}  // namespace lumi::mps2

extern "C" {

__attribute__((weak)) void lumi_systick_handler() {}
__attribute__((weak)) void lumi_before_constructors() {}

void lumi_reset()
{
    using namespace lumi::mps2;
    copy_words(&lumi_data_start, &lumi_data_end, &lumi_data_image);
    clear_words(&lumi_bss_start, &lumi_bss_end);
    trap_what_the_core_lacks();
    lumi_before_constructors();
    for (const Handler* constructor = &lumi_init_array_start; constructor < &lumi_init_array_end; ++constructor)
        (*constructor)();
    const int count = split_command_line();
    exit_with(main(count, arguments));
}
}
