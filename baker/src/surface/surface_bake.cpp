// SPDX-License-Identifier: MIT
#include "lumi/baker/surface.h"

#include <chrono>

#include "fit/light_fit.h"
#include "fit/see_through_light.h"
#include "fit/texel_density.h"
#include "pack/shadow_patches.h"
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
    static constexpr int kBetween = 12;                  // times as long as writing takes

    Checkpoint checkpoint_;
    SurfaceFileStore store_;
    Clock::time_point next_ = Clock::now() + kShortest;
    uint32_t kept_ = UINT32_MAX;  // batches
};

FitBasis basis_of(const SceneData& scene, const BuiltMesh& built, const SurfaceSettings& settings,
                  const ProgressCallback& progress)
{
    JobSeries jobs(as_stage(Stage::mesh, progress));
    FitBasis basis = {built.mesh,
                      texel_densities(scene, built.mesh, settings, jobs.next()),
                      built.loss,
                      scene.tone,
                      {scene.centre, scene.radius},
                      {},
                      part_shadows(scene, built.mesh, settings, jobs.next()),
                      ground_shadow(scene, built.mesh, settings, jobs.next())};
    basis.see_through = see_through_light(scene, FitShape(basis.mesh, basis.densities), settings, jobs.next());
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

// A keeper that has the basis saves making it; null: nothing is kept.
FitBasis basis_for(const Scene& scene, const SurfacePlan& plan, const std::filesystem::path& output, Keeper* keeper,
                   const ProgressCallback& progress)
{
    if (std::optional<FitBasis> kept = keeper != nullptr ? keeper->store().read_basis() : std::nullopt)
        return std::move(*kept);
    FitBasis basis = basis_of(scene.data(), *mesh_of(scene, plan, output, progress), plan.settings, progress);
    if (keeper != nullptr) keeper->store().write_basis(basis);
    return basis;
}

constexpr double kNearlyAll = 0.9;  // of the texels that are allowed: what is left is not worth a word

// From the mesh to the file. Borrows all but the basis.
class SurfaceFit
{
public:
    // `keeper` may be null, and then `output` is empty.
    SurfaceFit(const Scene& scene, const SurfaceSettings& settings, const Shard& shard, FitBasis basis,
               const std::filesystem::path& output, Keeper* keeper, const ProgressCallback& progress)
        : settings_(settings),
          keeper_(keeper),
          stages_(output.empty() ? output : stages_of(output), scene.fingerprint(), settings),
          loss_(basis.loss),
          sphere_(basis.sphere),
          shadows_(std::move(basis.shadows)),
          ground_(std::move(basis.ground)),
          shape_(std::move(basis.mesh), basis.densities, std::move(basis.see_through)),
          tone_(basis.tone),
          state_(shape_, tone_),
          fit_(scene.data(), shape_, settings, shard),
          earlier_(earlier_work()),
          job_(earlier_ + fit_.rays_left(state_) + staged_left(), settings.threads, progress, earlier_)
    {
        plan();
    }

    void trace()
    {
        try {
            const bool had_pilot = state_.has_pilot;
            fit_.trace(state_, stages_, job_, [this, had_pilot] {
                if (!had_pilot && state_.batches == 0) plan();
                if (keeper_ != nullptr && keeper_->keep_now_and_then(state_)) LightFit::forget_pilot(stages_);
            });
            if (keeper_ != nullptr) keeper_->keep(state_);
        } catch (const Cancelled&) {
            if (keeper_ != nullptr) keeper_->keep(state_);
            throw;
        }
    }

    SurfaceBake field()
    {
        FieldParts parts = solved(state_, sphere_, stages_, job_, ground_levels(ground_, shape_.mesh));
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
        bake.paths = state_.paths;
        return bake;
    }

private:
    uint64_t staged_left() const { return fit_.staged_left(state_) + solution_work(state_); }
    void plan() { job_.plan(fit_.rays_left(state_), staged_left()); }

    // Reads what the checkpoint has.
    uint64_t earlier_work()
    {
        std::vector<uint8_t> earlier;
        if (keeper_ != nullptr && keeper_->store().read_state(earlier) && !add_encoded(earlier, state_))
            throw BakeError("the checkpoint is damaged; discard it with --restart");
        return fit_.work_in(state_);
    }

    const SurfaceSettings& settings_;
    Keeper* const keeper_;
    BakeStages stages_;
    const MeshLoss loss_;
    const FieldSphere sphere_;
    const PartShadows shadows_;
    const GroundShadow ground_;
    const FitShape shape_;
    const EncodedTone tone_;
    FitState state_;
    LightFit fit_;
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
    SurfaceFit fit(scene, plan.settings, {}, basis_for(scene, plan, {}, nullptr, progress), {}, nullptr, progress);
    fit.trace();
    return fit.field();
}

SurfaceBake bake_surface(const Scene& scene, const SurfacePlan& plan, const std::filesystem::path& output,
                         const ProgressCallback& progress, Earlier earlier)
{
    require_possible(scene, plan.settings);
    Keeper keeper(checkpoint_of(output), identity(scene, plan.settings, {}), earlier);
    if (earlier == Earlier::discard) discard_stages(output);
    FitBasis basis = basis_for(scene, plan, output, &keeper, progress);
    SurfaceFit fit(scene, plan.settings, {}, std::move(basis), output, &keeper, progress);
    fit.trace();
    SurfaceBake bake = fit.field();
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    keeper.checkpoint().remove();
    discard_stages(output);
    return bake;
}

void bake_surface_shard(const Scene& scene, const SurfacePlan& plan, const Shard& shard,
                        const std::filesystem::path& output, const ProgressCallback& progress, Earlier earlier)
{
    require_possible(scene, plan.settings);
    const BakeIdentity id = identity(scene, plan.settings, shard);
    if (earlier == Earlier::resume && is_finished_shard(output, id, has_all_sums)) return;
    Keeper keeper(checkpoint_of(output), id, earlier);
    if (earlier == Earlier::discard) discard_stages(output);
    FitBasis basis = basis_for(scene, plan, output, &keeper, progress);
    SurfaceFit(scene, plan.settings, shard, std::move(basis), output, &keeper, progress).trace();
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
    std::filesystem::remove(kept_stages(output), ignored);
}

}  // namespace lumi::baker
