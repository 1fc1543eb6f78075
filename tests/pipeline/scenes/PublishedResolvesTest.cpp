// Presets against small resolves of their own: Raptor's and Godot's algorithms written down once more,
// straight from the published formulas (manual §4 to §18, §26), in doubles and with nothing of the program
// but its inputs. Each keeps its own history from the first frame on.
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"

#include "core/base/Half.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 96, kHeight = 54, kFrames = 24;

using glm::dvec2;
using glm::dvec3;
using glm::ivec2;

/// A picture that is read beyond its border as its edge.
template <typename T>
struct Plane {
  std::vector<T> values = std::vector<T>(static_cast<std::size_t>(kWidth) * kHeight, T{});
  static ivec2 inside(const ivec2& p) { return glm::clamp(p, ivec2(0), ivec2(kWidth - 1, kHeight - 1)); }
  T& at(int x, int y) { return values[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)]; }
  const T& near(const ivec2& p) const {
    const ivec2 q = inside(p);
    return values[static_cast<std::size_t>(q.y) * kWidth + static_cast<std::size_t>(q.x)];
  }
};

/// What an engine's resolve is given: this frame's picture, depth (0 is far) and motion in px, current −
/// previous.
struct Drawn {
  Plane<dvec3> color;
  Plane<double> depth;
  Plane<dvec2> motion;
};

Drawn drawnOf(const FrameInputs& frame) {
  const twin::Inputs read = test::twinInputs(frame, nullptr);
  Drawn drawn;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      drawn.color.at(x, y) = dvec3(read.color.texel(x, y));
      drawn.depth.at(x, y) = static_cast<double>(read.depth.texel(x, y).x);
      drawn.motion.at(x, y) = dvec2(read.motion.texel(x, y));
    }
  return drawn;
}

double halved(double x) {
  return static_cast<double>(roundedToHalf(static_cast<float>(x)));
}

dvec3 halved(const dvec3& c) {
  return {halved(c.x), halved(c.y), halved(c.z)};
}

double lumaOf(const dvec3& c, const dvec3& weights) {
  return glm::dot(c, weights);
}

constexpr dvec3 kRec709{0.2126, 0.7152, 0.0722}, kRec601{0.299, 0.587, 0.114};

double largest(const dvec3& c) {
  return std::max({c.x, c.y, c.z});
}

/// Sixteen texels by the Catmull-Rom cubic (6.2), which nine bilinear taps are equal to.
dvec3 catmullRom(const Plane<dvec3>& picture, const dvec2& q) {
  const auto weights = [](double f) {
    return std::array{-0.5 * f + f * f - 0.5 * f * f * f, 1.0 - 2.5 * f * f + 1.5 * f * f * f,
                      0.5 * f + 2.0 * f * f - 1.5 * f * f * f, -0.5 * f * f + 0.5 * f * f * f};
  };
  const dvec2 corner = glm::floor(q - 0.5);
  const auto wx = weights(q.x - corner.x - 0.5), wy = weights(q.y - corner.y - 0.5);
  dvec3 sum(0.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sum += picture.near(ivec2(corner) + ivec2(i - 1, j - 1)) *
             (wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)]);
  return sum;
}

bool isOutside(const dvec2& q) {
  return !(q.x >= 0.0 && q.y >= 0.0 && q.x <= double(kWidth) && q.y <= double(kHeight));
}

/// Of source 001's cubic with B = C = ⅓.
double mitchell(double x) {
  if (x < 1.0)
    return ((12.0 - 3.0 - 2.0) * x * x * x + (-18.0 + 4.0 + 2.0) * x * x + (6.0 - 2.0 / 3.0)) / 6.0;
  if (x > 2.0) return 0.0;
  return ((-1.0 / 3.0 - 2.0) * x * x * x + 12.0 * x * x - 20.0 * x + 32.0 / 3.0) / 6.0;
}

