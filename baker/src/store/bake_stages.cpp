// SPDX-License-Identifier: MIT
#include "store/bake_stages.h"

#include <algorithm>

#include "lumi/baker/bake.h"
#include "lumi/baker/file_guard.h"
#include "store/bake_identity.h"
#include "util/byte_stream.h"
#include "util/gzip.h"

namespace lumi::baker
{

namespace
{

constexpr uint64_t kKeyBytes = 16, kCrcAt = kKeyBytes + 8, kEntryHeadBytes = kCrcAt + 4;

// The bytes of a record's head, up to its CRC.
std::vector<uint8_t> head_of(const Digest::Value& key, uint64_t size)
{
    ByteWriter out;
    for (const uint64_t word : {key[0], key[1], size}) out.put64(word);
    return out.bytes();
}

uint32_t crc_of_both(const std::vector<uint8_t>& head, const std::vector<uint8_t>& bytes)
{
    return checksum(checksum(0, head.data(), head.size()), bytes.data(), bytes.size());
}

bool is_file(const std::filesystem::path& path)
{
    std::error_code ignored;
    return !path.empty() && std::filesystem::is_regular_file(path, ignored);
}

}  // namespace

StageFile::StageFile(std::filesystem::path path) : path_(std::move(path))
{
    if (!is_file(path_)) return;
    try {
        open(PosixFile::Mode::update);
        read_places();
    } catch (const BakeError&) {
        path_.clear();
    }
}

void StageFile::open(PosixFile::Mode mode)
{
    require_no_input(path_);
    auto file = std::make_unique<PosixFile>(path_, mode);
    if (!file->try_lock()) throw BakeError(path_.string() + ": another lumi is baking this");
    file_ = std::move(file);
}

// As far as records are whole.
void StageFile::read_places()
{
    const uint64_t all = file_->size();
    uint8_t head[kEntryHeadBytes];
    while (end_ + kEntryHeadBytes <= all && file_->read_at(end_, head, kEntryHeadBytes) == kEntryHeadBytes) {
        ByteReader in(head, kEntryHeadBytes);
        Digest::Value key;
        for (uint64_t& word : key) word = in.get64();
        const Place place = {end_ + kEntryHeadBytes, in.get64()};
        if (place.size > all - place.offset) return;
        places_[key] = place;
        end_ = place.offset + place.size;
    }
}

bool StageFile::find(const Digest::Value& key, std::vector<uint8_t>& bytes) const
{
    const auto place = places_.find(key);
    if (place == places_.end()) return false;
    try {
        bytes.resize(place->second.size);
        uint8_t crc[4];
        const uint64_t at = place->second.offset;
        return file_->read_at(at - sizeof crc, crc, sizeof crc) == sizeof crc &&
               file_->read_at(at, bytes.data(), bytes.size()) == bytes.size() &&
               ByteReader(crc, sizeof crc).get32() == crc_of_both(head_of(key, bytes.size()), bytes);
    } catch (const BakeError&) {
        return false;
    }
}

void StageFile::add(const Digest::Value& key, const std::vector<uint8_t>& bytes)
{
    add_over(key, key, bytes);
}

void StageFile::add_over(const Digest::Value& older, const Digest::Value& key, const std::vector<uint8_t>& bytes)
{
    if (path_.empty()) return;
    const auto place = places_.find(older);
    const bool takes_place = place != places_.end() && place->second.size == bytes.size();
    const uint64_t at = takes_place ? place->second.offset - kEntryHeadBytes : end_;
    if (takes_place) places_.erase(place);
    try {
        write(at, key, bytes);
    } catch (const BakeError&) {
        give_up();
    }
}

uint64_t StageFile::begin_of(const Digest::Value& key) const
{
    const auto place = places_.find(key);
    return place == places_.end() ? end_ : place->second.offset - kEntryHeadBytes;
}

void StageFile::cut(uint64_t begin)
{
    if (!file_ || begin == end_) return;
    for (auto place = places_.begin(); place != places_.end();)
        place = place->second.offset > begin ? places_.erase(place) : std::next(place);
    end_ = begin;
    try {
        file_->cut(begin);
    } catch (const BakeError&) {
        give_up();
    }
}

void StageFile::write(uint64_t at, const Digest::Value& key, const std::vector<uint8_t>& bytes)
{
    if (!file_) open(PosixFile::Mode::create);
    std::vector<uint8_t> record = head_of(key, bytes.size());
    ByteWriter crc;
    crc.put32(crc_of_both(record, bytes));
    record.insert(record.end(), crc.bytes().begin(), crc.bytes().end());
    record.insert(record.end(), bytes.begin(), bytes.end());
    file_->write_at(at, record.data(), record.size());
    places_[key] = {at + kEntryHeadBytes, bytes.size()};
    end_ = std::max(end_, at + record.size());
}

// A full disk is needed for the field itself.
void StageFile::give_up()
{
    if (file_) {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    path_.clear();
    file_.reset();
    places_.clear();
}

BakeStages::BakeStages(const std::filesystem::path& file, const Digest::Value& scene) : file_(file)
{
    constexpr uint32_t kFormat = 2;  // of what is kept, and what it means
    scene_.add(std::string(LUMI_VERSION));
    scene_.add(kFormat);
    scene_.add(scene);
}

BakeStages::BakeStages(const std::filesystem::path& file, const Digest::Value& scene, SurfaceSettings settings)
    : BakeStages(file, scene)
{
    settings.threads = 0;
    ByteWriter bytes;
    put_settings(bytes, settings);
    scene_.add(bytes.bytes());
}

void BakeStages::require_shape(bool fits) const
{
    if (!fits) throw BakeError(file_.path().string() + ": is damaged; discard it with --restart");
}

}  // namespace lumi::baker
