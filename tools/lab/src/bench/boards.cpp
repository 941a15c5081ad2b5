// SPDX-License-Identifier: MIT
#include "bench/boards.h"

#include <fstream>
#include <sstream>

#include "bench/process.h"
#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"

namespace lumi::bench
{
namespace
{

using tools::Failure;

std::string cpu_of(const std::string& core)
{
    return "cortex-" + core;
}

std::vector<std::string> configure_command(const std::string& core, const std::filesystem::path& source,
                                           const std::filesystem::path& folder)
{
    return {"cmake",
            "-S",
            source,
            "-B",
            folder,
            "-G",
            "Ninja",
            "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
            "-DCMAKE_TOOLCHAIN_FILE=" + (source / "toolchains" / (cpu_of(core) + ".cmake")).string(),
            "-DLUMI_BUILD_FIRMWARE=ON",
            "-DLUMI_BUILD_TESTS=OFF"};
}

// Berkeley format: a line of titles, then text, data, bss, …
uint32_t flash_bytes(const std::filesystem::path& program)
{
    std::istringstream listing(run_program({"arm-none-eabi-size", program}));
    std::string titles;
    uint32_t text = 0, data = 0;
    std::getline(listing, titles);
    if (!(listing >> text >> data)) throw Failure(program, "has no readable size", "rebuild it");
    return text + data;
}

// QEMU separates suboptions by commas; a comma within one is doubled.
std::string suboption(const std::string& text)
{
    std::string result;
    for (const char c : text) result += c == ',' ? std::string(",,") : std::string(1, c);
    return result;
}

// Reads `word value` and checks the word.
template <class Value>
bool read_pair(std::istringstream& line, const char* word, Value& value)
{
    std::string found;
    return line >> found && found == word && line >> value;
}

void require_count(bool is_one, const std::string& text)
{
    if (!is_one) throw Failure("the bench firmware", "wrote \"" + text + "\"", "clear the work folder and build anew");
}

Count parse_count(const std::string& text)
{
    std::istringstream line(text);
    Count count;
    std::string crc;
    const bool complete = read_pair(line, "view", count.view) && read_pair(line, "span", count.span) &&
                          read_pair(line, "covered", count.covered) &&
                          read_pair(line, "instructions", count.instructions) &&
                          read_pair(line, "setup", count.setup) && read_pair(line, "stack", count.stack_bytes) &&
                          read_pair(line, "crc", crc);
    require_count(complete && count.instructions != 0 && count.covered != 0, text);
    count.crc = static_cast<uint32_t>(std::stoul(crc, nullptr, 16));
    return count;
}

SurfaceCount parse_surface_count(const std::string& text)
{
    std::istringstream line(text);
    SurfaceCount c;
    std::string crc;
    const bool complete = read_pair(line, "view", c.view) && read_pair(line, "mode", c.mode) &&
                          read_pair(line, "covered", c.covered) && read_pair(line, "instructions", c.instructions) &&
                          read_pair(line, "palette", c.palette) && read_pair(line, "vertices", c.vertices) &&
                          read_pair(line, "lists", c.lists) && read_pair(line, "lights", c.lights) &&
                          read_pair(line, "edges", c.edges) && read_pair(line, "samples", c.samples) &&
                          read_pair(line, "outlines", c.outlines) && read_pair(line, "resolve", c.resolve) &&
                          read_pair(line, "stack", c.stack_bytes) && read_pair(line, "ram", c.ram_bytes) &&
                          read_pair(line, "crc", crc);
    require_count(complete && c.instructions != 0 && c.covered != 0, text);
    c.crc = static_cast<uint32_t>(std::stoul(crc, nullptr, 16));
    return c;
}

}  // namespace

Board::Board(const std::string& core, const std::filesystem::path& source, const std::filesystem::path& work)
    : folder_(work / cpu_of(core))
{
    run_program(configure_command(core, source, folder_));
    const std::filesystem::path facts = folder_ / "platform" / "mps2" / "bench" / "board.txt";
    baker::note_input(facts);
    std::ifstream board(facts);
    if (!(board >> machine_ >> field_address_))
        throw Failure(folder_, "was not configured", "clear the work folder and run again");
}

void Board::build(const std::vector<std::string>& renderers) const
{
    std::vector<std::string> command = {"cmake", "--build", folder_, "--target", "lumi_bench_size_empty"};
    for (const std::string& renderer : renderers) {
        command.push_back("lumi_bench_" + renderer);
        command.push_back("lumi_bench_size_" + renderer);
    }
    run_program(command);
}

std::filesystem::path Board::program(const std::string& name) const
{
    return folder_ / "platform" / "mps2" / "bench" / ("lumi_bench_" + name + ".elf");
}

uint32_t Board::code_bytes(const std::string& renderer) const
{
    return flash_bytes(program("size_" + renderer)) - flash_bytes(program("size_empty"));
}

std::string Board::run(const std::string& renderer, const std::filesystem::path& field,
                       const std::vector<std::string>& words) const
{
    std::string semihosting = "enable=on,target=native,chardev=console,arg=bench";
    for (const std::string& word : words) semihosting += ",arg=" + word;
    const std::string loader = "loader,file=" + suboption(field.string()) + ",addr=" + field_address_ + ",force-raw=on";
    return run_program({"qemu-system-arm", "-M", machine_, "-display", "none", "-serial", "none", "-monitor", "none",
                        "-chardev", "stdio,id=console", "-semihosting-config", semihosting, "-icount", "shift=0",
                        "-device", loader, "-kernel", program(renderer)});
}

std::vector<Count> Board::count(const std::string& renderer, const std::filesystem::path& field,
                                const std::vector<std::string>& views, const std::vector<int>& spans) const
{
    std::vector<std::string> words = views;
    for (const int span : spans) words.push_back(std::to_string(span));
    return parse_counts(run(renderer, field, words));
}

std::vector<SurfaceCount> Board::count_surface(const std::string& renderer, const std::filesystem::path& field,
                                               const std::vector<std::string>& views,
                                               const std::vector<std::string>& modes) const
{
    std::vector<std::string> words = views;
    words.insert(words.end(), modes.begin(), modes.end());
    return parse_surface_counts(run(renderer, field, words));
}

std::vector<Count> parse_counts(const std::string& text)
{
    std::vector<Count> counts;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) counts.push_back(parse_count(line));
    return counts;
}

std::vector<SurfaceCount> parse_surface_counts(const std::string& text)
{
    std::vector<SurfaceCount> counts;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) counts.push_back(parse_surface_count(line));
    return counts;
}

}  // namespace lumi::bench
