// An exported resolve and the pass after it, compiled as they stand and bound by what their head says, give
// the inspector's bits.
#include "core/taa/GlslExport.h"

#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/OutputPass.h"
#include "core/taa/PassInputs.h"
#include "shaders/shared/ResolveBlock.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"
#include "tests/support/frames/ResolveTest.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace taa {
namespace {

using test::FrameShape;

/// Somebody's engine: knows what the head of the file says, and nothing of the inspector's passes.
class Engine {
 public:
  explicit Engine(const std::string& text)
      : program_(compiled(text)), output_(hasOutput(text) ? compiled(withOutputMacro(text)) : gl::Program()),
        nearest_(gl::SamplerState{}), nothing_(gl::TextureSize{1, 1}, gl::Format::RGBA8, "nothing") {
    nothing_.clear(0.0f, 0.0f, 0.0f, 0.0f);
  }

  static bool hasOutput(const std::string& text) { return text.find("#ifndef TAA_OUTPUT") != text.npos; }

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

  /// What is shown, from what was resolved.
  Image show(const FrameInputs& inputs, const Settings& settings, const History& resolved) const {
    if (!output_) return resolved.color.download();
    const gl::TextureSize size{inputs.outputWidth(), inputs.outputHeight()};
    const gl::Texture shown(size, gl::Format::RGBA32F, "shown");
    const gl::Buffer block = blockOf(inputs, nullptr, settings); // the same buffer serves both
    const gl::Framebuffer target({{&shown}}, nullptr, "shown");
    gl::RenderPass pass(target, {}, "shown");
    pass.program(output_);
    pass.uniformBlock(0, block);
    pass.texture(0, inputs.color, nearest_);
    pass.texture(1, inputs.depth, nearest_);
    pass.texture(2, inputs.motion, nearest_);
    pass.texture(8, resolved.color, nearest_);
    pass.texture(15, inputs.overlay ? inputs.overlay : nothing_, nearest_);
    pass.drawFullscreen();
    return shown.download();
  }

 private:
  static gl::Program compiled(const std::string& text) {
    return {gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource::complete(text, "exported.frag"),
            "exported"};
  }
  static std::string withOutputMacro(std::string text) {
    return text.insert(text.find('\n') + 1, "#define TAA_OUTPUT\n");
  }

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

  gl::Program program_, output_;
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

  // Alpha has no row.
  static void expectSameColors(const Image& shown, const Image& row) {
    ASSERT_EQ(shown.width, row.width);
    ASSERT_EQ(shown.height, row.height);
    int wrong = 0;
    for (int y = 0; y < row.height; ++y)
      for (int x = 0; x < row.width; ++x)
        if (std::memcmp(shown.at(x, y), row.at(x, y), 3 * sizeof(float)) != 0) ++wrong;
    EXPECT_EQ(wrong, 0) << "pixels of what is shown";
  }

  // Two frames with history and one without: what is kept, and what is shown.
  static void expectSameResolve(const Settings& settings) {
    const FrameShape shape = test::shapeFor(settings);
    const std::string text = exportedGlsl(settings, "test");
    EXPECT_EQ(Engine::hasOutput(text), changesOutput(settings));
    Engine engine(text);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      twin::Inputs images = test::randomFrame(shape, seed, seed == 2);
      if (settings.inputs.blended != BlendedAs::After) images.overlay = {};
      const FrameInputs inputs = test::upload(images, shape);
      const History history = test::uploadHistory(images, shape);
      const History* previous = seed == 3 ? nullptr : &history;
      History expected, actual;
      ExposedRows exposedRows({IntermediateId::output}, whole(shape));
      pass().resolve(inputs, previous, settings, expected, &exposedRows);
      engine.resolve(inputs, previous, settings, actual);
      expectSameHistory(actual, expected);
      expectSameColors(engine.show(inputs, settings, actual), exposedRows.image(IntermediateId::output));
    }
  }
};

