// SPDX-License-Identifier: MIT
#include "lumi/baker/surface.h"

#include <chrono>

#include "fit/gloss/gloss_fit.h"
#include "fit/gloss/lines.h"
#include "fit/light_fit.h"
#include "fit/see_through_light.h"
#include "fit/texel_density.h"
#include "pack/shadow_patches.h"
#include "pack/solution.h"
#include "scene/light_states.h"
#include "store/bake_identity.h"
#include "store/bake_stages.h"
#include "store/checkpoint.h"
#include "store/posix_file.h"
#include "surface/surface_file_store.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

// Keeps the basis and, now and then, the state.
class Keeper
{
public:
    Keeper(const std::filesystem::path& path, const BakeIdentity& identity, Earlier earlier)
        : checkpoint_(path, identity, earlier), store_(checkpoint_.blocks())
    {
    }

    SurfaceFileStore& store() { return store_; }
    Checkpoint& checkpoint() { return checkpoint_; }

    void keep(const FitState& state)
    {
        if (state.has_pilot && state.batches != kept_) {
            store_.write_state(encode(state));
            kept_ = state.batches;
        }
    }
    // Returns whether this is the first time: the pilot is kept from then on.
    bool keep_now_and_then(const FitState& state)
    {
        const Clock::time_point start = Clock::now();
        const bool is_first = kept_ == UINT32_MAX;
        if (is_first || start >= next_) {
            keep(state);
            const Clock::time_point end = Clock::now();
            next_ = end + std::max<Clock::duration>(kShortest, kBetween * (end - start));
        }
        return is_first;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds kShortest{2};  // a bake that is killed every few seconds still gets on
    static constexpr int kBetween = 30;                  // times as long as writing takes

    Checkpoint checkpoint_;
    SurfaceFileStore store_;
    Clock::time_point next_ = Clock::now() + kShortest;
    uint32_t kept_ = UINT32_MAX;  // batches
};

// The light of a scene, or of one of its states. Borrows all.
struct Lit {
    const Scene& scene;
    Keeper* keeper;  // may be null
    std::string name = {};
    float scale = 1;
    Rgb usual = grey(1);
    bool is_tint = false;
};

// All light together counts, and each state that may be seen alone.
std::vector<DensityLight> density_lights(const SceneData& scene, const std::vector<Lit>& lights)
{
    std::vector<DensityLight> result = {{scene}};
    for (const Lit& light : lights)
        if (lights.size() > 1 && !light.is_tint) result.push_back({light.scene.data(), times_seen(light.scale)});
    return result;
}

FitBasis basis_of(const SceneData& scene, const std::vector<Lit>& lights, const BuiltMesh& built,
                  const SurfaceSettings& settings, BakeStages& stages, const ProgressCallback& progress)
{
    JobSeries jobs(as_stage(Stage::mesh, progress));
    FitBasis basis = {built.mesh,
                      texel_densities(density_lights(scene, lights), built.mesh, settings, jobs.next()),
                      built.loss,
                      scene.tone,
                      {scene.centre, scene.radius},
                      {},
                      part_shadows(scene, built.mesh, settings, jobs.next()),
                      ground_shadow(scene, built.mesh, settings, jobs.next())};
    const FitShape shape(basis.mesh, basis.densities);
    basis.see_through = see_through_light(scene, shape, settings, jobs.next());
    basis.gloss = gloss_of(scene, shape, settings, stages, jobs.next());
    return basis;
}

// Returns the mesh of the plan, or else makes that of its settings.
std::shared_ptr<const BuiltMesh> mesh_of(const Scene& scene, const SurfacePlan& plan,
                                         const std::filesystem::path& output, const ProgressCallback& progress)
{
    constexpr SurfaceLimits kByHand = {UINT32_MAX, std::nullopt, false, false, false};
    if (plan.mesh) return plan.mesh;
    const SurfacePlan made = plan_surface(scene, plan.settings, kByHand, progress, output);
    if (!made.mesh) throw BakeError(made.against);
    return made.mesh;
}

// The keeper of the first light may have it.
FitBasis basis_for(const Scene& scene, const std::vector<Lit>& lights, const SurfacePlan& plan,
                   const std::filesystem::path& output, const ProgressCallback& progress)
{
    Keeper* const keeper = lights[0].keeper;
    if (std::optional<FitBasis> kept = keeper != nullptr ? keeper->store().read_basis() : std::nullopt)
        return std::move(*kept);
    const std::shared_ptr<const BuiltMesh> built = mesh_of(scene, plan, output, progress);
    BakeStages stages(output.empty() ? output : stages_of(output), scene.fingerprint(), plan.settings);
    FitBasis basis = basis_of(scene.data(), lights, *built, plan.settings, stages, progress);
    if (keeper != nullptr) keeper->store().write_basis(basis);
    forget_gloss_lines(stages);
    return basis;
}

constexpr double kNearlyAll = 0.9;  // of the texels that are allowed: what is left is not worth a word

// The name of what a state keeps: the output's own for the first.
std::filesystem::path output_of_state(const std::filesystem::path& output, size_t state)
{
    if (state == 0 || output.empty()) return output;
    return output.string() + ".state" + std::to_string(state);
}

// Traces one of them.
class LitTrace
{
public:
    LitTrace(const Lit& lit, const FitShape& shape, const EncodedTone& tone, const SurfaceSettings& settings,
             const Shard& shard, const std::filesystem::path& output)
        : lit_(lit),
          stages_(output.empty() ? output : stages_of(output), lit.scene.fingerprint(), settings),
          state_(shape, tone),
          fit_(lit.scene.data(), shape, settings, shard)
    {
        read_earlier();
    }

