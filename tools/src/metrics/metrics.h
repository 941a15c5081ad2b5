// SPDX-License-Identifier: MIT
// Compares two pictures of one size.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// The peak signal-to-noise ratio: 10·log10(255² / mean squared error over all three channels) in dB; infinity for
// identical pictures. Precondition: same_size(a, b), at least one pixel.
double psnr_db(const Picture& a, const Picture& b);

// Counts only the pixels where the mask is not zero. Precondition: it has the pictures' size and such a pixel.
double psnr_db(const Picture& a, const Picture& b, const Mask& mask);

// |a - b| per channel times kErrorGain, clamped: black where equal, brighter where worse.
// Precondition: same_size(a, b).
inline constexpr int kErrorGain = 4;
Picture error_picture(const Picture& a, const Picture& b);

// The side of SSIM's window; smaller pictures have no SSIM.
inline constexpr int kSsimWindow = 11;

// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE TIP 13(4), 2004. The mean of the SSIM map of the luma: 11×11 Gaussian window of sigma
// 1.5, K1 = 0.01, K2 = 0.03, dynamic range 255, no downsampling. Only windows that lie wholly inside count (the "valid"
// region); nothing is padded. Precondition: same_size(a, b), both sides at least kSsimWindow.
double ssim(const Picture& a, const Picture& b);

// The mean over the windows whose middle pixel is not zero in the mask; 1 if there is none.
double ssim(const Picture& a, const Picture& b, const Mask& mask);

inline constexpr int kCwSsimWindow = 7;
inline constexpr int kCwSsimMaxLevels = 6;

// Complex wavelet structural similarity: Sampat, Wang, Gupta, Bovik, Markey, "Complex Wavelet Structural Similarity: A
// New Image Similarity Index", IEEE TIP 18(11), 2009. Small shifts and turns rotate the phases of neighbouring
// coefficients alike and hardly lower it; noise, blur and false structure scramble them.
//
// Over each 7×7 window of each band of the luma's steerable pyramid (16 orientations):
//     (2·|mean(a·conj b)| + K) / (mean|a|² + mean|b|² + K)
// averaged over all windows wholly inside a band, then over all bands. Levels: 6, or as many as have room for a window.
// K = 1 squared grey level: what differs by less than one step of an 8-bit picture, flat backgrounds above all, counts
// as alike instead of dividing rounding noise by rounding noise.
// Precondition: same_size(a, b), both sides at least kCwSsimWindow.
double cw_ssim(const Picture& a, const Picture& b);

// The paper of FLIP has so many pixels a degree of the observer's view: a screen 0.7 m wide with 3840 pixels, seen from
// 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0206;

// FLIP: what an observer notices who flips between two pictures. Andersson, Nilsson, Akenine-Möller, Oskarsson,
// Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM CGIT 3(2), 2020: the version for
// low dynamic range, written from its formulas. The error of every pixel, 0 (alike) to 1; pixels beyond a border are
// those at it. Precondition: same_size(a, b), at least one pixel, pixels_per_degree > 0.
Plane<double> flip_map(const Picture& reference, const Picture& test, double pixels_per_degree = kFlipPixelsPerDegree);

// The mean of the map.
double flip(const Picture& reference, const Picture& test, double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace lumi::tools
