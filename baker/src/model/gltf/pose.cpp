// SPDX-License-Identifier: MIT
#include "model/gltf/pose.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/gltf/accessor.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

std::vector<uint32_t> rows_from(size_t first, size_t count)
{
    std::vector<uint32_t> rows(count);
    std::iota(rows.begin(), rows.end(), static_cast<uint32_t>(first));
    return rows;
}

std::string name_of(const std::string& name, int32_t index)
{
    return name.empty() ? std::to_string(index) : "'" + name.substr(0, 60) + "'";
}

// The keys of one property of a node, read one at a time: many channels may share long lists.
class Channel
{
public:
    Channel(const GltfModel& model, const GltfAnimation& animation, const GltfChannel& channel, size_t width)
        : model_(model),
          animation_(animation),
          input_(channel.input),
          output_(channel.output),
          width_(width),
          is_step_(channel.interpolation == "STEP"),
          is_cubic_(channel.interpolation == "CUBICSPLINE"),
          is_turn_(channel.path == "rotation")
    {
        keys_ = count_of(model, input_);
        check_plain(input_);
        check_plain(output_);
        const size_t numbers = count_of(model, output_) * accessor_width();
        if (keys_ == 0 || numbers / keys_ / (is_cubic_ ? 3 : 1) < width_) fail("has keys without values");
    }

    std::vector<double> at(double seconds) const
    {
        const size_t next = first_after(seconds);
        if (next == 0) return value(0, kValue);
        if (next == keys_ || is_step_) return value(next - 1, kValue);
        const double begin = time(next - 1), length = time(next) - begin;
        const double share = length > 0 ? std::clamp((seconds - begin) / length, 0.0, 1.0) : 0;
        const std::vector<double> a = value(next - 1, kValue), b = value(next, kValue);
        if (is_cubic_) return cubic(a, value(next - 1, kOut), value(next, kIn), b, share, length);
        return is_turn_ ? turned_between(a, b, share) : mixed(a, b, 1 - share, share);
    }

private:
    enum Part : size_t { kIn, kValue, kOut };  // of a cubic spline's key: tangent, value, tangent

    [[noreturn]] void fail(const std::string& what) const
    {
        fail_gltf(model_, "the animation '" + animation_.name.substr(0, 60) + "' " + what + "; export the file again");
    }

    void check_plain(int32_t accessor) const
    {
        if (element_of(model_, model_.accessors, accessor, "accessor").sparse_indices) fail("has sparse keys");
    }

    size_t accessor_width() const { return model_.accessors[static_cast<size_t>(output_)].width; }

    double time(size_t key) const
    {
        return static_cast<double>(floats_of(model_, input_, 1, {static_cast<uint32_t>(key)})[0]);
    }

    size_t first_after(double seconds) const
    {
        size_t low = 0, high = keys_;
        while (low < high) {
            const size_t middle = low + (high - low) / 2;
            (time(middle) > seconds ? high : low) = time(middle) > seconds ? middle : middle + 1;
        }
        return low;
    }

    // Weights of a morph stand one after the other in elements of one number.
    std::vector<double> value(size_t key, Part part) const
    {
        const size_t group = is_cubic_ ? 3 * key + part : key, rows = accessor_width() == 1 ? width_ : 1;
        const std::vector<float> numbers = floats_of(model_, output_, width_ / rows, rows_from(group * rows, rows));
        return {numbers.begin(), numbers.end()};
    }

    static std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double of_a,
                                     double of_b)
    {
        std::vector<double> result(a.size());
        for (size_t k = 0; k < a.size(); ++k) result[k] = of_a * a[k] + of_b * b[k];
        return result;
    }

    // Along the shorter arc at even speed: Shoemake, "Animating Rotation with Quaternion Curves", SIGGRAPH 1985.
    static std::vector<double> turned_between(const std::vector<double>& a, const std::vector<double>& b, double share)
    {
        double cosine = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
        const double sign = cosine < 0 ? -1 : 1;
        cosine *= sign;
        constexpr double kNearly = 0.9999;
        if (cosine > kNearly) return mixed(a, b, 1 - share, sign * share);
        const double angle = std::acos(cosine), sine = std::sin(angle);
        return mixed(a, b, std::sin((1 - share) * angle) / sine, sign * std::sin(share * angle) / sine);
    }

    // Hermite's spline, as appendix C of the specification has it.
    static std::vector<double> cubic(const std::vector<double>& a, const std::vector<double>& out,
                                     const std::vector<double>& in, const std::vector<double>& b, double t,
                                     double length)
    {
        const double t2 = t * t, t3 = t2 * t;
        const std::vector<double> ends = mixed(a, b, 2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3);
        return mixed(ends, mixed(out, in, length * (t3 - 2 * t2 + t), length * (t3 - t2)), 1, 1);
    }

    const GltfModel& model_;
    const GltfAnimation& animation_;
    int32_t input_, output_;
    size_t width_, keys_ = 0;
    bool is_step_, is_cubic_, is_turn_;
};

