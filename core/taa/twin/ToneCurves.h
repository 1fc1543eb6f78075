// Curves that compress a channel, and back (manual §15); c: scene-linear, 0 to 65504.
#pragma once

namespace taa::twin {

/// SMPTE ST 2084 with 10000 as 1 (15.5), and beyond: 65504 is 1.19.
float pq(float c);
float inversePq(float y);

/// log₂(1 + c) (15.7).
float logarithm(float c);
float inverseLogarithm(float y);

/// The curve of sRGB, IEC 61966-2-1, on beyond 1 (9.4); back: in proportion below 0.
float gammaEncoded(float c);
float gammaDecoded(float y);

/// c(1 + c/W²)/(1 + c), 1 at W (15.6).
float whitePoint(float c, float white);
float inverseWhitePoint(float y, float white);

} // namespace taa::twin
