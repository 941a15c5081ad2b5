// SPDX-License-Identifier: MIT
#include "baking/ray_log.h"

#include <dlfcn.h>
#include <embree3/rtcore.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace lumi::baker::bench
{
namespace
{

struct LoggedRay {
    RTCRay ray;
    bool closest;
};

struct Log {
    std::vector<LoggedRay> rays;
    RTCScene scene = nullptr;
    bool on = false;
};

Log& log()
{
    static Log instance;
    return instance;
}

template <class Function>
Function* library_function(const char* name)
{
    void* found = dlsym(RTLD_NEXT, name);
    if (!found) {
        std::fprintf(stderr, "lumi-lab: Embree has no %s; install libembree-dev\n", name);
        std::abort();
    }
    return reinterpret_cast<Function*>(found);
}

using Intersect = void(RTCScene, RTCIntersectContext*, RTCRayHit*);
using Occluded = void(RTCScene, RTCIntersectContext*, RTCRay*);

Intersect* library_intersect()
{
    static Intersect* const kFunction = library_function<Intersect>("rtcIntersect1");
    return kFunction;
}

Occluded* library_occluded()
{
    static Occluded* const kFunction = library_function<Occluded>("rtcOccluded1");
    return kFunction;
}

void note(RTCScene scene, const RTCRay& ray, bool closest)
{
    if (log().on) {
        log().scene = scene;
        log().rays.push_back({ray, closest});
    }
}

double query(const LoggedRay& logged)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (logged.closest) {
        RTCRayHit hit;
        hit.ray = logged.ray;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        library_intersect()(log().scene, &context, &hit);
        return hit.hit.primID;
    }
    RTCRay ray = logged.ray;
    library_occluded()(log().scene, &context, &ray);
    return ray.tfar < 0 ? 1 : 0;
}

}  // namespace

void start_ray_log()
{
    log().rays.clear();
    log().on = true;
}

void stop_ray_log()
{
    log().on = false;
}

RayCounts logged_rays()
{
    RayCounts counts;
    for (const LoggedRay& logged : log().rays) ++(logged.closest ? counts.closest : counts.blocked);
    return counts;
}

double thread_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Replay replay_ray_log()
{
    Replay result;
    const double start = thread_seconds();
    for (const LoggedRay& logged : log().rays) result.checksum += query(logged);
    result.seconds = thread_seconds() - start;
    return result;
}

}  // namespace lumi::baker::bench

extern "C" void rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* query)
{
    lumi::baker::bench::note(scene, query->ray, true);
    lumi::baker::bench::library_intersect()(scene, context, query);
}

extern "C" void rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* query)
{
    lumi::baker::bench::note(scene, *query, false);
    lumi::baker::bench::library_occluded()(scene, context, query);
}
