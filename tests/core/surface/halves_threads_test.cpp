// SPDX-License-Identifier: MIT
// Halves on two threads, also under ThreadSanitizer by hand:
//     cmake --preset host -B build/tsan -DCMAKE_CXX_FLAGS="-fsanitize=thread" && ninja -C build/tsan lumi_core_tests
#include <thread>

#include "halves.h"

using namespace lumi;
using namespace lumi::test;

TEST_CASE("two threads prepare the frame of one core at once")
{
#ifdef LUMI_TEST_LIGHT
    constexpr uint32_t kFields = 6;
#else
    constexpr uint32_t kFields = 40;
#endif
    check_many_halves(kFields, [](SurfaceHalves& halves, int32_t step) {
        std::thread other([&] { prepare_half(halves, step, 1); });
        prepare_half(halves, step, 0);
        other.join();
    });
}
