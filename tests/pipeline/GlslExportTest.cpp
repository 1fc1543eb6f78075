// An exported resolve, compiled as it stands and bound by what its head says, gives the inspector's bits.
#include "core/taa/GlslExport.h"

#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/PassInputs.h"
#include "shaders/shared/ResolveBlock.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"
#include "tests/support/ResolveTest.h"

#include <cstring>
#include <map>

namespace taa {
namespace {

using test::FrameShape;

/// Somebody's engine: knows what the head of the file says, and nothing of the inspector's passes.
class Engine {
 public:
  explicit Engine(const std::string& text)
      : program_(gl::ShaderSource("include/fullscreen.vert"),
                 gl::ShaderSource::complete(text, "exported.frag"), "exported"),
        nearest_(gl::SamplerState{}), nothing_(gl::TextureSize{1, 1}, gl::Format::RGBA8, "nothing") {
    nothing_.clear(0.0f, 0.0f, 0.0f, 0.0f);
  }

  void resolve(const FrameInputs& inputs, const History* previous, const Settings& settings, History& out) {
    fitHistory(out, inputs.outputWidth(), inputs.outputHeight(), settings);
    std::vector<gl::Attachment> targets{{&out.color}, {&out.surface}};
    for (const HistoryLayer& layer : historyLayers())
      if (layer.isNeeded(settings)) targets.push_back({&(out.*layer.texture)});
    const gl::Buffer block = blockOf(inputs, previous, settings);
    const gl::Framebuffer target(targets, nullptr, "exported");
    gl::RenderPass pass(target, {}, "exported");
    pass.program(program_);
    pass.uniformBlock(0, block);
    bindTextures(pass, inputs, previous);
    pass.drawFullscreen();
  }

 private:
  void bindTextures(gl::RenderPass& pass, const FrameInputs& inputs, const History* previous) {
    const gl::Texture* textures[] = {&inputs.color,  &inputs.depth,    &inputs.motion,
                                     &inputs.normal, &inputs.objectId, &inputs.previousDepth};
    for (unsigned unit = 0; unit < 6; ++unit) pass.texture(unit, *textures[unit], nearest_);
    pass.texture(6, previous ? previous->color : inputs.color, nearest_);
    pass.texture(7, previous ? previous->surface : inputs.motion, nearest_);
    unsigned unit = 8;
    for (const HistoryLayer& layer : historyLayers()) {
      const bool isThere = previous && previous->*layer.texture;
      pass.texture(unit++, isThere ? previous->*layer.texture : nothing_, nearest_);
    }
    pass.texture(14, inputs.mask ? inputs.mask : nothing_, nearest_);
  }

  // By the names in the text: what a file does not need is not in its block.
  gl::Buffer blockOf(const FrameInputs& inputs, const History* previous, const Settings& settings) const {
    const glm::vec2 size(inputs.outputWidth(), inputs.outputHeight());
    const glm::vec2 drawn(inputs.width(), inputs.height()), ratio = drawn / size;
    const glm::vec2 jitter = inputs.info.jitterPx;
    const std::array<float, 9> w = currentFilterWeights(settings.current, jitter);
    const glm::vec4 rows[] = {{w[0], w[1], w[2], 0}, {w[3], w[4], w[5], 0}, {w[6], w[7], w[8], 0}};
    const float distance = sampleDistanceFactor(settings.weight.sampleDistance,
                                                isUpsampled(settings) ? glm::vec2(0.0f) : jitter);
    const int eighths = frameEighths(inputs.info.stepSeconds, settings.weight.referenceRate);
    const glm::vec4 terms(distance, static_cast<float>(eighths), 0.0f, 0.0f);
    glm::ivec4 state(previous ? 1 : 0, 0, 0, inputs.info.frame);
    int bit = 2;
    for (const HistoryLayer& layer : historyLayers()) {
      if (previous && previous->*layer.texture && layer.isNeeded(settings)) state.x |= bit;
      bit *= 2;
    }
    const std::map<std::string, std::pair<const void*, std::size_t>> values{
        {"sizePx", {&size, sizeof(size)}},
        {"renderSizePx", {&drawn, sizeof(drawn)}},
        {"renderRatio", {&ratio, sizeof(ratio)}},
        {"jitterPx", {&jitter, sizeof(jitter)}},
        {"depthTerms", {&inputs.block.depthTerms, sizeof(glm::vec4)}},
        {"currentWeights0", {&rows[0], 16}},
        {"currentWeights1", {&rows[1], 16}},
        {"currentWeights2", {&rows[2], 16}},
        {"weightTerms", {&terms, sizeof(terms)}},
        {"state", {&state, sizeof(state)}}};
    std::vector<std::byte> bytes(256);
    for (const auto& [name, offset] : program_.blockOffsets("ResolveBlock")) {
      if (name == "spread") continue;
      const auto& [data, count] = values.at(name);
      std::memcpy(bytes.data() + offset, data, count);
    }
    return {bytes.size(), bytes.data(), "exported"};
  }