class EachExported : public GlslExportTest, public testing::WithParamInterface<std::string> {};

TEST_P(EachExported, ResolvesAsTheInspectorDoes) {
  expectSameResolve(preset(GetParam()).settings);
}

INSTANTIATE_TEST_SUITE_P(Presets, EachExported,
                         testing::Values("balanced", "minimal", "stable", "sharp", "fsr2", "ue4", "playdead",
                                         "intel", "hdrp-high", "urp-high", "donut", "raptor", "miniengine"),
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

class EachExportedSharpening : public GlslExportTest, public testing::WithParamInterface<int> {};

TEST_P(EachExportedSharpening, ShowsWhatTheInspectorShows) {
  Settings settings = preset("minimal").settings;
  settings.output.sharpen = static_cast<Sharpen>(GetParam());
  settings.output.amount = 1.5f;
  expectSameResolve(settings);
  applyAssignment(settings, "inputs.renderScale=0.5");
  applyAssignment(settings, "inputs.blended=after");
  applyAssignment(settings, "output.dering=on");
  applyAssignment(settings, "output.motionBlur=on");
  expectSameResolve(settings);
}

INSTANTIATE_TEST_SUITE_P(Choices, EachExportedSharpening,
                         testing::Range(0, static_cast<int>(Sharpen::Reconstruct) + 1),
                         [](const auto& row) { return "Choice" + std::to_string(row.param); });

TEST_F(GlslExportTest, BlursAndCoversAsTheInspectorDoes) {
  for (const char* assignment : {"output.motionBlur=on", "inputs.blended=after"}) {
    Settings settings = preset("minimal").settings;
    applyAssignment(settings, assignment);
    expectSameResolve(settings);
  }
}

TEST_F(GlslExportTest, HasOneShaderWhereNothingFollowsTheResolve) {
  const std::string text = exportedGlsl(preset("balanced").settings, "x");
  EXPECT_EQ(text.find("TAA_OUTPUT"), std::string::npos);
  EXPECT_EQ(text.find("output.sharpen"), std::string::npos);
  EXPECT_NE(text.find("What is shown is o_color"), std::string::npos);
}

TEST_F(GlslExportTest, TellsOfTheSecondShaderAndItsInputs) {
  const std::string text = exportedGlsl(preset("hdrp-high").settings, "x");
  for (const char* words : {"#define TAA_OUTPUT", "u_resolved (8)", "u_color (0): the same as the resolve's.",
                            "o_output (0)", "output.sharpen=inResolve output.amount=0.5"})
    EXPECT_NE(text.find(words), std::string::npos) << words;
  for (const char* word : {"expose", "settings.", "SettingsBlock", "#line", "kIsSparse"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  EXPECT_EQ(text.find("u_overlay"), std::string::npos) << "an input that is not needed";
}

TEST_F(GlslExportTest, LeavesNothingOfTheInspectorInTheText) {
  const std::string text = exportedGlsl(preset("balanced").settings, "balanced");
  for (const char* word : {"expose", "settings.", "SettingsBlock", "#line", "#include", "kIsSparse"})
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
  std::vector<std::string> command = {test::binary("taa-batch").string(),
                                      "glsl",
                                      "--preset",
                                      "fsr2",
                                      "--set",
                                      "weight.minimum=0.25",
                                      "--out",
                                      path.string()};
  writeFile(path, "mine");
  const test::ProcessResult refused = test::runProcess(command);
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_NE(refused.err.find(path.string() + " is there already; --force"), std::string::npos) << refused.err;
  EXPECT_EQ(readFile(path), "mine");
  command.emplace_back("--force");
  const test::ProcessResult result = test::runProcess(command);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  Settings settings = preset("fsr2").settings;
  applyAssignment(settings, "weight.minimum=0.25");
  EXPECT_EQ(readFile(path), exportedGlsl(settings, "fsr2, weight.minimum=0.25"));
}

} // namespace
} // namespace taa
