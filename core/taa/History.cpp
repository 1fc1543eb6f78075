#include "core/taa/History.h"

#include "core/taa/Intermediates.h"

#include <algorithm>
#include <utility>

namespace taa {

namespace {

constexpr HistoryLayer kLayers[] = {
    {"object", "vec2", gl::Format::RG32F, &History::object,
     [](const Settings& s) { return isOn(s.validate.object) || isOn(s.validate.objectClass); }},
    {"normal", "vec4", gl::Format::RGBA16F, &History::normal,
     [](const Settings& s) { return isOn(s.validate.normal); }},
    {"motion", "vec2", gl::Format::RG32F, &History::motion,
     [](const Settings& s) {
       return s.validate.velocity != VelocityTest::None || isOn(s.weight.velocityChange) || tellsRest(s);
     }},
    {"lock", "vec2", gl::Format::RG32F, &History::lock,
     [](const Settings& s) { return isOn(s.rectify.locks); }},
    {"lumas", "vec4", gl::Format::RGBA8, &History::lumas,
     [](const Settings& s) { return isOn(s.rectify.instability); }},
};

// Cleared, because what memory held before must never show.
gl::Texture cleared(const gl::TextureSize& size, gl::Format format, const std::string& label) {
  gl::Texture texture(size, format, label);
  texture.clear(0.0f, 0.0f, 0.0f, 0.0f);
  return texture;
}

gl::Format colorFormat(const Settings& settings) {
  return settings.history.precision == Precision::Half ? gl::Format::RGBA16F : gl::Format::RGBA32F;
}

constexpr gl::Format kSurfaceFormat = gl::Format::RG32F;

bool fits(const gl::Texture& texture, const gl::TextureSize& size, gl::Format format) {
  return texture && texture.size() == size && texture.format() == format;
}

} // namespace

std::size_t History::bytes() const {
  std::size_t sum = color.bytes() + surface.bytes() + (stale ? stale.bytes() : 0);
  for (const HistoryLayer& layer : kLayers)
    if (const gl::Texture& texture = this->*layer.texture) sum += texture.bytes();
  return sum;
}

std::span<const HistoryLayer> historyLayers() {
  return kLayers;
}

std::size_t historyBytes(int width, int height, const Settings& settings) {
  const gl::TextureSize size{width, height};
  std::size_t sum = gl::textureBytes(size, colorFormat(settings)) + gl::textureBytes(size, kSurfaceFormat);
  if (isOn(settings.fault.notSwapped)) sum += gl::textureBytes(size, colorFormat(settings));
  for (const HistoryLayer& layer : kLayers)
    if (layer.isNeeded(settings)) sum += gl::textureBytes(size, layer.format);
  return sum;
}

std::size_t historyTargets(const Settings& settings) {
  return kHistoryTargets + static_cast<std::size_t>(std::ranges::count_if(
                               kLayers, [&](const HistoryLayer& layer) { return layer.isNeeded(settings); }));
}

std::string historyPrelude(const Settings& settings, bool keepsHistory) {
  std::string text = keepsHistory ? "layout(location = 0) out vec4 o_color;\n"
                                    "layout(location = 1) out vec2 o_surface;\n"
                                  : "vec4 o_color;\nvec2 o_surface;\n";
  std::size_t target = kHistoryTargets;
  for (std::size_t index = 0; index < std::size(kLayers); ++index) {
    const HistoryLayer& layer = kLayers[index];
    const std::string name(layer.name), keep = "#define keep_" + name + "(value)";
    text += "const int kLayer_" + name + " = " + std::to_string(2 << index) + ";\n";
    if (!keepsHistory || !layer.isNeeded(settings)) {
      text += keep + "\n";
      continue;
    }
    text += "layout(location = " + std::to_string(target++) + ") out " + std::string(layer.type) +
            " o_kept_" + name + ";\n" + keep + " o_kept_" + name + " = (value)\n";
  }
  return text;
}

void fitHistory(History& history, int width, int height, const Settings& settings) {
  const gl::Format format = colorFormat(settings);
  const gl::TextureSize size{width, height};
  if (!fits(history.color, size, format)) {
    gl::Texture color = cleared(size, format, "history color");
    history.surface = cleared(size, kSurfaceFormat, "history surface");
    history.color = std::move(color);
  }
  if (!isOn(settings.fault.notSwapped))
    history.stale = gl::Texture();
  else if (!fits(history.stale, size, format))
    history.stale = cleared(size, format, "stale history color");
  for (const HistoryLayer& layer : kLayers) {
    gl::Texture& texture = history.*layer.texture;
    if (!layer.isNeeded(settings))
      texture = gl::Texture();
    else if (!fits(texture, size, layer.format))
      texture = cleared(size, layer.format, "history " + std::string(layer.name));
  }
}

} // namespace taa
