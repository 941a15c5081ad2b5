// SPDX-License-Identifier: MIT
// What every program of the size report calls besides render(): it opens a field and makes a camera. The field lies
// where the compiler cannot see it, so that nothing is computed in advance.
#pragma once

#include "lumi/camera.h"
#include "lumi/field.h"

namespace lumi::size
{

inline bool open(Field& field, Camera& camera)
{
    const uint8_t* volatile bytes = nullptr;
    volatile uint32_t size = 0;
    volatile uint32_t azimuth_turns32 = 0;
    constexpr uint32_t kFieldOfViewTurns32 = 0x20000000;
    return open_field(bytes, size, field) == FieldError::none &&
           make_camera(orbit(azimuth_turns32, 0, 3 * kOneQ20), {240, 240, kFieldOfViewTurns32}, camera) ==
               CameraError::none;
}

}  // namespace lumi::size
