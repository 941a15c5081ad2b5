// SPDX-License-Identifier: MIT
// Stands before tinyobjloader: hands it the sound lines of an OBJ text, and keeps what it does not tell.
#pragma once

#include <optional>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "model/losses.h"

namespace lumi::baker
{

// A name as it is written, with blanks, and where it stands first.
struct ObjName {
    std::string name;
    uint32_t line;
};

// A name, whose index in a face lies beyond `count`, such as "vertex".
[[noreturn]] void fail_beyond(const Place& place, const char* name, int64_t index, size_t count);

// Hands over one line at a time, rewritten so that the package reads it right: one blank between words, numbers in
// range, and no more words than are read. Odd lines are left out and counted. Reading throws SceneError where a line
// makes no sense, and at the end where there was no face.
//
// The package reads each line to its end before it asks for the next one. So line() and what follows it belong to the
// element that it delivers.
class ObjLines : public std::streambuf
{
public:
    // `text` and `losses` must outlive this.
    ObjLines(const std::string& file, std::string_view text, Losses& losses);

    const Line& line() const { return line_; }
    Place place() const { return {file_, line_.number}; }
    uint32_t smoothing() const { return smoothing_; }             // group, 0 = none
    const std::optional<Rgb>& colour() const { return colour_; }  // a position may have one in the file

    // Returns the material libraries so far.
    std::vector<ObjName> libraries;

protected:
    int_type underflow() override;

private:
    bool take();
    bool take_other();
    bool take_position();
    bool take_numbers(size_t least, size_t most);
    void take_colour();
    bool take_face();
    void check_corner(std::string_view corner) const;
    void check_index(std::string_view number, size_t part) const;
    void take_smoothing();
    bool leave_out(const std::string& kind);
    [[noreturn]] void fail_without_faces() const;

    std::string file_;
    Losses& losses_;
    Lines lines_;
    Line line_ = {};
    std::string out_;        // the package gets this for it
    size_t counts_[3] = {};  // positions, texture coordinates and normals so far
    std::optional<Rgb> colour_;
    uint32_t smoothing_ = 0;
    bool has_faces_ = false, has_lines_ = false, has_free_forms_ = false;
};

}  // namespace lumi::baker
