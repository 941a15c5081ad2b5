// SPDX-License-Identifier: MIT
// A report knows these: the references of a scene's held-out views, and what fields show of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/draw.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "lumi/baker/reference.h"
#include "metrics/metrics.h"
#include "quality/references.h"

namespace lumi::quality
{

// Ways to draw a chord field, as words name them.

struct DrawMode {
    std::string name;  // as it was given
    tools::DrawSettings settings;
};

inline constexpr const char* kDrawModeWords =
    "nearest, linear or paperK with K from 1 to 9; the first two also with /S for spans "
    "of S = 2, 4, 8 or 16 pixels, for instance linear/8";

// Reads "linear", "paper9" or "nearest/8", and returns nothing for other words.
std::optional<DrawMode> parse_draw_mode(std::string_view text);

// How a field is drawn: by the one that its layout takes.
struct Way {
    tools::SurfaceDrawSettings surface;
    tools::DrawSettings chord;
};

// Returns the finest way of a surface field, and exact `linear` of a chord field.
Way finest(tools::DisplayFormat display = tools::DisplayFormat::rgb888);

// Describes a kind of picture, drawn for every view.
struct Measured {
    std::string name;    // the file's name
    std::string layout;  // "chord", "surface", "mean alone", "antialiased", ...
    Way way;             // fields are drawn so
    uint64_t flash_bytes = 0;
    std::vector<tools::Section> sections;
    std::vector<tools::Picture> pictures;
    std::vector<Figures> figures;  // one for each view
    Figures mean;
    uint32_t triangles = 0;  // in a surface field
    double draw_ms = 0;      // processor time of one view on this machine, the mean
};

// Returns the view of least PSNR. Precondition: at least one view.
size_t worst_view(const Measured& m);

// Fields are measured against these, by one way of drawing.
struct Yardstick {
    const std::vector<HeldOutView>& views;
    const std::vector<Reference>& references;  // one for each view
    Way way = finest();
};

using DrawView = std::function<tools::Picture(const HeldOutView&)>;

Measured measured(const std::string& name, const std::string& layout, uint64_t flash_bytes, const DrawView& draw,
                  const std::vector<HeldOutView>& views, const std::vector<Reference>& references);

tools::Picture drawn(const tools::FieldFile& file, const HeldOutView& view, const Way& way = finest());
// "chord", "surface", or "mean alone": a surface field whose colours do not depend on the direction of view.
const char* layout_of(const tools::FieldFile& file);
// A field by the best that it offers.
Measured measured_field(const tools::FieldFile& file, const Yardstick& by);

// The cheaper modes of a surface field; a chord field by the modes that are given; as `by` says in all else.
std::vector<Measured> measured_variants(const tools::FieldFile& file, const std::vector<DrawMode>& modes,
                                        const Yardstick& by);

inline constexpr int kQuickViews = 4;

// Finds what fields show in seconds, from few views, small pictures and few light paths; `lumi report` measures
// properly. It is the mean PSNR in dB over kQuickViews views, in the uppermost share `cap` of the sphere. The noise of
// the references is taken out: two of them, independent, give the squared error as the mean of (x - a)(x - b).
class QuickMeasure
{
public:
    // Traces the references. Throws Cancelled.
    QuickMeasure(const baker::Scene& scene, int side_px, double cap, unsigned threads,
                 const baker::ProgressCallback& progress = {});

    double psnr_db(const DrawView& draw) const;

private:
    std::vector<HeldOutView> views_;
    std::vector<Reference> halves_[2];
};

// Does that for one field by its best mode.
double quick_psnr_db(const baker::Scene& scene, const tools::FieldFile& field, double cap, unsigned threads,
                     const baker::ProgressCallback& progress = {});

}  // namespace lumi::quality