  gl::Program program_;
  gl::Sampler nearest_;
  gl::Texture nothing_;
};

class GlslExportTest : public test::ResolveTest {
 protected:
  static void expectSameHistory(const History& actual, const History& expected) {
    const auto expectSame = [](const gl::Texture& a, const gl::Texture& b, std::string_view name) {
      ASSERT_EQ(bool(a), bool(b)) << name;
      if (!a) return;
      const Image is = a.download(), want = b.download();
      ASSERT_EQ(is.pixels.size(), want.pixels.size());
      const std::size_t bytes = is.pixels.size() * sizeof(float);
      EXPECT_EQ(std::memcmp(is.pixels.data(), want.pixels.data(), bytes), 0) << name;
    };
    expectSame(actual.color, expected.color, "color");
    expectSame(actual.surface, expected.surface, "surface");
    for (const HistoryLayer& layer : historyLayers())
      expectSame(actual.*layer.texture, expected.*layer.texture, layer.name);
  }

  // Two frames with history and one without.
  static void expectSameResolve(const Settings& settings) {
    const FrameShape shape = test::shapeFor(settings);
    Engine engine(exportedGlsl(settings, "test"));
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      const reference::Inputs images = test::randomFrame(shape, seed, seed == 2);
      const FrameInputs inputs = test::upload(images, shape);
      const History history = test::uploadHistory(images, shape);
      const History* previous = seed == 3 ? nullptr : &history;
      History expected, actual;
      pass().resolve(inputs, previous, settings, expected);
      engine.resolve(inputs, previous, settings, actual);
      expectSameHistory(actual, expected);
    }
  }
};

class EachExported : public GlslExportTest, public testing::WithParamInterface<std::string> {};

TEST_P(EachExported, ResolvesAsTheInspectorDoes) {
  expectSameResolve(preset(GetParam()).settings);
}

INSTANTIATE_TEST_SUITE_P(Presets, EachExported,
                         testing::Values("balanced", "minimal", "stable", "sharp", "fsr2", "ue4", "playdead",
                                         "intel", "hdrp-high", "urp-high", "donut"),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_F(GlslExportTest, UpsamplesAsTheInspectorDoes) {
  Settings settings = preset("balanced").settings;
  applyAssignment(settings, "inputs.renderScale=0.5");
  expectSameResolve(settings);
}

TEST_F(GlslExportTest, LeavesNothingOfTheInspectorInTheText) {
  const std::string text = exportedGlsl(preset("balanced").settings, "balanced");
  for (const char* word :
       {"expose", "stage_ends", "settings.", "SettingsBlock", "#line", "#include", "kIsSparse"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  EXPECT_EQ(text.find("#version 450 core\n"), 0u);
  for (const char* words : {"balanced", "Permission is hereby granted", "u_color (0)", "o_surface (1)",
                            "row-major", "rectify.method="})
    EXPECT_NE(text.find(words), std::string::npos) << words;
}

TEST_F(GlslExportTest, FoldsANumberThatIsSet) {
  Settings settings = preset("balanced").settings;
  applyAssignment(settings, "weight.minimum=0.0625");
  EXPECT_NE(exportedGlsl(settings, "x").find("const float kWeightMinimum = 0.0625;"), std::string::npos);
}

TEST_F(GlslExportTest, BatchWritesTheSameText) {
  const std::filesystem::path path = test::temporaryFolder() / "resolve.glsl";
  const test::ProcessResult result =
      test::runProcess({test::binary("taa-batch").string(), "glsl", "--preset", "fsr2", "--set",
                        "weight.minimum=0.25", "--out", path.string()});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  Settings settings = preset("fsr2").settings;
  applyAssignment(settings, "weight.minimum=0.25");
  EXPECT_EQ(readFile(path), exportedGlsl(settings, "fsr2, weight.minimum=0.25"));
}

} // namespace
} // namespace taa
