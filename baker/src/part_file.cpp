// SPDX-License-Identifier: MIT
#include "part_file.h"

#include "lumi/baker/bake.h"

namespace lumi::baker
{

PartFile::PartFile(const std::filesystem::path& target) : target_(target), part_(target)
{
    part_ += ".part";
    std::error_code ignored;
    if (std::filesystem::is_directory(target_, ignored)) {
        throw BakeError(target_.string() + ": this is a folder; name a file in it");
    }
    stream_.open(part_, std::ios::binary | std::ios::trunc);
    if (!stream_) {
        throw BakeError(part_.string() + ": the file cannot be created; check that the folder exists and is writable");
    }
}

PartFile::~PartFile()
{
    if (!committed_) {
        stream_.close();
        std::error_code ignored;
        std::filesystem::remove(part_, ignored);
    }
}

void PartFile::write(const std::vector<uint8_t>& bytes)
{
    stream_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream_) {
        throw BakeError(part_.string() + ": writing failed; check that the disk has room");
    }
}

void PartFile::commit()
{
    stream_.close();
    if (!stream_) {
        throw BakeError(part_.string() + ": writing failed; check that the disk has room");
    }
    std::error_code error;
    std::filesystem::rename(part_, target_, error);
    if (error) {
        throw BakeError(target_.string() + ": the finished file cannot get its name (" + error.message() +
                        "); check that it is not in use");
    }
    committed_ = true;
}

}  // namespace lumi::baker
