// SPDX-License-Identifier: MIT
#include "files/cut_short.h"

#include <unistd.h>

#include <array>
#include <csignal>

#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

// What a signal handler may read: bytes is null while the place is free or being filled.
struct Watched {
    std::string message;
    size_t size = 0;
    const uint8_t* volatile bytes = nullptr;
};

constexpr size_t kPlaces = 16;  // no command maps as many
std::array<Watched, kPlaces> watched;

void on_bus_error(int, siginfo_t* info, void*)
{
    const auto* at = static_cast<const uint8_t*>(info->si_addr);
    for (const Watched& w : watched) {
        if (w.bytes == nullptr || at < w.bytes || at >= w.bytes + w.size) continue;
        static_cast<void>(!write(STDERR_FILENO, w.message.data(), w.message.size()));
        _exit(kExitFailed);
    }
    std::signal(SIGBUS, SIG_DFL);  // not ours: the instruction runs again and ends the process
}

}  // namespace

CutShortWatch::CutShortWatch(const std::string& path, const uint8_t* bytes, size_t size) : place_(0)
{
    struct sigaction action = {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGBUS, &action, nullptr);
    while (place_ < kPlaces && watched[place_].bytes != nullptr) ++place_;
    if (place_ == kPlaces || size == 0) {
        place_ = kPlaces;
        return;
    }
    watched[place_].message =
        "lumi: " + path + ": was cut short while it was read; wait until it is whole and start again\n";
    watched[place_].size = size;
    watched[place_].bytes = bytes;
}

CutShortWatch::~CutShortWatch()
{
    if (place_ < kPlaces) watched[place_].bytes = nullptr;
}

}  // namespace lumi::tools
