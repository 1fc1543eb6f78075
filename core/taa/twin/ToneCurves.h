// Curves that compress a channel, and back (manual §15); c: scene-linear, 0 to 65504.
#pragma once

namespace taa::twin {

/// SMPTE ST 2084 with 10000 as 1 (15.5), and beyond: 65504 is 1.19.
template <typename Real = float>
Real pq(Real c);
template <typename Real = float>
Real inversePq(Real y);

/// log₂(1 + c) (15.7).
template <typename Real = float>
Real logarithm(Real c);
template <typename Real = float>
Real inverseLogarithm(Real y);

/// The curve of sRGB, IEC 61966-2-1, on beyond 1 (9.4); back: in proportion below 0.
template <typename Real = float>
Real gammaEncoded(Real c);
template <typename Real = float>
Real gammaDecoded(Real y);

/// c(1 + c/W²)/(1 + c), 1 at W (15.6).
template <typename Real = float>
Real whitePoint(Real c, Real white);
template <typename Real = float>
Real inverseWhitePoint(Real y, Real white);

} // namespace taa::twin
