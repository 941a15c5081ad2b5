// SPDX-License-Identifier: MIT
#include "scene/light_states.h"

#include <algorithm>
#include <cmath>

#include "image/radiance_picture.h"
#include "lumi/host/nearest_word.h"
#include "lumi/surface/format.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

constexpr const char* kBase = "base";
constexpr const char* kSky = "sky";

class StateMaker
{
public:
    StateMaker(std::string file, SceneParts& parts) : file_(std::move(file)), parts_(parts)
    {
        parts_.fixture_names.resize(parts_.fixtures.size());
        parts_.states.of_material.resize(parts_.materials.size());
        parts_.states.of_fixture.resize(parts_.fixtures.size());
    }

    void label_all()
    {
        if (!parts_.sky_state.empty()) parts_.states.of_sky = number_of(parts_.sky_state);
        for (size_t k = 0; k < parts_.fixtures.size(); ++k)
            if (parts_.has_labels && !parts_.fixture_names[k].empty())
                parts_.states.of_fixture[k] = number_of(parts_.fixture_names[k]);
        for (size_t k = 0; k < parts_.materials.size(); ++k) {
            const Material& material = parts_.materials[k];
            if (material.state.empty()) continue;
            if (!material.emits())
                fail("the material '" + material.name + "' has the light state '" + material.state +
                     "' and does not shine; give it an emission");
            parts_.states.of_material[k] = number_of(material.state);
        }
    }

    void add(const std::string& name)
    {
        const std::vector<std::string>& names = parts_.states.names;
        if (name == kBase) number_of(name);  // alone it is all light
        if (std::find(names.begin(), names.end(), name) != names.end()) return;
        const std::vector<std::string> choices = lights();
        if (std::find(choices.begin(), choices.end(), name) == choices.end())
            fail("no lamp and no material that shines is named '" + name + "'" + host::meant(name, choices) +
                 "; choose among: " + joined(choices, ", "));
        const uint8_t number = number_of(name);
        if (name == kSky) parts_.states.of_sky = number;
        for (size_t k = 0; k < parts_.fixtures.size(); ++k)
            if (parts_.fixture_names[k] == name) parts_.states.of_fixture[k] = number;
        for (size_t k = 0; k < parts_.materials.size(); ++k)
            if (parts_.materials[k].emits() && parts_.materials[k].name == name) parts_.states.of_material[k] = number;
    }

    void add_tint(const std::string& name)
    {
        const std::vector<size_t> materials = materials_named(name);
        const uint8_t number = number_of(name);
        parts_.states.are_tints = true;
        for (const size_t k : materials) parts_.states.of_material[k] = number;
    }

    void paint(const StateOption& option)
    {
        for (const size_t k : materials_named(option.name)) {
            parts_.materials[k].base = {option.weight[0], option.weight[1], option.weight[2]};
            parts_.materials[k].finish();
        }
    }

    void require_no_state() const
    {
        if (!parts_.states.names.empty()) fail("a field has light states or tints, not both; leave out one kind");
    }

    void require_possible() const
    {
        if (parts_.states.names.empty()) return;
        if (parts_.volume) fail("a scene with a volume has no light states; leave them out");
        if (parts_.tone != ToneCurve::srgb)
            fail("light states are mixed as linear light, without a tone curve; leave out 'tone'");
    }

private:
    [[noreturn]] void fail(const std::string& text) const { throw SceneError(at({file_}, text)); }

    // Its number; a name that is new becomes a state.
    uint8_t number_of(const std::string& name)
    {
        std::vector<std::string>& names = parts_.states.names;
        if (names.empty()) names.emplace_back(kBase);
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) return static_cast<uint8_t>(found - names.begin());
        if (name.size() > detail::format::state::kNameBytes)
            fail("the name of the state '" + name + "' is longer than " +
                 std::to_string(detail::format::state::kNameBytes) + " bytes; shorten it");
        if (names.size() == detail::format::kMaxStates)
            fail("a field has at most " + std::to_string(detail::format::kMaxStates) +
                 " light states, base among them; leave out '" + name + "'");
        names.push_back(name);
        return static_cast<uint8_t>(names.size() - 1);
    }

    std::vector<size_t> materials_named(const std::string& name) const
    {
        std::vector<size_t> found;
        std::vector<std::string> names;
        for (size_t k = 0; k < parts_.materials.size(); ++k) {
            names.push_back(parts_.materials[k].name);
            if (names.back() == name) found.push_back(k);
        }
        if (found.empty())
            fail("no material is named '" + name + "'" + host::meant(name, names) +
                 "; choose among: " + joined(names, ", "));
        return found;
    }

    std::vector<std::string> lights() const
    {
        std::vector<std::string> names = {kSky};
        const auto take = [&](const std::string& name) {
            if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        };
        for (const std::string& name : parts_.fixture_names) take(name);
        for (const Material& material : parts_.materials)
            if (material.emits()) take(material.name);
        return names;
    }

    const std::string file_;
    SceneParts& parts_;
};

// The number of a material or fixture that may have come later.
size_t state_of(const std::vector<uint8_t>& states, size_t k)
{
    return k < states.size() ? states[k] : 0;
}

Environment weighted(Environment sky, const Rgb& weight)
{
    if (weight.r == weight.g && weight.g == weight.b) return exposed(std::move(sky), weight.r);
    const float channels[] = {weight.r, weight.g, weight.b};
    for (std::array<float, 3>* colour : {&sky.zenith, &sky.horizon, &sky.nadir})
        for (size_t c = 0; c < 3; ++c) (*colour)[c] *= channels[c];
    if (sky.picture) {
        auto picture = std::make_shared<RadiancePicture>(*sky.picture);
        for (Rgb& pixel : picture->pixels) pixel = pixel * weight;
        sky.picture = std::move(picture);
    }
    return sky;
}

