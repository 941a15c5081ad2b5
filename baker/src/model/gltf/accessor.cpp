// SPDX-License-Identifier: MIT
#include "model/gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace lumi::baker
{
namespace
{

enum Component : int32_t { kInt8 = 5120, kUint8, kInt16, kUint16, kUint32 = 5125, kFloat32 };

size_t bytes_of(int32_t component)
{
    switch (component) {
        case kInt8:
        case kUint8:
            return 1;
        case kInt16:
        case kUint16:
            return 2;
        case kUint32:
        case kFloat32:
            return 4;
        default:
            return 0;
    }
}

template <class T>
T number_at(const char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value);  // files are little-endian, as the machines that bake
    return value;
}

template <class T>
double whole_at(const char* bytes, bool normalized)
{
    const double value = static_cast<double>(number_at<T>(bytes));
    return normalized ? std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : value;
}

double component_at(const char* bytes, int32_t component, bool normalized)
{
    switch (component) {
        case kInt8:
            return whole_at<int8_t>(bytes, normalized);
        case kUint8:
            return whole_at<uint8_t>(bytes, normalized);
        case kInt16:
            return whole_at<int16_t>(bytes, normalized);
        case kUint16:
            return whole_at<uint16_t>(bytes, normalized);
        case kUint32:
            return whole_at<uint32_t>(bytes, normalized);
        default:
            return static_cast<double>(number_at<float>(bytes));
    }
}

// The elements of a run that is known to lie inside its buffer.
struct Elements {
    const char* first = nullptr;  // null: zeros
    size_t stride = 0;

    const char* at(size_t k) const { return first + k * stride; }
};

Elements elements_of(const GltfModel& model, const GltfRun& run, uint32_t width)
{
    const size_t size = bytes_of(run.component) * width;
    if (size == 0) fail_gltf(model, "an accessor has a component type of its own; export the file again");
    const GltfView& view = element_of(model, model.views, run.view, "buffer view");
    const std::string& buffer = element_of(model, model.buffers, view.buffer, "buffer");
    const size_t stride = view.stride == 0 ? size : view.stride;
    const bool view_fits = view.offset <= buffer.size() && view.length <= buffer.size() - view.offset;
    const bool begins = view_fits && run.offset <= view.length && size <= view.length - run.offset;
    if (run.count != 0 && (!begins || run.count - 1 > (view.length - run.offset - size) / stride)) {
        fail_gltf(model, "an accessor of " + std::to_string(run.count) +
                             " elements reaches beyond its buffer; the file is damaged or cut short, export it again");
    }
    return {buffer.data() + (run.count == 0 ? 0 : view.offset + run.offset), stride};
}

// Zeros take no bytes of the file: few bytes must not claim much memory.
void check_zeros(const GltfModel& model, const GltfAccessor& accessor)
{
    size_t bytes = 0;
    for (const std::string& buffer : model.buffers) bytes += buffer.size();
    if (accessor.run.count > bytes) {
        fail_gltf(model, "an accessor claims " + std::to_string(accessor.run.count) +
                             " elements without any bytes; export the file again");
    }
}

// The elements that are read: all, or those in a list that ascends.
class Rows
{
public:
    explicit Rows(size_t count) : count_(count) {}
    explicit Rows(const std::vector<uint32_t>& list) : count_(list.size()), list_(&list) {}

    size_t count() const { return count_; }
    size_t at(size_t k) const { return list_ ? (*list_)[k] : k; }
    // Where an element is among them, or count() where it is not.
    size_t find(size_t element) const
    {
        if (!list_) return element;
        const auto found = std::lower_bound(list_->begin(), list_->end(), element);
        return found != list_->end() && *found == element ? static_cast<size_t>(found - list_->begin()) : count_;
    }

private:
    size_t count_;
    const std::vector<uint32_t>* list_ = nullptr;
};

// Calls take(k, place, bytes) for each component of the k-th row: first those of the view, then sparse ones.
template <class Take>
void for_each_component(const GltfModel& model, const GltfAccessor& accessor, const Rows& rows, size_t width,
                        const Take& take)
{
    const auto take_row = [&](size_t k, const char* bytes) {
        for (size_t c = 0; c < width; ++c) take(k, c, bytes + c * bytes_of(accessor.run.component));
    };
    if (accessor.run.view != kNoIndex) {
        const Elements elements = elements_of(model, accessor.run, accessor.width);
        for (size_t k = 0; k < rows.count(); ++k) take_row(k, elements.at(rows.at(k)));
    }
    if (!accessor.sparse_indices) return;
    const Elements places = elements_of(model, *accessor.sparse_indices, 1);
    const Elements values = elements_of(model, accessor.sparse_values, accessor.width);
    for (size_t k = 0; k < accessor.sparse_indices->count; ++k) {
        const double place = component_at(places.at(k), accessor.sparse_indices->component, false);
        if (!(place >= 0 && place < static_cast<double>(accessor.run.count)))
            fail_gltf(model, "a sparse accessor replaces an element that it does not have; export the file again");
        const size_t row = rows.find(static_cast<size_t>(place));
        if (row < rows.count()) take_row(row, values.at(k));
    }
}

const GltfAccessor& checked(const GltfModel& model, int32_t index)
{
    const GltfAccessor& accessor = element_of(model, model.accessors, index, "accessor");
    if (accessor.run.view == kNoIndex)
        check_zeros(model, accessor);
    else
        elements_of(model, accessor.run, accessor.width);
    return accessor;
}

}  // namespace

size_t count_of(const GltfModel& model, int32_t index)
{
    return checked(model, index).run.count;
}

std::vector<float> floats_of(const GltfModel& model, int32_t index, size_t width, const std::vector<uint32_t>& rows)
{
    const GltfAccessor& accessor = checked(model, index);
    const size_t given = std::min<size_t>(width, accessor.width);
    std::vector<float> result(rows.size() * width, 0.0f);
    for (size_t k = 0; k < rows.size(); ++k) std::fill_n(&result[k * width] + given, width - given, 1.0f);
    for_each_component(model, accessor, Rows(rows), given, [&](size_t k, size_t c, const char* bytes) {
        const double value = component_at(bytes, accessor.run.component, accessor.normalized);
        if (!std::isfinite(value))
            fail_gltf(model, "accessor " + std::to_string(index) +
                                 " holds a number that is not finite; repair the mesh and export it again");
        result[k * width + c] = static_cast<float>(value);
    });
    return result;
}

std::vector<uint32_t> indices_of(const GltfModel& model, int32_t index)
{
    const GltfAccessor& accessor = checked(model, index);
    if (accessor.run.component == kFloat32)
        fail_gltf(model, "accessor " + std::to_string(index) + " of indices holds fractions; export the file again");
    std::vector<uint32_t> result(accessor.run.count, 0);
    for_each_component(model, accessor, Rows(accessor.run.count), 1, [&](size_t k, size_t, const char* bytes) {
        const double value = component_at(bytes, accessor.run.component, false);
        result[k] = value < 0 ? std::numeric_limits<uint32_t>::max() : static_cast<uint32_t>(value);
    });
    return result;
}

}  // namespace lumi::baker
