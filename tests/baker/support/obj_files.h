// SPDX-License-Identifier: MIT
// OBJ files, read with their warnings.
#pragma once

#include <filesystem>
#include <string>

#include "model/readers.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker::testing
{

inline constexpr char kCorners[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
inline const std::string kRedPixel = rgb_png(1, {255, 0, 0});

struct LoadedObj {
    SceneParts parts;
    std::string warnings;  // a line each
};

inline LoadedObj load_obj_file(const std::filesystem::path& file)
{
    LoadedObj loaded;
    std::vector<std::string> lines;
    loaded.parts = read_obj(file, lines);
    for (const std::string& line : lines) loaded.warnings += line + "\n";
    return loaded;
}

inline LoadedObj load_obj(const std::string& text)
{
    const ScratchFolder folder;
    return load_obj_file(folder.write("scene.obj", text));
}

}  // namespace lumi::baker::testing
