// SPDX-License-Identifier: MIT
#include "scene/model_reader.h"

#include "model/foreign_format.h"
#include "model/gltf/container.h"
#include "model/readers.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

std::string head_of(const std::filesystem::path& file)
{
    auto stream = open_file(file);
    std::string head(kHeadBytesOfModel, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<size_t>(stream.gcount()));
    return head;
}

}  // namespace

SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings, ColourScale colours)
{
    const std::string head = head_of(file), end = extension_of(file);
    if (is_glb(head)) return read_gltf(file, warnings);
    if (is_ply(head)) return read_ply(file, warnings);
    if (is_stl(head, std::filesystem::file_size(file))) return read_stl(file, warnings);
    refuse_foreign_model(file, head);
    if (end == ".glb" || end == ".gltf") return read_gltf(file, warnings);
    if (end == ".ply") return read_ply(file, warnings);
    if (end == ".stl") return read_stl(file, warnings);
    return read_obj(file, warnings, colours);
}

}  // namespace lumi::baker