    TracedLight traced() { return {state_, stages_, lit_.name, lit_.scale, lit_.usual, lit_.is_tint}; }
    const FitState& state() const { return state_; }
    uint64_t earlier() const { return fit_.work_in(state_); }
    uint64_t rays_left() const { return fit_.rays_left(state_); }
    uint64_t staged_left() const { return fit_.staged_left(state_) + solution_work(state_); }

    template <class Plan>
    void trace(Job& job, const Plan& plan)
    {
        Keeper* const keeper = lit_.keeper;
        try {
            const bool had_pilot = state_.has_pilot;
            fit_.trace(state_, stages_, job, [&] {
                if (!had_pilot && state_.batches == 0) plan();
                if (keeper != nullptr && keeper->keep_now_and_then(state_)) LightFit::forget_pilot(stages_);
            });
            if (keeper != nullptr) keeper->keep(state_);
        } catch (const Cancelled&) {
            if (keeper != nullptr) keeper->keep(state_);
            throw;
        }
    }

private:
    // Reads what the checkpoint has.
    void read_earlier()
    {
        std::vector<uint8_t> earlier;
        if (lit_.keeper != nullptr && lit_.keeper->store().read_state(earlier) && !add_encoded(earlier, state_))
            throw BakeError("the checkpoint is damaged; discard it with --restart");
    }

    const Lit lit_;
    BakeStages stages_;
    FitState state_;
    LightFit fit_;
};

// From the mesh to the file. Borrows all but the basis.
class SurfaceFit
{
public:
    // Without keepers `output` is empty.
    SurfaceFit(const std::vector<Lit>& lights, const SurfaceSettings& settings, const Shard& shard, FitBasis basis,
               const std::filesystem::path& output, const ProgressCallback& progress)
        : settings_(settings),
          loss_(basis.loss),
          sphere_(basis.sphere),
          shadows_(std::move(basis.shadows)),
          ground_(std::move(basis.ground)),
          shape_(std::move(basis.mesh), basis.densities, std::move(basis.see_through), std::move(basis.gloss)),
          tone_(basis.tone),
          traces_(traces_of(lights, shard, output)),
          earlier_(sum_of(&LitTrace::earlier)),
          job_(earlier_ + sum_of(&LitTrace::rays_left) + sum_of(&LitTrace::staged_left), settings.threads, progress,
               earlier_)
    {
        plan();
    }

    void trace()
    {
        for (const std::unique_ptr<LitTrace>& one : traces_)
            one->trace(
                job_, [this] { plan(); });
    }

    SurfaceBake field()
    {
        std::vector<TracedLight> lights;
        for (const std::unique_ptr<LitTrace>& one : traces_) lights.push_back(one->traced());
        FieldParts parts = solved(lights, sphere_, job_, ground_levels(ground_, shape_.mesh));
        job_.finish();
        parts.is_draft = settings_.draft;
        SurfaceBake bake;
        FitShape shape = shape_;
        bake.notes = shadows_.notes;
        for (std::string& note : add_ground(ground_, shape, parts)) bake.notes.push_back(std::move(note));
        for (std::string& note : add_shadows(shadows_.shadows, shape, parts)) bake.notes.push_back(std::move(note));
        bake.file = surface_file(shape, parts);
        bake.vertices = static_cast<uint32_t>(shape_.mesh.positions.size());
        for (const ViewCode& view : parts.views) bake.viewed_vertices += view.is_there() ? 1u : 0u;
        bake.triangles = triangle_count(shape_.mesh);
        bake.texels = shape_.layout.texels;
        const uint32_t allowed = layout_of(shape_.mesh, settings_.texels_per_radius).texels;
        bake.suffices = bake.texels < kNearlyAll * allowed;
        bake.loss = loss_;
        for (const std::unique_ptr<LitTrace>& one : traces_) bake.paths += one->state().paths;
        return bake;
    }

private:
    using Traces = std::vector<std::unique_ptr<LitTrace>>;

    Traces traces_of(const std::vector<Lit>& lights, const Shard& shard, const std::filesystem::path& output) const
    {
        Traces traces;
        for (size_t k = 0; k < lights.size(); ++k)
            traces.push_back(
                std::make_unique<LitTrace>(lights[k], shape_, tone_, settings_, shard, output_of_state(output, k)));
        return traces;
    }

