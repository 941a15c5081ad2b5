// SPDX-License-Identifier: MIT
#include "quality/mode_costs.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"

namespace lumi::quality
{

namespace
{

// Results of early benches are of chord fields.
ModeCost cost_of(const nlohmann::json& result)
{
    ModeCost cost = {result.value("layout", "chord"),    result.at("core"), result.at("mode"), "", 0,
                     result.at("instructions_per_pixel")};
    if (cost.layout != "chord") return cost;
    cost.texel = result.at("texel");
    cost.span = result.at("span");
    return cost;
}

}  // namespace

std::vector<ModeCost> read_mode_costs(const std::string& path)
{
    baker::note_input(path);
    std::ifstream file(path);
    if (!file) throw tools::Failure(path, "cannot be read", "give the file that lumi bench --json wrote");
    std::vector<ModeCost> costs;
    try {
        for (const auto& result : nlohmann::json::parse(file)) {
            if (result.at("view") != "generic") continue;
            costs.push_back(cost_of(result));
        }
    } catch (const nlohmann::json::exception&) {
        throw tools::Failure(path, "does not hold rows of a bench", "give the file that lumi bench --json wrote");
    }
    return costs;
}

}  // namespace lumi::quality
