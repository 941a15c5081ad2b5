// SPDX-License-Identifier: MIT
#include "demo_options.h"

#include <cstring>

namespace lumi::firmware
{
namespace
{

bool parse_count(const char* text, uint32_t& out)
{
    uint32_t value = 0;
    for (const char* digit = text; *digit != '\0'; ++digit) {
        if (*digit < '0' || *digit > '9' || value > kMaxFrames) return false;
        value = value * 10 + static_cast<uint32_t>(*digit - '0');
    }
    out = value;
    return value >= 1 && value <= kMaxFrames;
}

bool parse_mode(const char* text, Mode& out)
{
    constexpr const char* kNames[] = {"nearest", "linear", "paper"};
    for (uint8_t i = 0; i < sizeof(kNames) / sizeof(kNames[0]); ++i) {
        if (std::strcmp(text, kNames[i]) == 0) {
            out = static_cast<Mode>(i);
            return true;
        }
    }
    return false;
}

// An option with a value; false if it is unknown or the value is wrong.
bool parse_pair(const char* name, const char* value, DemoOptions& options)
{
    if (std::strcmp(name, "--frames") == 0) return parse_count(value, options.frames);
    if (std::strcmp(name, "--mode") == 0) return parse_mode(value, options.mode);
    if (std::strcmp(name, "--write") == 0) {
        options.write_prefix = value;
        return true;
    }
    return false;
}

}  // namespace

const char* const kDemoUsage =
    "usage: [--frames 1..999] [--mode nearest|linear|paper] [--verify] [--write PREFIX]\n"
    "The field is linked into the program, or loaded to the start of the board's PSRAM.\n";

const char* parse(int argc, char** argv, DemoOptions& out)
{
    DemoOptions options;
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--verify") == 0)
            options.verify = true;
        else if (i + 1 < argc && parse_pair(argv[i], argv[i + 1], options))
            ++i;
        else
            return argv[i];
    out = options;
    return nullptr;
}

}  // namespace lumi::firmware