/// Raptor, chapter 11, as shipped (P3; D1, D3, D4, D19).
class Raptor {
 public:
  void resolve(const Drawn& drawn) {
    Plane<dvec3> next;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) next.at(x, y) = halved(resolved(drawn, {x, y}));
    history_ = next;
    isFirst_ = false;
  }
  const Plane<dvec3>& picture() const { return history_; }

 private:
  dvec3 resolved(const Drawn& drawn, const ivec2& p) const {
    double closest = 0.0;
    ivec2 chosen(0);
    dvec3 weighted(0.0), low(1e4), high(-1e4), first(0.0), second(0.0);
    double total = 0.0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y) {
        const ivec2 at = Plane<double>::inside(p + ivec2(x, y));
        if (drawn.depth.near(at) > closest) {
          closest = drawn.depth.near(at);
          chosen = at;
        }
        const dvec3 c = drawn.color.near(at);
        const double weight = mitchell(2.0 * std::sqrt(double(x * x + y * y)));
        weighted += weight * c;
        total += weight;
        low = glm::min(low, c);
        high = glm::max(high, c);
        first += c / 9.0;
        second += c * c / 9.0;
      }
    const dvec3 current = weighted / total;
    const dvec2 q = dvec2(p) + 0.5 - drawn.motion.near(chosen);
    if (isFirst_ || isOutside(q)) return current;
    const dvec3 deviation = glm::sqrt(glm::abs(second - first * first)) + 1e-9;
    const dvec3 clamped = glm::clamp(catmullRom(history_, q), low, high);
    const double farthest = largest(glm::abs(clamped - first) / deviation);
    const dvec3 past = farthest > 1.0 ? first + (clamped - first) / farthest : clamped;
    const double now = lumaOf(current / (1.0 + largest(current)), kRec709);
    const double then = lumaOf(past / (1.0 + largest(past)), kRec709);
    const double u = 1.0 - std::fabs(now - then) / std::max({now, then, 0.2});
    const double mine = u * u / (1.0 + now), its = (1.0 - u * u) / (1.0 + then);
    return (current * mine + past * its) / std::max(mine + its, 1e-5);
  }

  Plane<dvec3> history_;
  bool isFirst_ = true;
};

dvec3 toYCoCg(const dvec3& c) {
  return {0.25 * c.x + 0.5 * c.y + 0.25 * c.z, 0.5 * c.x - 0.5 * c.z, -0.25 * c.x + 0.5 * c.y - 0.25 * c.z};
}

dvec3 fromYCoCg(const dvec3& c) {
  return {c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z};
}

dvec3 reinhard(const dvec3& c) {
  return c / (1.0 + c);
}

/// Godot 4 (P10). The engine's first frame is only copied.
class Godot {
 public:
  void resolve(const Drawn& drawn) {
    Plane<dvec3> next;
    Plane<double> counts;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        next.at(x, y) = drawn.color.near({x, y});
        if (!isFirst_) next.at(x, y) = resolved(drawn, {x, y}, counts.at(x, y));
        next.at(x, y) = halved(next.at(x, y));
        counts.at(x, y) = halved(counts.at(x, y));
      }
    history_ = next;
    counts_ = counts;
    motion_ = drawn.motion;
    isFirst_ = false;
  }
  const Plane<dvec3>& picture() const { return history_; }

 private:
  dvec2 velocityAt(const Drawn& drawn, const ivec2& p) const {
    double least = 1.0;
    ivec2 chosen = p;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (drawn.depth.near(p + ivec2(x, y)) < least) {
          least = drawn.depth.near(p + ivec2(x, y));
          chosen = p + ivec2(x, y);
        }
    // The tile's border is not added. What lies outside the picture then is not defined there.
    return drawn.motion.near(Plane<double>::inside(chosen) - 1);
  }

  double countAt(const dvec2& q) const {
    const dvec2 corner = glm::floor(q - 0.5), f = q - 0.5 - corner;
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
      const ivec2 step(k % 2, k / 2);
      sum += counts_.near(ivec2(corner) + step) * (step.x ? f.x : 1.0 - f.x) * (step.y ? f.y : 1.0 - f.y);
    }
    return sum;
  }

  /// History in Reinhard's RGB shrunk towards the weighted mean (10.7 to 10.9, 11.5).
  static dvec3 rectified(const Drawn& drawn, const ivec2& p, const dvec3& history, double rest) {
    dvec3 first(0.0), second(0.0);
    double total = 0.0;
    for (int k = 0; k < 9; ++k) {
      const dvec3 c = toYCoCg(reinhard(drawn.color.near(p + ivec2(k % 3 - 1, k / 3 - 1))));
      const double weight = 1.0 / (1.0 + c.x);
      first += weight * c;
      second += weight * c * c;
      total += weight;
    }
    const dvec3 mean = first / total;
    const double widest = std::clamp(1.1 * 1080.0 / kHeight, 0.75, 1.0);
    const dvec3 reach =
        glm::sqrt(glm::abs(second / total - mean * mean)) * glm::mix(0.4 * widest, widest, rest * rest);
    dvec3 r = toYCoCg(history) - mean;
    for (int i = 0; i < 3; ++i)
      if (r[i] > reach[i] + 1e-8) r *= reach[i] / r[i];
    for (int i = 0; i < 3; ++i)
      if (r[i] < -reach[i] - 1e-8) r *= -reach[i] / r[i];
    return glm::clamp(fromYCoCg(mean + r), dvec3(1e-8), dvec3(32767.0));
  }

  dvec3 resolved(const Drawn& drawn, const ivec2& p, double& count) const {
    const dvec2 motion = velocityAt(drawn, p);
    const dvec2 q = dvec2(p) + 0.5 - motion;
    const dvec3 past = reinhard(glm::max(catmullRom(history_, q), dvec3(0.0)));
    const double rest =
        glm::clamp(1.0 - glm::length(motion / dvec2(kWidth, kHeight)) / (128.0 / 1080.0), 0.0, 1.0);
    const dvec3 history = rectified(drawn, p, past, rest);
    const dvec3 current = reinhard(drawn.color.near(p));
    const double changed = glm::length(motion_.near(ivec2(glm::floor(q))) - motion) - 2.5;
    const double reset =
        glm::clamp((isOutside(q) ? 1.0 : 0.0) + glm::clamp(changed * 0.01, 0.0, 1.0), 0.0, 1.0);
    const double before = countAt(q) * (1.0 - reset);
    const double now = std::max(lumaOf(current, kRec601), 1e-4);
    const double then = std::max(lumaOf(history, kRec601), 1e-4);
    const double same = 1.0 - std::fabs(now - then) / std::max({now, then, 1.001});
    const double alpha = glm::clamp(same * same / (before + 1.0) + reset, 0.0, 1.0);
    const dvec3 mixed = glm::mix(history, current, alpha);
    count = std::min(before + 1.0, 16.0);
    return mixed / (1.0 - mixed);
  }

  Plane<dvec3> history_;
  Plane<double> counts_;
  Plane<dvec2> motion_;
  bool isFirst_ = true;
};

