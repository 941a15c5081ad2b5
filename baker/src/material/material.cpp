// SPDX-License-Identifier: MIT
#include "material/material.h"

#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "material/lobes.h"

namespace lumi::baker
{
namespace
{

constexpr size_t kRoughnessSteps = 64;

constexpr size_t bytes_of_parameters()
{
    size_t bytes = 0;
    for (const MaterialParameter& parameter : kMaterialParameters)
        bytes += parameter.member.index() == 0 ? sizeof(Rgb) : sizeof(float);
    return bytes;
}
static_assert(bytes_of_parameters() == sizeof(MaterialNumbers), "a material's number has no row among the parameters");

// A value that is no number becomes the low end.
float clamped(float v, float low, float high)
{
    return v >= low ? std::min(v, high) : low;
}
Rgb clamped(const Rgb& c, float low, float high)
{
    return {clamped(c.r, low, high), clamped(c.g, low, high), clamped(c.b, low, high)};
}

float clamped_alpha(float alpha)
{
    return clamped(alpha, kMinAlpha, 1);
}

float key_of(float number)
{
    return number;
}
float key_of(const Isotropic& spread)
{
    return spread.alpha;
}
std::pair<float, float> key_of(const Anisotropic& spread)
{
    return {spread.alpha_x, spread.alpha_y};
}

// The table of these arguments: one that a material has already, or a new one. Materials may be finished by several
// threads, which wait for each other here.
template <class Table, class... Arguments>
std::shared_ptr<const Table> shared_table(const Arguments&... arguments)
{
    using Key = std::tuple<decltype(key_of(arguments))...>;
    static std::mutex mutex;  // guards what follows
    static std::map<Key, std::weak_ptr<const Table>> known;
    const std::lock_guard<std::mutex> lock(mutex);
    const Key key(key_of(arguments)...);
    const auto found = known.find(key);
    std::shared_ptr<const Table> table = found == known.end() ? nullptr : found->second.lock();
    if (table) return table;
    for (auto old = known.begin(); old != known.end();) old = old->second.expired() ? known.erase(old) : std::next(old);
    table = std::make_shared<const Table>(arguments...);
    known[key] = table;
    return table;
}

// One table for the material's alpha, or with a texture one for each step of roughness up to it.
template <class Table, class Make>
std::vector<std::shared_ptr<const Table>> tables(bool textured, float alpha, const Make& make)
{
    std::vector<std::shared_ptr<const Table>> result;
    for (size_t k = textured ? 0 : kRoughnessSteps; k <= kRoughnessSteps; ++k) {
        const float share = static_cast<float>(k) / kRoughnessSteps;
        result.push_back(make(clamped_alpha(alpha * share * share)));
    }
    return result;
}

template <class Table>
const Table* nearest_or_none(const std::vector<std::shared_ptr<const Table>>& list, float roughness)
{
    const float last = static_cast<float>(list.size() - 1);
    return list[static_cast<size_t>(std::clamp(roughness, 0.0f, 1.0f) * last + 0.5f)].get();
}

template <class Table>
const Table& nearest(const std::vector<std::shared_ptr<const Table>>& list, float roughness)
{
    return *nearest_or_none(list, roughness);
}

float absorption_of(float transmittance, float distance)
{
    constexpr float kDarkest = 1e-6f;  // black glass is a very dark one
    return -std::log(std::max(transmittance, kDarkest)) / distance;
}

Anisotropic stretched(float alpha, float anisotropy)
{
    const float aspect = aspect_of(anisotropy);
    return {alpha / aspect, std::max(alpha * aspect, kMinAlpha)};
}

// Adds the tables that the material needs, of the spread that `spread_of` makes of a width.
template <class Skins, class Facets, class SpreadOf>
void add_tables(const Material& m, const SpreadOf& spread_of, Skins& skins, Facets& facets)
{
    using Spread = decltype(spread_of(m.alpha));
    const bool textured = m.maps.roughness.used();
    if (m.specular && (m.metalness < 1 || m.maps.metalness.used())) {
        skins = tables<SkinOf<Spread>>(
            textured, m.alpha, [&](float a) { return shared_table<SkinOf<Spread>>(m.index, spread_of(a)); });
    }
    if (m.metalness > 0) {
        facets = tables<FacetTableOf<Spread>>(
            textured, m.alpha, [&](float a) { return shared_table<FacetTableOf<Spread>>(spread_of(a)); });
    }
}

// A smooth step of roughness has none.
std::vector<std::shared_ptr<const GlassTable>> glass_tables(const Material& m)
{
    return tables<GlassTable>(
        m.maps.roughness.used(), m.alpha,
        [&](float a) {
            return a > kMinAlpha || m.alpha == kMinAlpha ? shared_table<GlassTable>(m.index, a) : nullptr;
        });
}

template <class Body>
Bsdf under_fibres(const Body& body, const Material& m, float sheen)
{
    return m.fibres ? Bsdf(Sheened(body, *m.fibres, m.sheen_colour * sheen)) : Bsdf(body);
}

template <class Body>
Bsdf layered(const Body& body, const Material& m, float sheen)
{
    return m.coat_skin ? under_fibres(Coated(body, *m.coat_skin, m.coat), m, sheen) : under_fibres(body, m, sheen);
}

template <class Skins, class Facets>
Bsdf opaque(const Material& m, const PointValues& at, float u, const Skins& skins, const Facets& facets)
{
    if (u < at.metalness) return layered(ConductorOf(at.base, nearest(facets, at.roughness)), m, at.sheen);
    const DiffuseShape shape = m.rough_body ? DiffuseShape(std::sqrt(m.alpha) * at.roughness) : DiffuseShape();
    if (!skins.empty()) return layered(PlasticOf(at.base, nearest(skins, at.roughness), shape), m, at.sheen);
    return layered(Diffuse(at.base, shape), m, at.sheen);
}

}  // namespace

void Material::finish()
{
    const float given_index = index > 1 ? std::min(index, static_cast<float>(kMaxIndex)) : kDefaultIndex;
    for (const MaterialParameter& p : kMaterialParameters) {
        const auto clamp = [&, this](auto member) {
            this->*member = clamped(this->*member, static_cast<float>(p.low), static_cast<float>(p.high));
        };
        std::visit(clamp, p.member);
    }
    transmission = clamped(transmission, 0.0f, 1.0f);
    tint = clamped(tint, 0.0f, 1.0f);
    alpha = glass && alpha < kMinAlpha ? 0 : clamped_alpha(alpha);
    coat_alpha = clamped_alpha(coat_alpha);
    index = glass ? std::max(given_index, static_cast<float>(kMinIndex)) : given_index;
    skins.clear();
    facets.clear();
    brushed_skins.clear();
    brushed_facets.clear();
    frosts.clear();
    coat_skin = nullptr;
    fibres = nullptr;
    if (glass) {
        absorption = {absorption_of(transmittance.r, transmittance_length),
                      absorption_of(transmittance.g, transmittance_length),
                      absorption_of(transmittance.b, transmittance_length)};
        frosts = glass_tables(*this);
        if (!is_mixed_glass()) return;
    }
    if (anisotropy > 0 && !glass) {
        add_tables(
            *this, [this](float a) { return stretched(a, anisotropy); }, brushed_skins, brushed_facets);
    } else {
        add_tables(
            *this, [](float a) { return Isotropic(a); }, skins, facets);
    }
    coat_skin = coat > 0 ? shared_table<Skin>(kDefaultIndex, Isotropic(coat_alpha)) : nullptr;
    fibres = sheen > 0 ? shared_table<SheenTable>(sheen_roughness) : nullptr;
}

Rgb Material::through_pane(const PointValues& at, const Rgb& picture, float cosine) const
{
    const float enters = specular ? 1 - dielectric_reflectance(std::clamp(cosine, 0.0f, 1.0f), index) : 1.0f;
    return tint * picture * (enters * at.transmission * (1 - at.metalness));
}

Rgb Material::absorbed(float distance) const
{
    return {std::exp(-absorption.r * distance), std::exp(-absorption.g * distance), std::exp(-absorption.b * distance)};
}

Rgb Material::body(const PointValues& at, float u) const
{
    return thin && u >= at.metalness ? at.base * (1 - at.transmission) : at.base;
}

Bsdf Material::bsdf(const PointValues& at, float u) const
{
    if (glass && u >= at.metalness && u - at.metalness < (1 - at.metalness) * at.transmission) {
        const GlassTable* frost = nearest_or_none(frosts, at.roughness);
        return frost ? Bsdf(RoughGlass(*frost, at.outside)) : Bsdf(SmoothGlass(at.outside ? index : 1 / index));
    }
    PointValues rest = at;
    rest.base = body(at, u);
    return brushed() ? opaque(*this, rest, u, brushed_skins, brushed_facets) : opaque(*this, rest, u, skins, facets);
}

float alpha_from_phong_exponent(float exponent)
{
    return std::sqrt(2 / (std::max(exponent, 0.0f) + 2));
}

float alpha_from_roughness(float roughness)
{
    return roughness * roughness;
}

float index_from_reflectance(float f0)
{
    return (1 + std::sqrt(f0)) / (1 - std::sqrt(f0));
}

float stated(const MaterialParameter& parameter, float value)
{
    return parameter.stated == Stated::as_roughness ? alpha_from_roughness(value) : value;
}

}  // namespace lumi::baker
