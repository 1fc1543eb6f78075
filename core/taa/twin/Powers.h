// Logarithms and powers that have the same bits on every CPU and GPU: only + − × ÷, floor and bits.
#pragma once

#include <type_traits>

namespace taa::twin {

/// log₂((1 + t)/(1 − t)), |t| ≤ 0.1716, within a relative 4·10⁻⁷.
template <typename Real>
Real log2OfRatio(Real t);
/// log₂ x of a positive normal x, within a relative 4·10⁻⁷, near 1 as well.
template <typename Real>
Real log2Of(Real x);
/// log₂(1 + x), x ≥ 0, within a relative 6·10⁻⁷, however small x is.
template <typename Real>
Real log2OfOnePlus(Real x);

/// 2^x within a relative 2·10⁻⁷; 0 below x = −126 and of NaN, 2¹²⁷ above 127.
template <typename Real>
Real exp2Of(Real x);
/// 2^x − 1, however small x is; for positive x within a relative 4·10⁻⁷.
template <typename Real>
Real exp2LessOne(Real x);

/// x^e; 0 where x is below 10⁻³⁷ or NaN. Within a relative 2·10⁻⁷ + 3.3·10⁻⁷·|e log₂ x|.
template <typename Real>
Real power(Real x, std::type_identity_t<Real> e);

} // namespace taa::twin
