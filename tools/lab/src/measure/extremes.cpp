// SPDX-License-Identifier: MIT
// lumi-lab extremes: how far chord pictures are from exact ones at the ends of what views and lattices can be. The
// exact ones share nothing with core but the numbers of a pose and an image: double precision, the plain quadratic
// equation, and the twin's look at every point of both lattices. Texels are random, or the number of a point.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "lumi/chord/render_spans.h"
#include "lumi/twin/weights.h"
#include "measure/commands.h"
#include "measure/extreme_views.h"
#include "terminal/failure.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;
using Points = std::vector<twin::Vec3>;

constexpr int kSpan = 16;
constexpr uint32_t kPaperPoints = 5;
constexpr int32_t kRowsAView = 24, kPixelsARow = 10, kPixelsOfMany = 24;
constexpr uint32_t kMany = 20000;  // points of which each look takes long
constexpr double kTurn = 4294967296.0;
constexpr double kRim = 1.0 / 4096;  // the square of half a chord below which a ray counts as missing: chord/camera.h
constexpr double kRimTolerance = 0.0001;  // as a share of that square: so near to the rim either is right
constexpr double kInside = 0.19;          // as a share of that square: nine tenths of the disc's radius
constexpr Rgb8 kNothing = {16, 16, 16};   // no point has this number

uint32_t number_of(const Rgb8& c)
{
    return static_cast<uint32_t>(c.r << 16 | c.g << 8 | c.b);
}

// A field of 24-bit texels in memory.
struct Texels {
    std::vector<uint8_t> bytes;
    Field field;

    Texels(uint32_t origins, uint32_t directions, const std::function<uint32_t(uint32_t, uint32_t)>& of)
    {
        field.origins = detail::Lattice(origins);
        field.directions = detail::Lattice(directions);
        field.used_origins = origins;
        field.row_stride_bytes = 3 * directions;
        bytes.reserve(size_t{3} * origins * directions);
        for (uint32_t k = 0; k < origins * directions; ++k) {
            const uint32_t v = of(k / directions, k % directions);
            for (const int shift : {16, 8, 0}) bytes.push_back(static_cast<uint8_t>(v >> shift));
        }
        field.texels = bytes.data();
    }
    const uint8_t* at(uint32_t i, uint32_t j) const { return &bytes[size_t{3} * (i * field.directions.size() + j)]; }
};

enum class Content : uint8_t { random, none, white };

struct Lattices {
    Points origins, directions;
    Texels by_origin, by_direction, shades;

    Lattices(uint32_t m, uint32_t n, Content content)
        : origins(twin::points(m)),
          directions(twin::points(n)),
          by_origin(m, n, [](uint32_t i, uint32_t) { return i + 1; }),
          by_direction(m, n, [](uint32_t, uint32_t j) { return j + 1; }),
          shades(m, n, [&, random = std::minstd_rand(m + 3 * n)](uint32_t, uint32_t) mutable {
              if (content == Content::none) return 0u;
              return content == Content::white ? 0xFFFFFFu : static_cast<uint32_t>(random()) % 0xFFFFFFu + 1;
          })
    {
    }
    bool are_many() const { return std::max(origins.size(), directions.size()) > kMany; }
};

// Where a pixel's ray meets the unit sphere.
struct Chord {
    double half_squared;
    twin::Vec3 front, back;
};

Chord chord_of(const View& view, int32_t x, int32_t y)
{
    const Image& image = view.image;
    const double step = 2 * std::tan(twin::kPi * image.fov_turns32 / kTurn) / std::max(image.width_px, image.height_px);
    const double right = (x + 0.5 - image.width_px / 2.0 - image.shift_x_q8 / 256.0) * step;
    const double up = (image.height_px / 2.0 + image.shift_y_q8 / 256.0 - y - 0.5) * step;
    const twin::Vec3 eye = twin::decoded(view.pose.eye);
    const twin::Vec3 d = twin::normalised(twin::decoded(view.pose.forward) + right * twin::decoded(view.pose.right) +
                                          up * twin::decoded(view.pose.up));
    const double middle = -twin::dot(eye, d);
    const twin::Vec3 nearest = eye + middle * d;
    const double squared = 1 - twin::dot(nearest, nearest), half = std::sqrt(std::max(0.0, squared));
    const bool is_ahead = middle > 0;
    return {is_ahead ? squared : -1, twin::normalised(nearest - half * d), twin::normalised(nearest + half * d)};
}

