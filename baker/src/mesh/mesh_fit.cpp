// SPDX-License-Identifier: MIT
#include "mesh/mesh_fit.h"

#include "lumi/detail/lattice.h"
#include "math/vec3.h"
#include "mesh/mesh_outline.h"

namespace lumi::baker
{
namespace
{

// Weights in the sum of squares. The first two are shares of the rays that a vertex has on average.
constexpr double kSmoothness = 0.005;  // weight of a difference between neighbours' displacements
constexpr double kInertia = 0.005;     // weight of a displacement itself
constexpr double kOutlineScale = 2;  // factor on an outline point's equation: it counts as the square of that many hits
constexpr int kFittingRounds = 4;
constexpr int kSolverSteps = 40;
constexpr float kMinTurn = 0.3f;  // cosine between a triangle's normals before and after all rounds

struct Vec3d {
    double x = 0, y = 0, z = 0;
};
Vec3d operator+(const Vec3d& a, const Vec3d& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3d operator-(const Vec3d& a, const Vec3d& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3d operator*(double s, const Vec3d& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
double dot(const Vec3d& a, const Vec3d& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3d wide(const Vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

using Field = std::vector<Vec3d>;  // a displacement for each vertex

double dot(const Field& a, const Field& b)
{
    double sum = 0;
    for (size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
    return sum;
}

void add_scaled(Field& a, double s, const Field& b)
{
    for (size_t k = 0; k < a.size(); ++k) a[k] = a[k] + s * b[k];
}

// Σ weight·(normal·displacement) should be `offset`: of a place on a triangle, or on an edge.
struct Equation {
    Mesh::Corners corners;
    double weights[3];
    Vec3d normal;
    double offset;
};

std::vector<Equation> equations_of(const std::vector<SurveyRay>& rays, const Mesh& mesh)
{
    std::vector<Equation> result;
    for (const SurveyRay& r : rays) {
        if (!r.mesh || !(std::abs(r.scene - r.mesh->distance) <= kMaxDepthError)) continue;
        const Vec3 normal = normalized(mesh.area_vector(r.mesh->triangle));
        const double u = static_cast<double>(r.mesh->u), v = static_cast<double>(r.mesh->v);
        const float offset = (r.scene - r.mesh->distance) * dot(normal, r.ray.direction);
        result.push_back(
            {mesh.corners[r.mesh->triangle], {1 - u - v, u, v}, wide(normal), static_cast<double>(offset)});
    }
    return result;
}

void add_outlines(const std::vector<OutlinePoint>& points, std::vector<Equation>& equations)
{
    for (const OutlinePoint& p : points) {
        const double to = kOutlineScale * static_cast<double>(p.share);
        const double offset = kOutlineScale * static_cast<double>(p.offset);
        equations.push_back({{p.from, p.to, p.to}, {kOutlineScale - to, to, 0}, wide(p.outwards), offset});
    }
}

class System
{
public:
    System(const Mesh& mesh, std::vector<Equation> equations) : mesh_(mesh), equations_(std::move(equations))
    {
        share_ =
            static_cast<double>(equations_.size()) / static_cast<double>(std::max<size_t>(1, mesh.positions.size()));
    }

    // Conjugate gradients on the normal equations.
    Field solve() const
    {
        Field x(mesh_.positions.size()), r = right_side();
        Field p = r;
        double rr = dot(r, r);
        for (int k = 0; k < kSolverSteps && rr > 0; ++k) {
            const Field ap = apply(p);
            const double step = rr / dot(p, ap);
            add_scaled(x, step, p);
            add_scaled(r, -step, ap);
            const double next = dot(r, r);
            Field direction = r;
            add_scaled(direction, next / rr, p);
            p = std::move(direction);
            rr = next;
        }
        return x;
    }

private:
    Field right_side() const
    {
        Field b(mesh_.positions.size());
        for (const Equation& e : equations_)
            for (size_t k = 0; k < 3; ++k) b[e.corners[k]] = b[e.corners[k]] + (e.weights[k] * e.offset) * e.normal;
        return b;
    }

    Field apply(const Field& x) const
    {
        Field y(x.size());
        add_scaled(y, kInertia * share_, x);
        for (const Equation& e : equations_) {
            double along = 0;
            for (size_t k = 0; k < 3; ++k) along += e.weights[k] * dot(e.normal, x[e.corners[k]]);
            for (size_t k = 0; k < 3; ++k) y[e.corners[k]] = y[e.corners[k]] + (e.weights[k] * along) * e.normal;
        }
        for (const Mesh::Corners& c : mesh_.corners) {
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t a = c[k], b = c[(k + 1) % 3];
                const Vec3d difference = (kSmoothness * share_) * (x[a] - x[b]);
                y[a] = y[a] + difference;
                y[b] = y[b] - difference;
            }
        }
        return y;
    }

    const Mesh& mesh_;
    std::vector<Equation> equations_;
    double share_;  // equations a vertex
};

Mesh moved(const Mesh& mesh, const Field& by)
{
    Mesh result = mesh;
    for (size_t k = 0; k < by.size(); ++k) {
        Vec3& p = result.positions[k];
        const float limit = kMaxDepthError;
        const Vec3 d = {static_cast<float>(by[k].x), static_cast<float>(by[k].y), static_cast<float>(by[k].z)};
        p = p + d * std::min(1.0f, limit / std::max(length(d), 1e-9f));
        p = p * std::min(1.0f, 1 / std::max(length(p), 1e-9f));  // nothing lies outside the sphere
    }
    return result;
}

// Takes back what turns triangles away from where `upright` has them; returns whether there was anything.
bool untangle_once(const Mesh& before, const Mesh& upright, Field& by)
{
    const Mesh after = moved(before, by);
    bool any = false;
    for (size_t k = 0; k < before.triangle_count(); ++k) {
        const Vec3 a = upright.area_vector(k), b = after.area_vector(k);
        if (dot(a, b) >= kMinTurn * length(a) * length(b)) continue;
        for (const uint32_t corner : before.corners[k]) {
            any = any || dot(by[corner], by[corner]) > 0;
            by[corner] = {};
        }
    }
    return any;
}

}  // namespace

Mesh fitted(const Mesh& mesh, const Mesh& upright, Faces faces, const Survey& survey, Job& job)
{
    const MeshTracer tracer(mesh, faces);
    std::vector<std::vector<Equation>> parts(survey.origins());
    const MeshOutline outline(survey.scene(), tracer, survey.cap());
    const detail::Lattice eyes(survey.origins());
    job.run(survey.origins(), [&](uint32_t i) {
        parts[i] = equations_of(survey.look(i, tracer), mesh);
        add_outlines(outline.seen_from(unit_vector(detail::point(eyes, i)), i), parts[i]);
    });
    Mesh result;
    job.run(1, [&](uint32_t) {
        std::vector<Equation> equations;
        for (const std::vector<Equation>& part : parts) equations.insert(equations.end(), part.begin(), part.end());
        Field by = System(mesh, std::move(equations)).solve();
        while (untangle_once(mesh, upright, by)) {
        }
        result = moved(mesh, by);
    });
    return result;
}

Mesh fitted_in_rounds(const SceneData& scene, Mesh mesh, Faces faces, Job& job, const ViewCap& cap)
{
    const Survey survey = fitting_survey(scene, mesh, cap);
    const Mesh upright = mesh;
    for (int round = 0; round < kFittingRounds && mesh.triangle_count() != 0; ++round)
        mesh = fitted(mesh, upright, faces, survey, job);
    return mesh;
}

}  // namespace lumi::baker