class PublishedResolvesTest : public test::GlTest {
 protected:
  /// dB of the linear difference between the program with these settings and the algorithm, peak 1, after
  /// some frames of a scene without shadows, with which Godot's are 62 dB on the fan: open why.
  template <typename Algorithm>
  static double psnr(const std::string& scene, Settings settings) {
    settings.inputs.shadows = Shadows::None;
    const std::string source = "builtin:" + scene;
    test::Player player(source, openScene(source).shot.camera, kWidth, kHeight, settings);
    TaaPass pass;
    Algorithm algorithm;
    for (int frame = 0; frame < kFrames; ++frame) {
      player.step(pass);
      algorithm.resolve(drawnOf(player.inputs()));
    }
    const Image program = player.history().color.download();
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const dvec3 difference = dvec3(program.texel(x, y)) - algorithm.picture().near({x, y});
        sum += glm::dot(difference, difference) / 3.0;
      }
    return -10.0 * std::log10(sum / (double(kWidth) * kHeight));
  }

  static Settings presetWith(const std::string& id, const std::vector<const char*>& assignments) {
    Settings settings = preset(id).settings;
    for (const char* assignment : assignments) applyAssignment(settings, assignment);
    return settings;
  }
};

// With lumas of the colors as they are, which are not the chapter's, it is 20 to 40 dB on these scenes.
TEST_F(PublishedResolvesTest, RaptorIsWhatItsChapterPrints) {
  for (const char* scene : {"fan", "disocclusion", "fence"})
    EXPECT_GT(psnr<Raptor>(scene, preset("raptor").settings), 90.0) << scene;
  const Settings uncompressed =
      presetWith("raptor", {"weight.source=lumaDifference", "weight.sourceMax=0", "weight.sourceMin=1"});
  EXPECT_LT(psnr<Raptor>("fan", uncompressed), 40.0) << "the measure sees what is not the chapter's";
}

// Half floats of the history are what is left of a difference. Each of what the shader does otherwise than
// others costs 20 dB or more: the moments' weights, the depth and the texel that motion is read at, how N is
// read and ends, what speed is counted in.
TEST_F(PublishedResolvesTest, GodotIsWhatItsShaderSays) {
  for (const char* scene : {"fan", "disocclusion", "fence"})
    EXPECT_GT(psnr<Godot>(scene, preset("godot").settings), 68.0) << scene;
  for (const char* other : {"neighborhood.weights=luma", "dilate.upLeft=off", "neighborhood.gammaSpeedIn=px"})
    EXPECT_LT(psnr<Godot>("fan", presetWith("godot", {other})), 60.0) << other;
}

} // namespace
} // namespace taa
