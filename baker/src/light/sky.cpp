// SPDX-License-Identifier: MIT
#include "light/sky.h"

#include "math/warp.h"

namespace lumi::baker
{

namespace
{

// The mean of the bilinear function over a pixel weighs the pixel 6/8 and its neighbours 1/8 along either axis: no
// pixel of positive radiance is ever left out.
constexpr float kTent[3] = {0.125f, 0.75f, 0.125f};

int wrapped(int x, int width)
{
    return x < 0 ? x + width : x >= width ? x - width : x;
}

double brightness_of(const RadiancePicture& picture, int x, int y)
{
    double sum = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const Rgb& p = picture.at(wrapped(x + dx, picture.width), std::clamp(y + dy, 0, picture.height - 1));
            sum += static_cast<double>(max_component(p) * kTent[dx + 1] * kTent[dy + 1]);
        }
    }
    return sum;
}

double solid_angle(int y, int width, int height)
{
    const double step = static_cast<double>(kPi) / height;
    return (std::cos(step * y) - std::cos(step * (y + 1))) * 2 * static_cast<double>(kPi) / width;
}

}  // namespace

SkyPicture::SkyPicture(std::shared_ptr<const RadiancePicture> picture, float turns, float scale)
    : picture_(std::move(picture)), turns_(turns), scale_(scale)
{
    const int width = picture_->width;
    std::vector<double> brightness;
    brightness.reserve(picture_->pixels.size());
    double sum = 0;
    for (int y = 0; y < picture_->height; ++y) {
        for (int x = 0; x < width; ++x) {
            brightness.push_back(brightness_of(*picture_, x, y));
            sum += brightness.back() * solid_angle(y, width, picture_->height);
        }
    }
    brightness_sum_ = static_cast<float>(sum) * scale;
    const double mean = sum / (4 * static_cast<double>(kPi));
    std::vector<double> rows;
    auto own = brightness.begin();
    for (int y = 0; y < picture_->height; ++y) {
        std::vector<double> weights;
        for (int x = 0; x < width; ++x)
            weights.push_back(std::max(*own++ - mean, 0.0) * solid_angle(y, width, picture_->height));
        columns_.emplace_back(weights);
        rows.push_back(columns_.back().total());
    }
    rows_ = Distribution(rows);
}

Vec2 SkyPicture::place_of(const Vec3& d) const
{
    const float azimuth = std::atan2(d.y, d.x) / (2 * kPi) - turns_;
    const float right = 0.5f - azimuth;
    const float down = std::acos(std::clamp(d.z, -1.0f, 1.0f)) / kPi;
    return {(right - std::floor(right)) * static_cast<float>(picture_->width),
            down * static_cast<float>(picture_->height)};
}

Rgb SkyPicture::radiance(const Vec2& place) const
{
    const float x = place.x - 0.5f, y = place.y - 0.5f;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const auto row = [&](int k) {
        const int line = std::clamp(k, 0, picture_->height - 1);
        return picture_->at(wrapped(x0, picture_->width), line) * (1 - fx) +
               picture_->at(wrapped(x0 + 1, picture_->width), line) * fx;
    };
    return (row(y0) * (1 - fy) + row(y0 + 1) * fy) * scale_;
}

float SkyPicture::pdf(size_t x, size_t y, float sine) const
{
    if (rows_.empty() || columns_[y].empty()) return 0;
    // Uniform in angle within a pixel: the density over solid angle falls off with the sine.
    const float cell = 2 * kPi * kPi * std::max(sine, 1e-6f) / static_cast<float>(picture_->width * picture_->height);
    return rows_.probability(y) * columns_[y].probability(x) / cell;
}

SkyLight SkyPicture::at(const Vec3& direction) const
{
    const Vec2 place = place_of(direction);
    const int x = std::min(static_cast<int>(place.x), picture_->width - 1);
    const int y = std::min(static_cast<int>(place.y), picture_->height - 1);
    const float sine = std::sqrt(direction.x * direction.x + direction.y * direction.y);
    return {radiance(place), pdf(static_cast<size_t>(x), static_cast<size_t>(y), sine)};
}

