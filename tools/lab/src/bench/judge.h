// SPDX-License-Identifier: MIT
// How far a drawn picture is from the exact one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "image/picture.h"
#include "lumi/bench/views.h"
#include "lumi/chord/field.h"
#include "lumi/twin/picture.h"

namespace lumi::bench
{

// Holds the taps of every covered pixel of a view in double precision, for one pair of lattices.
struct ViewTaps {
    struct Pixel {
        int x, y;
        twin::Weights origins, directions;
        bool uncertain;  // one of its points was a close call
    };
    std::vector<Pixel> pixels;
};

struct Accuracy {
    double psnr_db = 0;        // over covered pixels; nearest: outside cell borders
    double psnr_all_db = 0;    // over all covered pixels as they are
    uint32_t worst_pixel = 0;  // levels of 255, over the pixels of psnr_db
};

// A hit this close to a cell's border, in mean point spacings, may fall to either side without being wrong.
inline constexpr double kBorderShare = 1.0 / 16;

class Judge
{
public:
    // The lattices of `field`; all fields judged must have the same.
    explicit Judge(const Field& field);

    // `drawn` is the picture of `field` from `view` by `mode`, as draw_on_host names it, whatever the span length:
    // nearest is judged by the points that are nearest by brute force.
    Accuracy judge(const std::string& mode, const Field& field, const View& view, const tools::Picture& drawn);

private:
    tools::Picture exact_picture(const std::string& mode, const Field& field, const View& view);
    const ViewTaps& taps_of(const std::string& mode, const View& view);

    std::vector<twin::Vec3> origins_, directions_;
    std::map<std::pair<std::string, std::string>, ViewTaps> taps_;  // by mode and view
};

}  // namespace lumi::bench
