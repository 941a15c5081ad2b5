// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "baking/measurements.h"
#include "baking/texels.h"

namespace lumi::baker::bench
{
namespace
{

// A number of /proc/self/status, in bytes.
double status_bytes(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(name + ":", 0) == 0) return 1024 * std::stod(line.substr(name.size() + 1));
    return 0;
}

// A wavy square of about that many triangles, with texture coordinates and normals for smoothing.
void write_waves(const std::filesystem::path& file, unsigned triangles)
{
    const auto side = static_cast<unsigned>(std::sqrt(triangles / 2));
    std::ofstream out(file);
    out << "s 1\n";
    for (unsigned y = 0; y <= side; ++y) {
        for (unsigned x = 0; x <= side; ++x) {
            const double u = 1.0 * x / side, v = 1.0 * y / side;
            out << "v " << u << ' ' << 0.05 * std::sin(20 * u) * std::sin(30 * v) << ' ' << v << "\nvt " << u << ' '
                << v << '\n';
        }
    }
    for (unsigned y = 0; y < side; ++y) {
        for (unsigned x = 0; x < side; ++x) {
            const unsigned a = y * (side + 1) + x + 1, b = a + side + 1;
            out << "f " << a << '/' << a << ' ' << b << '/' << b << ' ' << b + 1 << '/' << b + 1 << ' ' << a + 1 << '/'
                << a + 1 << '\n';
        }
    }
}

}  // namespace

Json memory(unsigned triangles)
{
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("lumi-bench-" + std::to_string(getpid()) + ".obj");
    write_waves(file, triangles);
    const double before = status_bytes("VmRSS"), bytes_of_file = static_cast<double>(std::filesystem::file_size(file));
    const Scene scene = load(file.c_str());
    std::filesystem::remove(file);
    const double millions = 1e-6 * static_cast<double>(scene.triangle_count());
    const Json row = {{"triangles", scene.triangle_count()},
                      {"file_bytes", bytes_of_file},
                      {"held_bytes_a_million", (status_bytes("VmRSS") - before) / millions},
                      {"most_bytes_a_million", (status_bytes("VmHWM") - before) / millions}};
    return Json::array({row});
}

}  // namespace lumi::baker::bench