LightSample SkyPicture::sample(const Vec2& u) const
{
    if (rows_.empty()) return {};
    const Distribution::Draw row = rows_.draw(u.y);
    const Distribution::Draw column = columns_[row.index].draw(u.x);
    const Vec2 place = {static_cast<float>(column.index) + column.rest, static_cast<float>(row.index) + row.rest};
    const float angle = place.y / static_cast<float>(picture_->height) * kPi;
    const float azimuth = (0.5f - place.x / static_cast<float>(picture_->width) + turns_) * 2 * kPi;
    const float sine = std::sin(angle);
    const Vec3 direction = {sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(angle)};
    return {direction, std::numeric_limits<float>::infinity(), radiance(place), pdf(column.index, row.index, sine)};
}

void SkyPicture::add_to(Digest& digest) const
{
    digest.add(picture_->width);
    digest.add(picture_->height);
    digest.add(picture_->pixels);
    digest.add(turns_);
    digest.add(scale_);
}

namespace
{

Rgb to_rgb(const std::array<float, 3>& c)
{
    return {c[0], c[1], c[2]};
}

// x in [0,1] with density proportional to a(1-x) + bx; a + b > 0.
float sample_linear(float a, float b, float u)
{
    const float root = std::sqrt((1 - u) * a * a + u * b * b);
    return std::min(u * (a + b) / (a + root), 1.0f);
}

std::optional<SkyPicture> picture_of(const Environment& environment)
{
    if (!environment.picture) return std::nullopt;
    return SkyPicture(environment.picture, environment.rotation_degrees / 360, environment.scale);
}

}  // namespace

Sky::Sky(const Environment& environment)
    : picture_(picture_of(environment)),
      zenith_(to_rgb(environment.zenith) * environment.scale),
      horizon_(to_rgb(environment.horizon) * environment.scale),
      nadir_(to_rgb(environment.nadir) * environment.scale),
      top_(max_component(zenith_)),
      middle_(max_component(horizon_)),
      bottom_(max_component(nadir_)),
      upper_mass_(0.5f * (top_ + middle_)),
      lower_mass_(0.5f * (bottom_ + middle_))
{
}

float Sky::brightness(float height) const
{
    const float pole = height > 0 ? top_ : bottom_;
    return middle_ * (1 - std::abs(height)) + pole * std::abs(height);
}

SkyLight Sky::at(const Vec3& direction) const
{
    if (picture_) return picture_->at(direction);
    const float z = std::clamp(direction.z, -1.0f, 1.0f);
    const Rgb& pole = z > 0 ? zenith_ : nadir_;
    return {horizon_ * (1 - std::abs(z)) + pole * std::abs(z), brightness(z) / (2 * kPi * (upper_mass_ + lower_mass_))};
}

float Sky::power() const
{
    // Radiance over all directions, through the unit sphere's disc.
    return kPi * (picture_ ? picture_->brightness_sum() : 2 * kPi * (upper_mass_ + lower_mass_));
}

LightSample Sky::sample(const Vec3&, float u_select, const Vec2& u) const
{
    if (picture_) return picture_->sample(u);
    const bool upper = u_select * (upper_mass_ + lower_mass_) < upper_mass_;
    const float height = sample_linear(middle_, upper ? top_ : bottom_, u.x);
    const Vec3 direction = direction_at(upper ? height : -height, u.y);
    const SkyLight light = at(direction);
    return {direction, std::numeric_limits<float>::infinity(), light.radiance, light.pdf};
}

void Sky::add_to(Digest& digest) const
{
    for (const Rgb& colour : {zenith_, horizon_, nadir_}) digest.add(colour);
    digest.add(picture_.has_value());
    if (picture_) picture_->add_to(digest);
}

}  // namespace lumi::baker
