// SPDX-License-Identifier: MIT
#include "scene/named_triangles.h"

#include <algorithm>
#include <set>

#include "lumi/host/nearest_word.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

std::vector<bool> marked(const std::string& name, const SceneParts& parts)
{
    const Mesh& mesh = parts.mesh;
    std::vector<bool> chosen(mesh.triangle_count(), false);
    for (const NamedPart& part : parts.named)
        if (part.name == name)
            std::fill(chosen.begin() + static_cast<ptrdiff_t>(part.first),
                      chosen.begin() + static_cast<ptrdiff_t>(part.end), true);
    if (std::find(chosen.begin(), chosen.end(), true) != chosen.end()) return chosen;
    for (size_t t = 0; t < chosen.size(); ++t) chosen[t] = parts.materials[mesh.materials[t]].name == name;
    return chosen;
}

std::vector<std::string> names_in(const SceneParts& parts)
{
    std::set<std::string> names;
    for (const NamedPart& part : parts.named)
        if (part.end > part.first) names.insert(part.name);
    for (const uint32_t material : parts.mesh.materials) names.insert(parts.materials[material].name);
    names.erase("");
    return {names.begin(), names.end()};
}

std::string listed(std::vector<std::string> names)
{
    constexpr size_t kMost = 20;
    const size_t count = names.size();
    names.resize(std::min(count, kMost));
    return joined(names, ", ") + (count > kMost ? ", and " + std::to_string(count - kMost) + " more" : "");
}

}  // namespace

std::vector<bool> triangles_named(const std::string& name, const std::string& file, const SceneParts& parts)
{
    std::vector<bool> chosen = marked(name, parts);
    if (std::find(chosen.begin(), chosen.end(), true) != chosen.end()) return chosen;
    const std::vector<std::string> names = names_in(parts);
    throw SceneError(at({file}, "no object, group, node or material with triangles is named '" + name + "'" +
                                    host::meant(name, names) + "; choose among: " + listed(names)));
}

}  // namespace lumi::baker
