// SPDX-License-Identifier: MIT
#include "store/new_file.h"

#include "lumi/baker/bake.h"
#include "lumi/baker/file_guard.h"
#include "output_names.h"

namespace lumi::baker
{
namespace
{

std::filesystem::path beside(const std::filesystem::path& target)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(target, ignored))
        throw BakeError(target.string() + ": this is a folder; name a file in it");
    std::filesystem::path name = unfinished(target);
    require_no_input(target);
    require_no_input(name);
    return name;
}

}  // namespace

NewFile::NewFile(const std::filesystem::path& target) : target_(target), file_(beside(target), PosixFile::Mode::create)
{
    file_.cut(0);
}

NewFile::~NewFile()
{
    if (!committed_) {
        std::error_code ignored;
        std::filesystem::remove(file_.path(), ignored);
    }
}

void NewFile::append(const std::vector<uint8_t>& bytes)
{
    overwrite(size_, bytes);
    size_ += bytes.size();
}

void NewFile::overwrite(uint64_t offset, const std::vector<uint8_t>& bytes)
{
    file_.write_at(offset, bytes.data(), bytes.size());
}

void NewFile::commit()
{
    file_.sync();
    require_no_input(target_);
    const std::filesystem::path folder = target_.parent_path();  // nothing that may fail comes behind the renaming
    file_.rename_to(target_);
    committed_ = true;
    sync_folder(folder);
}

}  // namespace lumi::baker
