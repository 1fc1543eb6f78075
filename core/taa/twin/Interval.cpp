#include "core/taa/twin/Interval.h"

#include <array>

namespace taa::twin {

namespace {

thread_local Observation* presentObservation = nullptr;

// By how many ulp of the exact result a driver may miss it.
constexpr double kDivision = 2.5, kRoot = 4.5;

/// The floats that are no farther from exact results of low to high than `units` ulp.
Interval within(float value, double low, double high, double units) {
  const double least = low - units * unitInLastPlace(low), most = high + units * unitInLastPlace(high);
  auto first = static_cast<float>(least), last = static_cast<float>(most);
  if (static_cast<double>(first) < least) first = std::nextafter(first, Interval::kInfinity);
  if (static_cast<double>(last) > most) last = std::nextafter(last, -Interval::kInfinity);
  return Interval::made(value, first, last);
}

/// Of four, NaN where one is.
template <typename Real>
std::array<Real, 2> rangeOf(const std::array<Real, 4>& ends) {
  std::array<Real, 2> range{ends[0], ends[0]};
  for (const Real end : ends) {
    if (std::isnan(end)) return {end, end};
    range[0] = end < range[0] ? end : range[0];
    range[1] = end > range[1] ? end : range[1];
  }
  return range;
}

bool isNothing(const Interval& x) {
  return x.low == 0.0f && x.high == 0.0f;
}

} // namespace

std::uint32_t Interval::newOrigin() {
  static thread_local std::uint32_t last = 0;
  if (++last == 0) ++last; // where it begins anew nothing that old is left
  return last;
}

double unitInLastPlace(double x) {
  int exponent = 0;
  std::frexp(x, &exponent); // ½ to 1
  return std::ldexp(1.0, std::max(exponent, std::numeric_limits<float>::min_exponent) -
                             std::numeric_limits<float>::digits);
}

Interval operator*(const Interval& a, const Interval& b) {
  const float value = a.value * b.value;
  if (a.isPoint() && b.isPoint()) return Interval::made(value, value, value);
  if (a.isSame(b)) { // is not negative
    const float least = a.low * a.low, most = a.high * a.high;
    const bool holdsNothing = a.low <= 0.0f && a.high >= 0.0f;
    return Interval::made(value, holdsNothing ? 0.0f : std::min(least, most), std::max(least, most));
  }
  const auto [low, high] =
      rangeOf(std::array{a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return Interval::made(value, low, high);
}

Interval operator/(const Interval& a, const Interval& b) {
  const float value = a.value / b.value;
  if (a.isNan() || b.isNan()) return Interval::made(value, a.low + b.low, a.high + b.high);
  constexpr float kLargest = 0x1p126f; // beyond, and below its inverse, nothing is promised
  const bool isPositive = b.low >= 1.0f / kLargest && b.high <= kLargest;
  const bool isNegative = b.high <= -1.0f / kLargest && b.low >= -kLargest;
  if (!isPositive && !isNegative) return Interval::anything(value);
  if (isNothing(a)) return {value, a.low, a.high};
  const double aLow = a.low, aHigh = a.high, bLow = b.low, bHigh = b.high;
  const auto [low, high] = rangeOf(std::array{aLow / bLow, aLow / bHigh, aHigh / bLow, aHigh / bHigh});
  return within(value, low, high, kDivision);
}

bool chosen(bool likely) {
  Observation* present = presentObservation;
  if (!present) return likely;
  const std::size_t place = present->decisions_.size();
  const bool is = place < present->script_.size() ? present->script_[place] : likely;
  present->decisions_.push_back({is, present->compared_.size()});
  return is;
}

bool operator<(const Interval& a, const Interval& b) {
  if (a.isNan() || b.isNan() || a.isSame(b)) return false;
  const bool mayBeNan = a.isAnything() || b.isAnything();
  if (a.high < b.low && !mayBeNan) return true;
  if (a.low >= b.high && !mayBeNan) return false;
  return chosen(a.value < b.value);
}

bool operator<=(const Interval& a, const Interval& b) {
  if (a.isSame(b)) return true;
  if (a.isNan() || b.isNan()) return false;
  const bool mayBeNan = a.isAnything() || b.isAnything();
  if (a.high <= b.low && !mayBeNan) return true;
  if (a.low > b.high && !mayBeNan) return false;
  return chosen(a.value <= b.value);
}

bool operator==(const Interval& a, const Interval& b) {
  if (a.isSame(b)) return true;
  if (a.isNan() || b.isNan()) return false;
  if (a.low == a.high && b.low == b.high) return a.low == b.low;
  if (a.high < b.low || b.high < a.low) return false;
  return chosen(a.value == b.value);
}

Interval sqrt(const Interval& x) {
  const float value = std::sqrt(x.value);
  if (x.isNan()) return {value, x.low, x.high};
  if (x.isAnything() || x.high < 0.0f) return Interval::anything(value);
  // What was squared is not negative, though its range may be.
  if (x.high == 0.0f) return {value, 0.0f, 0.0f};
  Interval root = within(value, std::sqrt(std::max(static_cast<double>(x.low), 0.0)),
                         std::sqrt(static_cast<double>(x.high)), kRoot);
  if (x.low <= 0.0f) root.low = 0.0f;
  return root;
}

Interval fabs(const Interval& x) {
  const float value = std::fabs(x.value);
  if (x.isAnything()) return Interval::anything(value);
  if (x.low > 0.0f) return x; // −0 is not itself
  if (x.low >= 0.0f) return {value, x.low, x.high};
  if (x.high <= 0.0f) return {value, -x.high, -x.low};
  return Interval::made(value, 0.0f, -x.low > x.high ? -x.low : x.high);
}

Interval floor(const Interval& x) {
  const float value = std::floor(x.value);
  if (x.isNan()) return x;
  const float low = std::floor(x.low), high = std::floor(x.high);
  if (low == high) return low;
  if (high - low > 1.0f) return Interval::anything(value);
  return chosen(value == low) ? low : high;
}

bool isnan(const Interval& x) {
  if (!x.isAnything()) return x.isNan();
  return chosen(std::isnan(x.value));
}

Interval quantized(const Interval& x, float steps, float u) {
  return roundedBy(x, [&](float v) { return std::floor(v * steps + u); }) / Interval(steps);
}

Interval minimum(const Interval& a, const Interval& b) {
  const float value = minimum(a.value, b.value);
  if (a.isNan()) return {value, b.low, b.high};
  if (b.isNan() || b.isAnything()) return {value, b.low, b.high};
  if (!a.isAnything() && a.high < b.low) return a;
  if (!a.isAnything() && b.high < a.low) return b;
  return {value, minimum(a.low, b.low), minimum(a.high, b.high)};
}

Interval maximum(const Interval& a, const Interval& b) {
  const float value = maximum(a.value, b.value);
  if (a.isNan()) return {value, b.low, b.high};
  if (b.isNan() || b.isAnything()) return {value, b.low, b.high};
  if (!a.isAnything() && a.low > b.high) return a;
  if (!a.isAnything() && b.low > a.high) return b;
  return {value, maximum(a.low, b.low), maximum(a.high, b.high)};
}

Interval bounded(const Interval& value, const Interval& low, const Interval& high) {
  const float bound = bounded(value.value, low.value, high.value);
  if (value.isNan() || value.isAnything()) return {bound, value.low, value.high}; // NaN goes through
  const auto lower = [](float x, float wall) { return x < wall ? wall : x; };
  const auto upper = [](float x, float wall) { return x > wall ? wall : x; };
  if (low.isNan() || high.isNan() || low.isAnything() || high.isAnything()) return Interval::anything(bound);
  if (value.low >= low.high && value.high <= high.low) return value;
  return {bound, upper(lower(value.low, low.low), high.low), upper(lower(value.high, low.high), high.high)};
}

Interval saturated(const Interval& x) {
  if (x.low > 0.0f && x.high <= 1.0f) return x;
  const auto ends = [](float end) { return saturated(end); };
  return {ends(x.value), ends(x.low), ends(x.high)};
}

Observation::Observation(const PixelRecord& found, const std::bitset<kIntermediateCount>& rows,
                         std::vector<bool> script)
    : found_(found), rows_(rows), script_(std::move(script)),
      before_(std::exchange(presentObservation, this)) {}

Observation::~Observation() {
  presentObservation = before_;
}

void observe(IntermediateId id, Interval& value, int channel) {
  Observation* present = presentObservation;
  const auto row = static_cast<std::size_t>(id);
  if (!present || !present->rows_[row]) return;
  const float found = present->found_[row][channel];
  const std::size_t place = 4 * row + static_cast<std::size_t>(channel);
  if (!present->done_[place]) present->compared_.push_back({id, channel, found, value});
  present->done_.set(place);
  value = Interval::made(found, found, found);
}

} // namespace taa::twin
