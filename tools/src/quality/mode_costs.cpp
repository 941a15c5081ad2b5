// SPDX-License-Identifier: MIT
#include "quality/mode_costs.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"

namespace lumi::quality
{

std::vector<ModeCost> read_mode_costs(const std::string& path)
{
    baker::note_input(path);
    std::ifstream file(path);
    if (!file) throw tools::Failure(path, "cannot be read", "give the file that lumi bench --json wrote");
    std::vector<ModeCost> costs;
    try {
        for (const auto& row : nlohmann::json::parse(file)) {
            if (row.at("view") != "generic") continue;
            costs.push_back(
                {row.at("core"), row.at("mode"), row.at("texel"), row.at("span"), row.at("instructions_per_pixel")});
        }
    } catch (const nlohmann::json::exception&) {
        throw tools::Failure(path, "does not hold rows of a bench", "give the file that lumi bench --json wrote");
    }
    return costs;
}

}  // namespace lumi::quality