const GltfAnimation& animation_of(const GltfModel& model, const std::string& name)
{
    std::string names;
    for (const GltfAnimation& animation : model.animations) {
        if (animation.name == name) return animation;
        names += (names.empty() ? "" : ", ") + ("'" + animation.name.substr(0, 60) + "'");
    }
    constexpr size_t kMostOfNames = 400;
    fail_gltf(model, "it has no animation '" + name + "'; " +
                         (names.empty() ? "leave out --animation" : "choose among: " + names.substr(0, kMostOfNames)));
}

}  // namespace

Affine cofactors(const Affine& m)
{
    Affine result{};
    for (size_t r = 0; r < 3; ++r) {
        for (size_t c = 0; c < 3; ++c) {
            const size_t a = (r + 1) % 3, b = (r + 2) % 3, d = (c + 1) % 3, e = (c + 2) % 3;
            result[r][c] = m[a][d] * m[b][e] - m[a][e] * m[b][d];
        }
    }
    return result;
}

Vec3 turned(const Affine& turn, const Vec3& n)
{
    const std::array<double, 3> v =
        point_of(turn, static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z));
    const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(size > 0) || !std::isfinite(size)) return {};
    return {static_cast<float>(v[0] / size), static_cast<float>(v[1] / size), static_cast<float>(v[2] / size)};
}

void play(GltfModel& model, const AnimationTime& time)
{
    const GltfAnimation& animation = animation_of(model, time.name);
    for (const GltfChannel& channel : animation.channels) {
        if (channel.node == kNoIndex) continue;
        element_of(model, model.nodes, channel.node, "node");
        GltfNode& node = model.nodes[static_cast<size_t>(channel.node)];
        const bool turns = channel.path == "rotation", weighs = channel.path == "weights";
        if (!turns && !weighs && channel.path != "translation" && channel.path != "scale")
            fail_gltf(model, "the animation '" + animation.name.substr(0, 60) + "' moves '" +
                                 channel.path.substr(0, 60) + "', which cannot be posed; remove it from the animation");
        const size_t width = turns ? 4 : weighs ? node.weights.size() : 3;
        if (width == 0) continue;
        const std::vector<double> value = Channel(model, animation, channel, width).at(time.seconds);
        if (weighs)
            node.weights.assign(value.begin(), value.end());
        else if (turns)
            node.rotation = value;
        else
            (channel.path == "scale" ? node.scale : node.translation) = value;
        if (!weighs) node.matrix = affine_of(node.translation, node.rotation, node.scale);
    }
}

std::vector<Affine> places_of_nodes(const GltfModel& model)
{
    const size_t count = model.nodes.size();
    std::vector<Affine> places(count, kIdentity);
    std::vector<bool> is_child(count, false), seen(count, false);
    const auto each_child = [&](size_t node, const auto& take) {
        for (const int32_t child : model.nodes[node].children)
            if (child >= 0 && static_cast<size_t>(child) < count) take(static_cast<size_t>(child));
    };
    for (size_t k = 0; k < count; ++k) each_child(k, [&](size_t child) { is_child[child] = true; });
    std::vector<size_t> open;
    for (size_t k = 0; k < count; ++k) {
        if (is_child[k]) continue;
        places[k] = model.nodes[k].matrix;
        open.push_back(k);
    }
    while (!open.empty()) {
        const size_t node = open.back();
        open.pop_back();
        each_child(node, [&](size_t child) {
            if (seen[child]) return;
            seen[child] = true;
            places[child] = combined(places[node], model.nodes[child].matrix);
            open.push_back(child);
        });
    }
    return places;
}