// How much farther than the nearest point the one of this number lies, in spacings.
double too_far(const Points& all, const twin::Vec3& hit, uint32_t number)
{
    const auto distance = [&](const twin::Vec3& p) { return twin::length(p - hit); };
    if (number == 0 || number > all.size()) return 2 / twin::spacing(static_cast<uint32_t>(all.size()));
    double least = 2;
    for (const twin::Vec3& p : all) least = std::min(least, distance(p));
    return (distance(all[number - 1]) - least) / twin::spacing(static_cast<uint32_t>(all.size()));
}

// Levels that the shades show for these taps, with what misses over nothing.
std::array<double, 3> shade(const Texels& shades, const twin::Weights& origins, const twin::Weights& directions)
{
    std::array<double, 3> sum{};
    double covered = 0;
    for (const auto& [i, wi] : origins) {
        for (const auto& [j, wj] : directions) {
            const uint8_t* texel = shades.at(i, j);
            if (texel[0] == 0 && texel[1] == 0 && texel[2] == 0) continue;
            for (size_t c = 0; c < 3; ++c) sum[c] += wi * wj * texel[c];
            covered += wi * wj;
        }
    }
    const double under[3] = {static_cast<double>(kNothing.r), static_cast<double>(kNothing.g),
                             static_cast<double>(kNothing.b)};
    for (size_t c = 0; c < 3; ++c) sum[c] += (1 - covered) * under[c];
    return sum;
}

double off(const Rgb8& drawn, const std::array<double, 3>& exact)
{
    return std::max({std::abs(drawn.r - exact[0]), std::abs(drawn.g - exact[1]), std::abs(drawn.b - exact[2])});
}

using Row = std::vector<uint8_t>;

Rgb8 pixel(const Row& row, int32_t x)
{
    return PixelRgb888::load(&row[static_cast<size_t>(3 * x)]);
}

// A row of the picture; nothing where spans do not draw the field.
template <class Reconstruction>
Row row_of(const Field& field, const Camera& camera, const View& view, int32_t y, bool by_spans)
{
    const int32_t width = view.image.width_px;
    Row row(static_cast<size_t>(3 * width));
    const Stripe stripe = {row.data(), 0, y, width, 1, static_cast<uint32_t>(3 * width)};
    const OverColour over = {kNothing};
    RenderError error = RenderError::none;
    if constexpr (std::is_same_v<Reconstruction, Paper<kPaperPoints>>)
        error = render<Reconstruction, TexelRgb888, PixelRgb888>(field, camera, over, stripe);
    else if (by_spans)
        error = render_spans<Reconstruction, TexelRgb888, PixelRgb888>(field, camera, over, stripe, kSpan);
    else
        error = render<Reconstruction, TexelRgb888, PixelRgb888>(field, camera, over, stripe);
    if (error != RenderError::none) throw std::logic_error("a field of the lab cannot be drawn");
    return row;
}

// The worst of all pixels that were looked at, by name; also of those alone that are not next to the rim.
class Worst
{
public:
    void add(const char* name, const Chord& chord, double error)
    {
        put(all_, name, error);
        if (chord.half_squared > kInside) put(inside_, name, error);
    }
    Json json() const { return {{"all", rounded(all_)}, {"inside", rounded(inside_)}}; }

private:
    static void put(Json& json, const char* name, double error) { json[name] = std::max(error, json.value(name, 0.0)); }
    static Json rounded(Json json)
    {
        for (auto& [name, value] : json.items()) value = std::round(value.get<double>() * 10000) / 10000;
        return json;
    }

    Json all_ = Json::object(), inside_ = Json::object();
};

struct Result {
    uint32_t pixels = 0, wrong_rim = 0, left_out = 0;  // the last: at the rim, by spans
    Worst exact, spans;
    bool has_spans = true;
};

// The places of a row that are looked at: both ends and some between.
std::vector<int32_t> looked_at(const std::vector<int32_t>& covered, int32_t count)
{
    std::vector<int32_t> result;
    for (int32_t k = 0; k < count && !covered.empty(); ++k)
        result.push_back(covered[(covered.size() - 1) * static_cast<size_t>(k) / static_cast<size_t>(count - 1)]);
    return result;
}

