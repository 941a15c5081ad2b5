// SPDX-License-Identifier: MIT
// Results of a bake's stages, kept under keys in one file until the bake is done, so that one that is killed again and
// again gets on.
//
//   record  key, 16 bytes; size of the result, 8; CRC-32 of both and of the result, 4; the result
//
// To keep is a convenience: where the file cannot be locked, read or written, nothing is kept, and nothing fails.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "store/posix_file.h"
#include "util/digest.h"

namespace lumi::baker
{

class StageFile
{
public:
    // Nothing is made until something is added. An empty path keeps nothing.
    explicit StageFile(std::filesystem::path path);

    // False if it is not there or damaged; the output is then unspecified.
    bool find(const Digest::Value& key, std::vector<uint8_t>& bytes) const;
    const std::filesystem::path& path() const { return path_; }  // empty: nothing is kept
    void add(const Digest::Value& key, const std::vector<uint8_t>& bytes);

private:
    struct Place {
        uint64_t offset, size;  // where the result lies in the file, and how long it is
    };

    void open(PosixFile::Mode mode);
    void read_places();
    void give_up();
    void write(const Digest::Value& key, const std::vector<uint8_t>& bytes);

    std::filesystem::path path_;  // empty: nothing is kept
    std::unique_ptr<PosixFile> file_;
    std::map<Digest::Value, Place> places_;
    uint64_t end_ = 0;
};

}  // namespace lumi::baker
