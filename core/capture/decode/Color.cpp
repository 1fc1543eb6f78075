#include "core/capture/decode/Color.h"

#include "core/base/Error.h"
#include "core/base/Light.h"
#include "core/base/Say.h"
#include "core/capture/decode/Rows.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace taa::capture {

namespace {

/// srgbDecoded() at k / 65535, for 8 and 16 bits and what lies between, which is right to 10⁻¹⁰.
constexpr std::size_t kSteps = 65535;
const std::vector<double>& linearTable() {
  static const std::vector<double> kTable = [] {
    std::vector<double> table(kSteps + 1);
    for (std::size_t i = 0; i <= kSteps; ++i) table[i] = srgbDecoded(static_cast<double>(i) / kSteps);
    return table;
  }();
  return kTable;
}

double fastLinearOf(double encoded, const double* table) {
  // Written so that NaN takes the slow way.
  if (!(encoded >= 0.0 && encoded < 1.0)) return srgbDecoded(encoded);
  const double place = encoded * static_cast<double>(kSteps);
  const auto step = static_cast<std::size_t>(place);
  return table[step] + (place - static_cast<double>(step)) * (table[step + 1] - table[step]);
}

/// Applies `value` to red, green and blue.
template <typename Value>
void forColors(Image& color, const Value& value) {
  forRows(color.height, color.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y) {
      float* row = color.at(0, y);
      for (int i = 0; i < 4 * color.width; i += 4)
        for (int channel = 0; channel < 3; ++channel)
          row[i + channel] = static_cast<float>(value(static_cast<double>(row[i + channel])));
    }
  });
}

} // namespace

bool isLinearInSteps(const Manifest& manifest, bool hasEightBits) {
  return hasEightBits && manifest.conventions.color.encoding == ColorEncoding::Linear;
}

std::string linearInSteps() {
  return say<
      "color is stored in 8 bits and stated as linear, which leaves few steps to what is dark: if it is "
      "too bright, it is encoded for a screen (color.encoding=srgb)">();
}

ColorDecoder::ColorDecoder(const Manifest& manifest, const CapturedFrame& frame, PlaneKind kind) {
  const PlaneSource* source = manifest.plane(frame, kind);
  const bool isDoneByFormat = source && source->raw == RawFormat::RGBA8_SRGB;
  isSrgb_ = manifest.conventions.color.encoding == ColorEncoding::Srgb && !isDoneByFormat;
  if (!manifest.conventions.color.preExposed) return;
  if (!(std::isfinite(frame.preExposure) && frame.preExposure > 0.0))
    throw Error(say<"frame %1: its preExposure is not above 0">(frame.number));
  exposure_ = frame.preExposure;
}

void ColorDecoder::decode(Image& color) const {
  const double scale = 1.0 / exposure_;
  if (isSrgb_) {
    const double* table = linearTable().data();
    forColors(color, [=](double value) { return fastLinearOf(value, table) * scale; });
  } else if (exposure_ != 1.0) {
    forColors(color, [=](double value) { return value * scale; });
  }
}

void ColorDecoder::encode(Image& color) const {
  const double scale = exposure_;
  if (isSrgb_)
    forColors(color, [=](double value) { return srgbEncoded(value * scale); });
  else if (scale != 1.0)
    forColors(color, [=](double value) { return value * scale; });
}

} // namespace taa::capture
