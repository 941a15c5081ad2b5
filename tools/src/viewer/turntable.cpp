// SPDX-License-Identifier: MIT
#include "viewer/turntable.h"

#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "files/output_file.h"
#include "image/picture_file.h"
#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"

extern "C" char** environ;

namespace lumi::tools
{

namespace
{

// Runs a program of PATH with these arguments and waits for its end. Throws Failure where it is not installed or does
// not end with 0; `mend` then says what to do instead.
void run_program(std::string name, std::vector<std::string> arguments, const std::string& mend)
{
    std::vector<char*> words = {name.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    pid_t child = 0;
    if (::posix_spawnp(&child, name.c_str(), nullptr, nullptr, words.data(), environ) != 0)
        throw Failure(name, "this program is not installed", mend);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw Failure(name, std::strerror(errno), mend);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Failure(name, "this program failed", mend);
}

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
    const std::filesystem::path folder = new_temporary_folder(
        "set TMPDIR to a folder that you may write to, or write the page to a file with -o view.html");
    try {
        const std::string path = (folder / (name + ".html")).string();
        write_output(path, html);
        run_program("xdg-open", {path}, kMend);
        return path;
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
        throw;
    }
}

}  // namespace lumi::tools
