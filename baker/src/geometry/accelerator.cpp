// SPDX-License-Identifier: MIT
// The one file that sees Embree: 4, or 3, whose queries take a context.
#include "geometry/accelerator.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstring>
#include <stdexcept>

namespace lumi::baker
{

struct Accelerator::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

namespace
{

// One build thread: a parallel build may order equal triangles differently from run to run, and a ray through a shared
// edge would then hit now the one, now the other.
constexpr char kDeviceConfig[] = "threads=1";

void check(RTCDevice device, const char* what)
{
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY)
        throw std::runtime_error("Embree is out of memory; bake a smaller scene or on a larger machine");
    if (error != RTC_ERROR_NONE)
        throw std::runtime_error(std::string("Embree cannot ") + what + "; error " + std::to_string(error));
}

template <class T>
void upload(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& items)
{
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size());
    if (buffer && !items.empty()) std::memcpy(buffer, items.data(), items.size() * sizeof(T));
}

RTCRay to_embree(const Ray& ray)
{
    RTCRay r{};
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.tfar = ray.end;
    r.mask = ~0u;
    return r;
}

// Embree calls this for each hit of a ray, and looks further where the hit is made invalid. Ng points to the side from
// which the triangle winds counter-clockwise.
void pass_back_faces(const RTCFilterFunctionNArguments* call)
{
    const auto& ray = *reinterpret_cast<const RTCRay*>(call->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(call->hit);
    if (ray.dir_x * hit.Ng_x + ray.dir_y * hit.Ng_y + ray.dir_z * hit.Ng_z >= 0) call->valid[0] = 0;
}

#if RTC_VERSION_MAJOR >= 4
void find_closest(RTCScene scene, RTCRayHit& query)
{
    rtcIntersect1(scene, &query);
}
void find_any(RTCScene scene, RTCRay& query)
{
    rtcOccluded1(scene, &query);
}
#else
void find_closest(RTCScene scene, RTCRayHit& query)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
}

void find_any(RTCScene scene, RTCRay& query)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &query);
}
#endif

}  // namespace

Accelerator::Accelerator(const Mesh& mesh, Faces faces) : impl_(std::make_unique<Impl>())
{
    impl_->device = rtcNewDevice(kDeviceConfig);
    if (!impl_->device) check(nullptr, "start");
    impl_->scene = rtcNewScene(impl_->device);
    rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    upload(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    upload(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.corners);
    if (faces == Faces::front) rtcSetGeometryIntersectFilterFunction(geometry, pass_back_faces);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(impl_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(impl_->scene);
    check(impl_->device, "build its tree");
}

Accelerator::Accelerator(Accelerator&&) noexcept = default;
Accelerator::~Accelerator() = default;

std::optional<Hit> Accelerator::closest(const Ray& ray) const
{
    RTCRayHit query{};
    query.ray = to_embree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    find_closest(impl_->scene, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
}

bool Accelerator::blocked(const Ray& ray) const
{
    RTCRay query = to_embree(ray);
    find_any(impl_->scene, query);
    return query.tfar < 0;
}

}  // namespace lumi::baker
