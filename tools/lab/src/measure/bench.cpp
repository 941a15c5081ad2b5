// SPDX-License-Identifier: MIT
// lumi-lab bench: tools/lab/bench.py, which builds firmware and runs it on emulated boards.
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "measure/commands.h"
#include "terminal/failure.h"

namespace lumi::lab
{

void add_bench(CLI::App& lab)
{
    CLI::App* command = lab.add_subcommand(
        "bench", "Count what drawing costs on emulated microcontrollers, and how exact the pictures are");
    command->set_help_flag();  // the script has its own
    command->prefix_command();
    command->callback([command] {
        std::vector<std::string> words = {"python3", "-B", LUMI_SOURCE_DIR "/tools/lab/bench.py"};
        for (const std::string& word : command->remaining()) words.push_back(word);
        std::vector<char*> pointers;
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        execvp(pointers[0], pointers.data());
        throw tools::Failure(words[0], std::strerror(errno), "install python3");
    });
}

}  // namespace lumi::lab