struct Scanline {
    const View& view;
    const Camera& camera;
    int32_t y;
    std::vector<int32_t> places;
};

// Modes whose pixels show a point.
template <class Reconstruction>
void judge_points(const Lattices& l, const Scanline& line, bool by_spans, const char* name, Worst& worst)
{
    const Row front = row_of<Reconstruction>(l.by_origin.field, line.camera, line.view, line.y, by_spans);
    const Row back = row_of<Reconstruction>(l.by_direction.field, line.camera, line.view, line.y, by_spans);
    for (const int32_t x : line.places) {
        const Chord chord = chord_of(line.view, x, line.y);
        worst.add(name, chord,
                  std::max(too_far(l.origins, chord.front, number_of(pixel(front, x))),
                           too_far(l.directions, chord.back, number_of(pixel(back, x)))));
    }
}

// Modes whose pixels are sums.
template <class Reconstruction, class Weigh>
void judge_shades(const Lattices& l, const Scanline& line, bool by_spans, const char* name, const Weigh& weigh,
                  Worst& worst)
{
    const Row row = row_of<Reconstruction>(l.shades.field, line.camera, line.view, line.y, by_spans);
    for (const int32_t x : line.places) {
        const Chord chord = chord_of(line.view, x, line.y);
        worst.add(name, chord,
                  off(pixel(row, x), shade(l.shades, weigh(l.origins, chord.front), weigh(l.directions, chord.back))));
    }
}

// The line without the places that spans leave to the background.
Scanline shown_by_spans(const Lattices& l, const Scanline& line)
{
    const Row row = row_of<Nearest>(l.by_origin.field, line.camera, line.view, line.y, true);
    Scanline shown = {line.view, line.camera, line.y, {}};
    for (const int32_t x : line.places)
        if (number_of(pixel(row, x)) != number_of(kNothing)) shown.places.push_back(x);
    return shown;
}

void judge_line(const Lattices& l, const Scanline& whole, Result& result)
{
    const auto linear = [](const Points& all, const twin::Vec3& q) { return twin::linear_weights(all, q); };
    const auto paper = [](const Points& all, const twin::Vec3& q) { return twin::paper_weights(all, q, kPaperPoints); };
    for (const bool by_spans : {false, true}) {
        if (by_spans && !fits_spans(l.shades.field)) {
            result.has_spans = false;
            continue;
        }
        Worst& worst = by_spans ? result.spans : result.exact;
        const Scanline line = by_spans ? shown_by_spans(l, whole) : whole;
        result.left_out += static_cast<uint32_t>(whole.places.size() - line.places.size());
        judge_points<Nearest>(l, line, by_spans, "nearest_spacings", worst);
        judge_shades<Linear>(l, line, by_spans, "linear_levels", linear, worst);
        if (!by_spans) judge_shades<Paper<kPaperPoints>>(l, line, false, "paper_levels", paper, worst);
    }
}

using detail::Extent;

// The rows in which the middle column shows the sphere; all where it shows none.
Extent disc_of(const View& view)
{
    const int32_t height = view.image.height_px;
    Extent disc = {height, 0};
    for (int32_t y = 0; y < height; ++y) {
        if (chord_of(view, view.image.width_px / 2, y).half_squared < kRim) continue;
        disc = {std::min(disc.begin, y), y + 1};
    }
    return disc.begin < disc.end ? disc : Extent{0, height};
}

