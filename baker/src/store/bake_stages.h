// SPDX-License-Identifier: MIT
// Keeps the results of a surface bake's stages from one process to the next: mesh, pilot, solution. The light between
// pilot and solution has a checkpoint of its own (surface/surface_file_store.h).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "lumi/baker/surface.h"
#include "store/posix_file.h"
#include "util/byte_stream.h"
#include "util/digest.h"

namespace lumi::baker
{

// Results of a bake's stages, kept under keys in one file until the bake is done, so that one that is killed again and
// again gets on.
//
//   record  key, 16 bytes; size of the result, 8; CRC-32 of both and of the result, 4; the result
//
// To keep is a convenience: where the file cannot be locked, read or written, nothing is kept, and nothing fails.

class StageFile
{
public:
    // Nothing is made until something is added. An empty path keeps nothing.
    explicit StageFile(std::filesystem::path path);

    // False if it is not there or damaged; the output is then unspecified.
    bool find(const Digest::Value& key, std::vector<uint8_t>& bytes) const;
    const std::filesystem::path& path() const { return path_; }  // empty: nothing is kept
    void add(const Digest::Value& key, const std::vector<uint8_t>& bytes);
    // Does so in the place of an older result that is no longer needed, if that is there and as long.
    void add_over(const Digest::Value& older, const Digest::Value& key, const std::vector<uint8_t>& bytes);
    // Where the record of a result begins; where the next one would, if it is not there.
    uint64_t begin_of(const Digest::Value& key) const;
    // Forgets what lies from there on.
    void cut(uint64_t begin);

private:
    struct Place {
        uint64_t offset, size;  // where the result lies in the file, and how long it is
    };

    void open(PosixFile::Mode mode);
    void read_places();
    void give_up();
    void write(uint64_t at, const Digest::Value& key, const std::vector<uint8_t>& bytes);

    std::filesystem::path path_;  // empty: nothing is kept
    std::unique_ptr<PosixFile> file_;
    std::map<Digest::Value, Place> places_;
    uint64_t end_ = 0;
};

class BakeStages
{
public:
    // Bakes of this scene (with these settings) share results, whatever their threads. An empty path keeps nothing.
    BakeStages(const std::filesystem::path& file, const Digest::Value& scene);
    BakeStages(const std::filesystem::path& file, const Digest::Value& scene, SurfaceSettings settings);

    // Keeps all that follows for a moving part, or with 0 for the body.
    void begin_part(uint32_t owner) { owner_ = owner; }

    // Returns what make() returns, or what was kept of it under the same name and settings (numbers, or structs of
    // nothing but numbers of one size). byte_stream.h says how a result becomes bytes.
    template <class Result, class Make, class... Settings>
    Result once(const char* name, Make make, const Settings&... settings)
    {
        const Digest::Value key = key_of(name, settings...);
        if (std::vector<uint8_t> bytes; file_.find(key, bytes))
            if (std::optional<Result> kept = from_bytes<Result>(bytes)) return std::move(*kept);
        Result result = make();
        file_.add(key, to_bytes(result));
        return result;
    }

    // Returns what step(k, result) makes for k = 0 .. count - 1, one after the other, until it returns false. Only the
    // last two of them are kept, so that one is whole while the other is written.
    template <class Result, class Step>
    Result in_steps(const char* name, uint32_t count, Step step)
    {
        Result result = {};
        uint32_t next = count;
        for (std::vector<uint8_t> bytes; next != 0; --next) {
            if (!file_.find(key_of(name, next - 1), bytes)) continue;
            if (std::optional<Result> kept = from_bytes<Result>(bytes)) {
                result = std::move(*kept);
                break;
            }
        }
        for (; next < count && step(next, result); ++next) {
            const Digest::Value key = key_of(name, next);
            next < 2 ? file_.add(key, to_bytes(result)) : file_.add_over(key_of(name, next - 2), key, to_bytes(result));
        }
        return result;
    }

    // Forgets what was kept of this scene and these settings since then, the first result under that name.
    template <class... Settings>
    void forget_from(const char* name, const Settings&... settings)
    {
        file_.cut(file_.begin_of(key_of(name, settings...)));
    }

    // Throws BakeError unless what was kept has the shape that the bake needs.
    void require_shape(bool fits) const;

private:
    template <class... Settings>
    Digest::Value key_of(const char* name, const Settings&... settings) const
    {
        Digest digest = scene_;
        digest.add(std::string(name));
        digest.add(owner_);
        (digest.add(settings), ...);
        return digest.value();
    }

    StageFile file_;
    Digest scene_;
    uint32_t owner_ = 0;
};

}  // namespace lumi::baker