    uint64_t sum_of(uint64_t (LitTrace::*number)() const) const
    {
        uint64_t sum = 0;
        for (const std::unique_ptr<LitTrace>& one : traces_) sum += ((*one).*number)();
        return sum;
    }

    void plan() { job_.plan(sum_of(&LitTrace::rays_left), sum_of(&LitTrace::staged_left)); }

    const SurfaceSettings& settings_;
    const MeshLoss loss_;
    const FieldSphere sphere_;
    const PartShadows shadows_;
    const GroundShadow ground_;
    const FitShape shape_;
    const EncodedTone tone_;
    const Traces traces_;
    const uint64_t earlier_;
    Job job_;
};

void require_possible(const Scene& scene, const SurfaceSettings& settings)
{
    require_partial_coverage(scene.data(), false);
    require_possible_surface(settings);
    if (settings.ground && scene.data().medium)
        throw BakeError("a scene with a volume throws no shadow on a ground; bake it without --ground");
}

BakeIdentity identity(const Scene& scene, const SurfaceSettings& settings, const Shard& shard)
{
    return identity_of(scene, settings, shard, tracing_fingerprint(scene.data()));
}

bool has_all_sums(BlockFile& file)
{
    SurfaceFileStore store(file);
    std::vector<uint8_t> bytes;
    return store.read_basis() && store.read_state(bytes) && is_complete(bytes);
}

}  // namespace

SurfaceBake surface_field(const Scene& scene, const SurfacePlan& plan, const ProgressCallback& progress)
{
    require_possible(scene, plan.settings);
    const std::vector<LitState> states = lit_states(scene.data());
    std::vector<Lit> lights;
    for (const LitState& state : states)
        lights.push_back({state.scene, nullptr, state.name, state.scale, state.usual, state.is_tint});
    if (states.empty()) lights.push_back({scene, nullptr});
    SurfaceFit fit(lights, plan.settings, {}, basis_for(scene, lights, plan, {}, progress), {}, progress);
    fit.trace();
    return fit.field();
}

SurfaceBake bake_surface(const Scene& scene, const SurfacePlan& plan, const std::filesystem::path& output,
                         const ProgressCallback& progress, Earlier earlier)
{
    require_possible(scene, plan.settings);
    const std::vector<LitState> states = lit_states(scene.data());
    std::vector<std::unique_ptr<Keeper>> keepers;
    std::vector<Lit> lights;
    for (size_t k = 0; k < std::max<size_t>(states.size(), 1); ++k) {
        const Scene& lit = states.empty() ? scene : states[k].scene;
        keepers.push_back(std::make_unique<Keeper>(checkpoint_of(output_of_state(output, k)),
                                                   identity(lit, plan.settings, {}), earlier));
        lights.push_back({lit, keepers.back().get()});
        if (states.empty()) continue;
        lights.back().name = states[k].name;
        lights.back().scale = states[k].scale;
        lights.back().usual = states[k].usual;
        lights.back().is_tint = states[k].is_tint;
    }
    if (earlier == Earlier::discard) discard_stages(output);
    FitBasis basis = basis_for(scene, lights, plan, output, progress);
    SurfaceFit fit(lights, plan.settings, {}, std::move(basis), output, progress);
    fit.trace();
    SurfaceBake bake = fit.field();
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    for (const std::unique_ptr<Keeper>& keeper : keepers) keeper->checkpoint().remove();
    // An earlier bake may have had more states.
    for (size_t k = keepers.size(); k < detail::format::kMaxStates; ++k) discard_checkpoint(output_of_state(output, k));
    discard_stages(output);
    return bake;
}

void bake_surface_shard(const Scene& scene, const SurfacePlan& plan, const Shard& shard,
                        const std::filesystem::path& output, const ProgressCallback& progress, Earlier earlier)
{
    require_possible(scene, plan.settings);
    if (!scene.light_states().empty())
        throw BakeError("a field with light states is baked whole; leave out --shard, or the states");
    const BakeIdentity id = identity(scene, plan.settings, shard);
    if (earlier == Earlier::resume && is_finished_shard(output, id, has_all_sums)) return;
    Keeper keeper(checkpoint_of(output), id, earlier);
    if (earlier == Earlier::discard) discard_stages(output);
    const std::vector<Lit> lights = {{scene, &keeper}};
    FitBasis basis = basis_for(scene, lights, plan, output, progress);
    SurfaceFit(lights, plan.settings, shard, std::move(basis), output, progress).trace();
    keeper.checkpoint().rename_to(output);
    discard_stages(output);
}

std::filesystem::path kept_stages(const std::filesystem::path& output)
{
    std::error_code ignored;
    std::filesystem::path file = stages_of(output);
    return !output.empty() && std::filesystem::exists(file, ignored) ? file : std::filesystem::path();
}

void discard_stages(const std::filesystem::path& output)
{
    std::error_code ignored;
    for (size_t k = 0; k < detail::format::kMaxStates; ++k)
        std::filesystem::remove(kept_stages(output_of_state(output, k)), ignored);
}

}  // namespace lumi::baker
