// SPDX-License-Identifier: MIT
#include "lumi/baker/surface.h"

#include <chrono>

#include "chord/tracing_fingerprint.h"
#include "fit/light_fit.h"
#include "fit/see_through_light.h"
#include "fit/texel_density.h"
#include "store/bake_stages.h"
#include "store/checkpoint.h"
#include "store/new_file.h"
#include "store/output_names.h"
#include "store/settings_codec.h"
#include "surface/surface_file_store.h"
#include "trace/catcher.h"

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
    void keep_now_and_then(const FitState& state)
    {
        const Clock::time_point start = Clock::now();
        if (start >= next_) {
            keep(state);
            const Clock::time_point end = Clock::now();
            next_ = end + std::max<Clock::duration>(kShortest, kBetween * (end - start));
        }
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

FitBasis basis_of(const SceneData& scene, const SurfaceDraft& draft, const SurfaceSettings& settings,
                  const ProgressCallback& progress)
{
    const BuiltMesh& built = draft.built();
    if (built.mesh.patches.empty())
        throw BakeError("the scene has no surface that could be seen; choose --layout chord");
    FitBasis basis = {built.mesh,
                      texel_densities(scene, built.mesh, settings, progress),
                      built.loss,
                      scene.tone,
                      {scene.centre, scene.radius},
                      {}};
    basis.see_through = see_through_light(scene, FitShape(basis.mesh, basis.densities), settings, progress);
    return basis;
}

class SurfaceBaker
{
public:
    // `keeper` and `draft` may be null; without a keeper `output` is empty.
    SurfaceBaker(const Scene& scene, const SurfaceSettings& settings, const Shard& shard,
                 const std::filesystem::path& output, Keeper* keeper, const ProgressCallback& progress,
                 const SurfaceDraft* draft)
        : settings_(settings),
          progress_(progress),
          keeper_(keeper),
          basis_(basis_for(scene, output, draft)),
          stages_(output.empty() ? output : stages_of(output), scene.fingerprint(), settings),
          shape_(basis_.mesh, basis_.densities, basis_.see_through),
          tone_(basis_.tone),
          state_(shape_, tone_),
          fit_(scene.data(), shape_, settings_, shard),
          job_(fit_.work() + solution_work(shape_), settings_.threads, progress, earlier_work())
    {
    }

    void trace()
    {
        try {
            fit_.trace(
                state_, stages_, job_,
                [this] {
                    if (keeper_ != nullptr) keeper_->keep_now_and_then(state_);
                });
        } catch (const Cancelled&) {
            if (keeper_ != nullptr) keeper_->keep(state_);
            throw;
        }
    }

    SurfaceBake field()
    {
        SurfaceBake bake;
        const FieldParts parts = solution();
        bake.file = surface_file(shape_, parts);
        bake.vertices = static_cast<uint32_t>(shape_.mesh.positions.size());
        for (const ViewCode& view : parts.views) bake.viewed_vertices += view.is_there() ? 1u : 0u;
        for (const PatchMesh::Patch& patch : shape_.mesh.patches)
            bake.triangles += patch.d == PatchMesh::kNone ? 1u : 2u;
        bake.texels = shape_.layout.texels;
        bake.loss = basis_.loss;
        bake.paths = state_.paths;
        return bake;
    }

    const FitState& state() const { return state_; }

private:
    // Reads what the checkpoint has.
    uint64_t earlier_work()
    {
        std::vector<uint8_t> earlier;
        if (keeper_ != nullptr && keeper_->store().read_state(earlier) && !add_encoded(earlier, state_))
            throw BakeError("the checkpoint is damaged; discard it with --restart");
        return fit_.work_in(state_);
    }

    FieldParts solution()
    {
        if (keeper_ != nullptr) keeper_->keep(state_);
        FieldParts parts = solved(state_, settings_.view_tables, basis_.sphere, stages_, job_);
        job_.finish();
        return parts;
    }

    FitBasis basis_for(const Scene& scene, const std::filesystem::path& output, const SurfaceDraft* draft) const
    {
        if (std::optional<FitBasis> kept = keeper_ != nullptr ? keeper_->store().read_basis() : std::nullopt)
            return std::move(*kept);
        FitBasis basis = draft != nullptr ? basis_of(scene.data(), *draft, settings_, progress_)
                                          : basis_of(scene.data(), SurfaceDraft(scene, settings_, progress_, output),
                                                     settings_, progress_);
        if (keeper_ != nullptr) keeper_->store().write_basis(basis);
        return basis;
    }

    const SurfaceSettings settings_;
    const ProgressCallback& progress_;
    Keeper* const keeper_;
    const FitBasis basis_;
    BakeStages stages_;  // after the draft's, which has the same file
    const FitShape shape_;
    const EncodedTone tone_;
    FitState state_;
    LightFit fit_;
    Job job_;
};

void require_possible(const Scene& scene, const SurfaceSettings& settings)
{
    require_partial_coverage(scene.data(), false);
    require_possible_surface(settings);
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

SurfaceBake surface_field(const Scene& scene, const SurfaceSettings& settings, const ProgressCallback& progress,
                          const SurfaceDraft* draft)
{
    require_possible(scene, settings);
    SurfaceBaker baker(scene, settings, {}, {}, nullptr, progress, draft);
    baker.trace();
    return baker.field();
}

SurfaceBake bake_surface(const Scene& scene, const SurfaceSettings& settings, const std::filesystem::path& output,
                         const ProgressCallback& progress, Earlier earlier, const SurfaceDraft* draft)
{
    require_possible(scene, settings);
    Keeper keeper(checkpoint_of(output), identity(scene, settings, {}), earlier);
    if (earlier == Earlier::discard) discard_stages(output);
    SurfaceBaker baker(scene, settings, {}, output, &keeper, progress, draft);
    baker.trace();
    SurfaceBake bake = baker.field();
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    keeper.checkpoint().remove();
    discard_stages(output);
    return bake;
}

void bake_surface_shard(const Scene& scene, const SurfaceSettings& settings, const Shard& shard,
                        const std::filesystem::path& output, const ProgressCallback& progress, Earlier earlier)
{
    require_possible(scene, settings);
    const BakeIdentity id = identity(scene, settings, shard);
    if (earlier == Earlier::resume && is_finished_shard(output, id, has_all_sums)) return;
    Keeper keeper(checkpoint_of(output), id, earlier);
    if (earlier == Earlier::discard) discard_stages(output);
    SurfaceBaker baker(scene, settings, shard, output, &keeper, progress, nullptr);
    baker.trace();
    keeper.keep(baker.state());
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
