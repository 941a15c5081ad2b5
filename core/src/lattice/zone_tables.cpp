// SPDX-License-Identifier: MIT
#include "lattice/zone_tables.h"

#include "lumi/fixed.h"
#include "math/generate.h"

namespace lumi::detail
{
namespace
{

constexpr ZoneTables make_zone_tables()
{
    ZoneTables t{};
    double power = 1;
    double inverse = 1;
    for (uint32_t& v : t.threshold_q10) {
        v = static_cast<uint32_t>(1024 * power / (generate::root(5) * generate::kPi) + 0.5);
        power *= generate::kGolden;
    }
    for (int32_t& v : t.inverse_power_q30) {
        v = static_cast<int32_t>(kOneQ30 * inverse + 0.5);
        inverse /= generate::kGolden;
    }
    return t;
}

}  // namespace

constexpr ZoneTables kZoneTables = make_zone_tables();

}  // namespace lumi::detail
