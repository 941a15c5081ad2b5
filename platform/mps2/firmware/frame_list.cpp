// SPDX-License-Identifier: MIT
#include "listed_frame.h"

namespace lumi::firmware
{
namespace
{

bool for_each_view(const Field& field, WriteText write)
{
    for (const View& view : kViews) {
        Camera camera;
        const CameraError error = make_camera(view.pose(), view.image(kWidth, kHeight), camera);
        if (error != CameraError::none) return refuse(write, describe(error));
        const auto write_frames = [&](auto texel) {
            return write_texel_frames<decltype(texel)>({view, camera, field, texel.kName, write});
        };
        if (!detail::with_texel(field.texel_format, write_frames)) return false;
    }
    return true;
}

}  // namespace

bool write_frame_crcs(const FieldBytes (&fields)[kListedFields], WriteText write)
{
    for (uint32_t k = 0; k < detail::format::kTexelFormats; ++k) {
        const FieldBytes& file = fields[k];
        Field field;
        const FieldError error = open_field(file.bytes, file.size, field);
        if (error != FieldError::none) return refuse(write, describe(error));
        if (!for_each_view(field, write)) return false;
    }
    return write_surface_crcs(fields[detail::format::kTexelFormats], "surface", write) &&
           write_surface_crcs(fields[detail::format::kTexelFormats + 1], "sheet", write);
}

}  // namespace lumi::firmware