void judge_view(const Lattices& l, const View& view, Result& result)
{
    Camera camera;
    if (const CameraError error = make_camera(view.pose, view.image, camera); error != CameraError::none)
        throw std::logic_error(std::string("a view of the lab: ") + describe(error));
    const int32_t rows = l.are_many() ? 4 : kRowsAView;
    const Extent disc = disc_of(view);
    const int32_t step = std::max(1, (disc.end - disc.begin) / rows);
    for (int32_t y = disc.begin + step / 2; y < disc.end; y += step) {
        tools::leave_if_interrupted();
        const Row drawn = row_of<Nearest>(l.by_origin.field, camera, view, y, false);
        std::vector<int32_t> covered;
        for (int32_t x = 0; x < view.image.width_px; ++x) {
            const double beyond = chord_of(view, x, y).half_squared - kRim;
            const bool is_drawn = number_of(pixel(drawn, x)) != number_of(kNothing);
            if (is_drawn) covered.push_back(x);
            result.wrong_rim += is_drawn != (beyond > 0) && std::abs(beyond) > kRimTolerance ? 1u : 0u;
        }
        const Scanline line = {view, camera, y, looked_at(covered, l.are_many() ? kPixelsOfMany / 4 : kPixelsARow)};
        result.pixels += static_cast<uint32_t>(line.places.size());
        if (!line.places.empty()) judge_line(l, line, result);
    }
}

struct Case {
    const char* name;
    std::vector<View> views;
    std::vector<std::array<uint32_t, 2>> lattices;
    Content content = Content::random;
};

std::vector<std::array<uint32_t, 2>> from_to(uint32_t first, uint32_t last, uint32_t step)
{
    std::vector<std::array<uint32_t, 2>> sizes;
    for (uint32_t n = first; n <= last; n += step) sizes.push_back({n, last + first - n});
    return sizes;
}

std::vector<Case> cases()
{
    const std::vector<std::array<uint32_t, 2>> usual = {{300, 777}};
    const auto pole = [](double distance) { return View{from(61, 90, distance), kUsual}; };
    const auto south = [](double distance) { return View{from(10, -90, distance), kUsual}; };
    return {
        {"eye at 3 radii", around(3), usual},
        {"eye at 1.000001 radii", around(1.000001, {96, 96, 90 * kDegree}), usual},
        {"eye at 1.01 radii", around(1.01, {96, 96, 90 * kDegree}), usual},
        {"eye at 2046 radii", around(2046, {4096, 4096, kMinFovTurns32}), usual},
        {"field of view of 1°", around(3, {96, 96, kMinFovTurns32}), usual},
        {"field of view of 120°", around(1.2, {200, 120, kMaxFovTurns32}), usual},
        {"image of 1 × 1", around(3, {1, 1, 40 * kDegree}), usual},
        {"image of 8192 × 1", around(3, {8192, 1, 40 * kDegree}), usual},
        {"image of 1 × 8192", around(3, {1, 8192, 40 * kDegree}), usual},
        {"down the poles", {pole(3), south(3), pole(1.1), south(1.1)}, usual},
        {"along the seam", {{from(0, 0, 3), kUsual}, {from(180, 0, 3), kUsual}, {from(0, 1, 1.1), kUsual}}, usual},
        {"rolled", {{rolled(from(40, 30, 2), 33.0), kUsual}, {rolled(from(200, -60, 3), 117.0), kUsual}}, usual},
        {"stereo pair, shifted lens", stereo(), usual},
        {"1 to 7 points", around(3), from_to(1, 7, 1)},
        {"8 to 63 points", around(3), from_to(8, 63, 5)},
        {"64 to 300 points", around(3), from_to(64, 300, 59)},
        {"65,536 points", {around(3)[2], pole(2)}, {{65536, 64}, {64, 65536}}},
        {"2^20 points", {around(3)[2], pole(2)}, {{1u << 20, 1}, {1, 1u << 20}}},
        {"all texels 0", around(3), usual, Content::none},
        {"all texels 255", around(3), usual, Content::white},
    };
}

Json judged(const Case& of)
{
    Result result;
    for (const auto& [m, n] : of.lattices) {
        const Lattices lattices(m, n, of.content);
        for (const View& view : of.views) judge_view(lattices, view, result);
    }
    return {{"case", of.name},
            {"pixels", result.pixels},
            {"wrong_rim", result.wrong_rim},
            {"left_out", result.left_out},
            {"exact", result.exact.json()},
            {"spans", result.has_spans ? result.spans.json() : Json()}};
}

}  // namespace

void add_extremes(CLI::App& lab)
{
    lab.add_subcommand("extremes", "Compare chord pictures with double precision at the ends of views and lattices")
        ->callback([] {
            Json rows = Json::array();
            for (const Case& of : cases()) rows.push_back(judged(of));
            print(rows);
        });
}

}  // namespace lumi::lab
