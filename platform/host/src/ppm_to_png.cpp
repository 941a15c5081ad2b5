// SPDX-License-Identifier: MIT
// lumi_ppm_to_png PICTURE.ppm...
// Writes PICTURE.png beside each PPM picture (P6, 8 bits a channel) that firmware left on this machine.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "lumi/host/png.h"

namespace
{

namespace fs = std::filesystem;

void convert(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    file >> magic >> width >> height >> most;
    file.get();  // one white space ends the header
    if (!file || magic != "P6" || most != 255) throw std::runtime_error("it is no PPM picture of 8 bits a channel");
    lumi::host::check_picture_size(width, height);
    std::string rgb(size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(height), '\0');
    if (!file.read(rgb.data(), static_cast<std::streamsize>(rgb.size()))) throw std::runtime_error("it ends too early");
    std::ofstream png(fs::path(path).replace_extension(".png"), std::ios::binary);
    png << lumi::host::png_bytes({width, height, reinterpret_cast<const uint8_t*>(rgb.data())});
    if (!png.flush()) throw std::runtime_error("its PNG cannot be written");
}

}  // namespace

int main(int count, char** arguments)
{
    if (count < 2) {
        std::fputs("lumi_ppm_to_png PICTURE.ppm...\n", stderr);
        return 2;
    }
    for (int k = 1; k < count; ++k) try {
            convert(arguments[k]);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "lumi_ppm_to_png: %s: %s\n", arguments[k], error.what());
            return 1;
        }
    return 0;
}
