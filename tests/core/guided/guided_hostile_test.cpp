// SPDX-License-Identifier: MIT
// Guided fields that somebody else has written: cut short, damaged, changed on purpose.
#include <catch2/catch.hpp>
#include <random>

#include "guided/guided_opening.h"
#include "truncation.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

// Opens hostile bytes; whatever is accepted must be safe to read and to verify.
bool survive(const Bytes& bytes)
{
    const OddCopy copy(bytes);
    GuidedField field;
    if (open_guided(copy.data(), copy.size, field) != FieldError::none) return false;
    (void)touch(field);
    (void)verify_field(copy.data(), copy.size);
    return true;
}

}  // namespace

TEST_CASE("every truncation of a guided field and one trailing byte are refused", "[guided]")
{
    const Bytes bytes = small_file(0);
    check_other_sizes_are_refused(bytes, open_copy);
}

TEST_CASE("a damaged byte of any guided section is found by verify_field", "[guided]")
{
    const Bytes good = small_file(0);
    for (uint32_t k = 0; k < 6; ++k) {
        Bytes bytes = good;
        const size_t entry = format::kHeaderBytes + k * format::kEntryBytes;
        const size_t last =
            u32(&good[entry + format::entry::kOffsetAt]) + u32(&good[entry + format::entry::kSizeAt]) - 1;
        bytes[last] ^= 0x10;
        CHECK(verify_field(bytes.data(), bytes.size()) == FieldError::section_crc);
    }
}

TEST_CASE("every single-byte change of a guided field gives an error or a field that reads safely", "[guided]")
{
    const uint32_t kind = GENERATE(0u, 1u, 3u, kBlocksKind);
    const Bytes bytes = small_file(kind);
#ifdef LUMI_TEST_LIGHT
    const int values[] = {255};
#else
    const int values[] = {0, 1, 2, 4, 15, 16, 127, 128, 129, 254, 255};
#endif
    uint32_t accepted = 0;
    for (size_t at = 0; at < bytes.size(); ++at) {
        for (const int v : values) {
            Bytes changed = bytes;
            changed[at] = static_cast<uint8_t>(v);
            reseal(changed);
            accepted += survive(changed);
        }
    }
    CHECK(accepted > 0);
}

TEST_CASE("random changes of several bytes of a guided field are harmless", "[guided]")
{
#ifdef LUMI_TEST_LIGHT
    const int rounds = 100;
#else
    const int rounds = 5000;
#endif
    std::mt19937 random(20261121);
    const Bytes files[] = {small_file(0), small_file(1), small_file(5), small_file(kBlocksKind)};
    // Most changes hit the bytes that steer the reader: those before the mesh's end.
    constexpr uint32_t kSteeringBytes = 400;
    uint32_t accepted = 0;
    for (int round = 0; round < rounds; ++round) {
        Bytes bytes = files[static_cast<size_t>(round) % 4];
        const uint32_t changes = 1 + random() % 4;
        for (uint32_t k = 0; k < changes; ++k) {
            const uint32_t reach = random() % 2 == 0 ? kSteeringBytes : static_cast<uint32_t>(bytes.size());
            bytes[random() % std::min<size_t>(reach, bytes.size())] = static_cast<uint8_t>(random());
        }
        reseal(bytes);
        accepted += survive(bytes);
    }
    CHECK(accepted > 0);
}

TEST_CASE("a failed open leaves the guided field untouched", "[guided]")
{
    GuidedField field;
    field.used_origins = 77;
    Bytes bytes = small_file(0);
    bytes.pop_back();
    CHECK(open_guided(bytes.data(), bytes.size(), field) != FieldError::none);
    CHECK(field.used_origins == 77);
}
