// SPDX-License-Identifier: MIT
#include "texel_frames.h"

namespace lumi::firmware
{
namespace
{

bool for_the_field(const Field& field, const View& view, const Camera& camera, WriteText write)
{
    switch (field.texel_format) {
        case format::TexelFormat::rgb888:
            return write_texel_frames<TexelRgb888>({view, camera, field, "rgb888", write});
        case format::TexelFormat::rgb565:
            return write_texel_frames<TexelRgb565>({view, camera, field, "rgb565", write});
        case format::TexelFormat::palette8:
            return write_texel_frames<TexelPalette8>({view, camera, field, "palette8", write});
        case format::TexelFormat::luma8:
            return write_texel_frames<TexelLuma8>({view, camera, field, "luma8", write});
    }
    return false;
}

bool for_each_view(const Field& field, WriteText write)
{
    for (const View& view : kViews) {
        Camera camera;
        const CameraError error = make_camera(view.pose(), view.image(kWidth, kHeight), camera);
        if (error != CameraError::none) {
            return refuse(write, describe(error));
        }
        if (!for_the_field(field, view, camera, write)) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool write_frame_crcs(const FieldBytes (&fields)[kListedFields], WriteText write)
{
    for (uint32_t k = 0; k < format::kTexelFormats; ++k) {
        const FieldBytes& file = fields[k];
        Field field;
        const FieldError error = open_field(file.bytes, file.size, field);
        if (error != FieldError::none) {
            return refuse(write, describe(error));
        }
        if (!for_each_view(field, write)) {
            return false;
        }
    }
    return write_surface_crcs(fields[format::kTexelFormats], "surface", write) &&
           write_surface_crcs(fields[format::kTexelFormats + 1], "sheet", write);
}

}  // namespace lumi::firmware