Fixture weighted(Fixture fixture, const Rgb& weight)
{
    struct Weigh {
        const Rgb& weight;

        void operator()(PointLight& l) const { l.intensity = l.intensity * weight; }
        void operator()(SpotLight& l) const { l.intensity = l.intensity * weight; }
        void operator()(DirectionalLight& l) const { l.irradiance = l.irradiance * weight; }
        void operator()(RectangleLight& l) const { l.radiance = l.radiance * weight; }
        void operator()(SphereLight& l) const { l.radiance = l.radiance * weight; }
    };
    std::visit(Weigh{weight}, fixture);
    return fixture;
}

// A surface that shines is seen at its own radiance. Beyond kMost, a state's other levels would be too coarse.
float scale_of(const SceneData& scene, uint32_t state)
{
    constexpr float kMost = 4, kSteps = 16;
    float most = 1;
    for (size_t k = 0; k < scene.materials.size(); ++k)
        if (state_of(scene.states.of_material, k) == state)
            most = std::max(most, max_component(scene.materials[k].emission));
    return std::ceil(std::min(most, kMost) * kSteps) / kSteps;
}

}  // namespace

void set_light_states(const std::filesystem::path& file, const std::vector<StateOption>& options, SceneParts& parts)
{
    StateMaker maker(file.string(), parts);
    maker.label_all();
    for (const StateOption& option : options) maker.add(option.name);
    maker.require_possible();
}

void set_tints(const std::filesystem::path& file, const LoadOptions& options, SceneParts& parts)
{
    StateMaker maker(file.string(), parts);
    for (const StateOption& option : options.base_colours) maker.paint(option);
    if (options.tints.empty()) return;
    maker.require_no_state();
    for (const std::string& name : options.tints) maker.add_tint(name);
    maker.require_possible();
}

namespace
{

// The scene with other materials, and other light that has its exposure already.
std::unique_ptr<SceneData> changed(const SceneData& scene, std::vector<Material> materials,
                                   std::vector<Fixture> fixtures, const Environment& sky)
{
    SceneParts parts;
    parts.mesh = scene.mesh;
    parts.moving = scene.moving;
    parts.materials = std::move(materials);
    parts.fixtures = std::move(fixtures);
    parts.shared_textures = scene.shared_textures;
    parts.tone = scene.tone;
    parts.sphere = BoundingSphere{{0, 0, 0}, 1};
    parts.exposure = 1;
    LoadOptions options;
    options.up = UpAxis::z;
    options.environment = exposed(sky, scene.choice.exposure);
    auto result = std::make_unique<SceneData>(std::move(parts), options);
    result->centre = scene.centre;
    result->radius = scene.radius;
    result->up = scene.up;
    result->choice = scene.choice;
    result->choice.environment = sky;
    result->views = scene.views;
    return result;
}

// Light between surfaces makes a field a little more than linear in a colour: it is exact for black and for this.
constexpr float kTint = 0.8f;

// All tints are black but that of a number.
std::unique_ptr<SceneData> painted(const SceneData& scene, uint32_t number)
{
    std::vector<Material> materials = scene.materials;
    for (size_t k = 0; k < materials.size(); ++k) {
        const size_t tint = state_of(scene.states.of_material, k);
        if (tint == 0) continue;
        materials[k].base = grey(tint == number ? kTint : 0);
        materials[k].finish();
    }
    return changed(scene, std::move(materials), scene.fixtures, scene.choice.environment);
}

// The base colour that the model gives a tint; of several materials that of the first.
Rgb usual_of(const SceneData& scene, uint32_t number)
{
    for (size_t k = 0; number != 0 && k < scene.materials.size(); ++k)
        if (state_of(scene.states.of_material, k) == number) return scene.materials[k].base;
    return grey(1);
}

}  // namespace

float times_seen(float scale)
{
    constexpr float kGamma = 2.2f;
    return std::pow(scale, 1 / kGamma);
}

std::unique_ptr<SceneData> lit_by(const SceneData& scene, const std::vector<Rgb>& weights)
{
    std::vector<Material> materials = scene.materials;
    for (size_t k = 0; k < materials.size(); ++k)
        materials[k].emission = materials[k].emission * weights[state_of(scene.states.of_material, k)];
    std::vector<Fixture> fixtures;
    for (size_t k = 0; k < scene.fixtures.size(); ++k)
        fixtures.push_back(weighted(scene.fixtures[k], weights[state_of(scene.states.of_fixture, k)]));
    return changed(scene, std::move(materials), std::move(fixtures),
                   weighted(scene.choice.environment, weights[scene.states.of_sky]));
}

std::vector<LitState> lit_states(const SceneData& scene)
{
    constexpr size_t kFewest = detail::format::kMinStates;
    std::vector<LitState> states;
    for (uint32_t k = 0; k < scene.states.names.size(); ++k) {
        const std::string& name = scene.states.names[k];
        if (scene.states.are_tints) {
            states.push_back({name, Scene(painted(scene, k)), k == 0 ? 1 : 1 / kTint, usual_of(scene, k), k != 0});
            continue;
        }
        std::vector<Rgb> weights(scene.states.names.size());
        const float scale = scale_of(scene, k);
        weights[k] = grey(1 / scale);
        states.push_back({name, Scene(lit_by(scene, weights)), scale});
    }
    const auto is_dark = [](const LitState& state) { return state.scene.data().lights.empty(); };
    const auto dark = static_cast<size_t>(std::count_if(states.begin(), states.end(), is_dark));
    if (states.size() - dark >= kFewest)
        states.erase(std::remove_if(states.begin(), states.end(), is_dark), states.end());
    return states;
}

}  // namespace lumi::baker
