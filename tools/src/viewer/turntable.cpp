// SPDX-License-Identifier: MIT
#include "viewer/turntable.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "files/output_file.h"
#include "image/picture_file.h"
#include "lumi/baker/file_guard.h"
#include "terminal/child_program.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

constexpr char kTurntableMend[] = "write it with lumi reference SCENE -o DIR/view.png --turntable 36";

struct Series {
    std::string name;
    std::map<int, std::string> paths;  // by number
};

Series series_of(const std::string& folder)
{
    const std::regex numbered("(.*)-([0-9]{3})\\.png");
    Series series;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        std::smatch match;
        const std::string name = entry.path().filename().string();
        if (!std::regex_match(name, match, numbered)) continue;
        if (!series.paths.empty() && match[1].str() != series.name)
            throw Failure(folder, "holds more than one turntable, " + series.name + " and " + match[1].str(),
                          "give each a folder of its own");
        series.name = match[1].str();
        series.paths[std::stoi(match[2].str())] = entry.path().string();
    }
    if (error) throw Failure(folder, error.message(), kTurntableMend);
    if (series.paths.size() < 2) throw Failure(folder, "holds no turntable of path-traced pictures", kTurntableMend);
    return series;
}

std::string bytes_of(const std::string& path)
{
    baker::note_input(path);
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::vector<std::string> read_turntable(const std::string& folder)
{
    const Series series = series_of(folder);
    const Picture first = read_png(series.paths.begin()->second);
    std::vector<std::string> pictures;
    for (const auto& [number, path] : series.paths) {
        if (number != static_cast<int>(pictures.size()))
            throw Failure(folder, "picture " + std::to_string(pictures.size()) + " of the turntable is missing",
                          kTurntableMend);
        const Picture picture = read_png(path);
        if (picture.width_px != first.width_px || picture.height_px != first.height_px)
            throw Failure(path, "has another size than the first picture of its turntable", kTurntableMend);
        pictures.push_back(bytes_of(path));
    }
    return pictures;
}

std::string show_in_browser(const std::string& name, const std::string& html)
{
    constexpr char kMend[] = "install a browser and xdg-utils, or write the page to a file with -o view.html";
    const std::string path = (new_temporary_folder(kMend) / (name + ".html")).string();
    write_output(path, html);
    run_program("xdg-open", {path}, kMend);
    return path;
}

}  // namespace lumi::tools
