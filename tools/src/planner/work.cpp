// SPDX-License-Identifier: MIT
#include "planner/work.h"

#include "planner/counted.h"
#include "planner/unit_costs.h"

namespace lumi::planner
{

SurfaceWork work_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows)
{
    SurfaceWork work;
    SurfaceCamera camera;
    if (make_surface_camera(eye.pose, eye.image, camera) == CameraError::none)
        lumi_count_surface(&field, &camera, static_cast<int>(mode), stripe_rows, work.frame.done.data(),
                           work.preparing.done.data());
    return work;
}

ChordFrame frame_of(const Field& field, tools::Mode mode, int32_t span_px, const Camera& camera, int32_t stripe_rows)
{
    ChordFrame frame;
    const auto note = [](void* reads, uint32_t address, uint32_t bytes) {
        static_cast<std::vector<Read>*>(reads)->push_back({address, bytes});
    };
    lumi_count_chord(&field, &camera, static_cast<int>(mode), span_px, stripe_rows, frame.work.done.data(), note,
                     &frame.reads);
    return frame;
}

double instructions_of(const std::string& core, const FrameWork& work)
{
    double sum = 0;
    for (size_t k = 0; k < work.done.size(); ++k)
        sum += static_cast<double>(work.done[k]) * (core == "m0plus" ? kUnitCosts[k].m0plus : kUnitCosts[k].m4);
    return sum;
}

}  // namespace lumi::planner