std::vector<Affine> joint_matrices(const GltfModel& model, int32_t index, const std::vector<Affine>& places)
{
    const GltfSkin& skin = element_of(model, model.skins, index, "skin");
    const size_t count = skin.joints.size();
    std::vector<float> bound;
    constexpr size_t kNumbers = 16;  // columns of four rows
    if (skin.inverse_bind != kNoIndex) {
        const GltfAccessor& accessor = element_of(model, model.accessors, skin.inverse_bind, "accessor");
        if (count_of(model, skin.inverse_bind) < count || accessor.width != kNumbers || accessor.sparse_indices)
            fail_gltf(model, "skin " + name_of(skin.name, index) +
                                 " has fewer inverse bind matrices than joints; export the file again");
        bound = floats_of(model, skin.inverse_bind, kNumbers, rows_from(0, count));
    }
    std::vector<Affine> matrices;
    for (size_t k = 0; k < count; ++k) {
        element_of(model, model.nodes, skin.joints[k], "joint");
        Affine inverse_bind = kIdentity;
        for (size_t r = 0; r < 3 && !bound.empty(); ++r)
            for (size_t c = 0; c < 4; ++c) inverse_bind[r][c] = static_cast<double>(bound[kNumbers * k + 4 * c + r]);
        matrices.push_back(combined(places[static_cast<size_t>(skin.joints[k])], inverse_bind));
    }
    return matrices;
}

size_t morphed_vertices(const GltfPrimitive& primitive, const std::vector<float>& weights, size_t vertices)
{
    const size_t targets = std::min(weights.size(), primitive.targets.size());
    return vertices * static_cast<size_t>(std::count_if(weights.begin(), weights.begin() + static_cast<long>(targets),
                                                        [](float weight) { return weight != 0; }));
}

void morph(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<float>& weights,
           const std::vector<uint32_t>& used, GltfShape& shape)
{
    for (size_t target = 0; target < std::min(weights.size(), primitive.targets.size()); ++target) {
        const float weight = weights[target];
        if (weight == 0) continue;
        const auto add = [&](const char* name, std::vector<Vec3>& to) {
            const auto found = primitive.targets[target].find(name);
            if (found == primitive.targets[target].end() || to.empty() || used.empty()) return;
            if (count_of(model, found->second) <= used.back())
                fail_gltf(model, "a morph target has fewer entries than there are vertices; export the file again");
            const std::vector<float> moves = floats_of(model, found->second, 3, used);
            for (size_t k = 0; k < to.size(); ++k)
                to[k] = to[k] + Vec3{moves[3 * k], moves[3 * k + 1], moves[3 * k + 2]} * weight;
        };
        add("POSITION", shape.positions);
        add("NORMAL", shape.normals);
    }
}

bool bend(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<Affine>& joints,
          const std::vector<uint32_t>& used, GltfShape& shape)
{
    constexpr size_t kInSet = 4;
    std::vector<float> numbers[2], weights[2];
    for (size_t set = 0; set < 2; ++set) {
        const auto joint = primitive.attributes.find("JOINTS_" + std::to_string(set));
        const auto weight = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
        if (joint == primitive.attributes.end() || weight == primitive.attributes.end()) continue;
        for (const int32_t accessor : {joint->second, weight->second})
            if (!used.empty() && count_of(model, accessor) <= used.back())
                fail_gltf(model, "a skin's joints or weights are fewer than its vertices; export the file again");
        numbers[set] = floats_of(model, joint->second, kInSet, used);
        weights[set] = floats_of(model, weight->second, kInSet, used);
    }
    if (numbers[0].empty()) return false;
    for (size_t vertex = 0; vertex < used.size(); ++vertex) {
        Affine sum{};
        double total = 0;
        for (size_t k = kInSet * vertex; k < kInSet * (vertex + 1); ++k) {
            for (size_t set = 0; set < 2; ++set) {
                const double weight = numbers[set].empty() ? 0 : static_cast<double>(weights[set][k]);
                if (!(weight > 0)) continue;
                if (!(numbers[set][k] >= 0 && numbers[set][k] < static_cast<float>(joints.size())))
                    fail_gltf(model, "a vertex hangs on joint " + number_text(static_cast<double>(numbers[set][k])) +
                                         ", but its skin has " + std::to_string(joints.size()) +
                                         "; export the file again");
                const Affine& joint = joints[static_cast<size_t>(numbers[set][k])];
                for (size_t r = 0; r < 3; ++r)
                    for (size_t c = 0; c < 4; ++c) sum[r][c] += weight * joint[r][c];
                total += weight;
            }
        }
        if (!(total > 0)) continue;  // nothing holds it
        for (std::array<double, 4>& row : sum)
            for (double& number : row) number /= total;
        shape.positions[vertex] = moved(sum, shape.positions[vertex]);
        Affine turn = cofactors(sum);
        if (!shape.normals.empty()) shape.normals[vertex] = turned(turn, shape.normals[vertex]);
    }
    return true;
}

}  // namespace lumi::baker
