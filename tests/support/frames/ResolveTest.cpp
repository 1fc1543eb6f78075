// A fixture that resolves synthetic frames.
#include "tests/support/frames/ResolveTest.h"

namespace taa::test {

namespace {

std::unique_ptr<TaaPass> sharedPass; // lives as long as the shared context, that is, to the end

} // namespace

Exposed images(const ExposedRows& exposedRows) {
  Exposed all;
  for (const IntermediateId id : exposedRows.watched()) all[id] = exposedRows.image(id);
  return all;
}

std::vector<Image> resolveRows(const Exposed& exposed) {
  std::vector<Image> rows;
  for (const Intermediate& row : kResolveRows) rows.push_back(exposed.at(row.id));
  return rows;
}

void ResolveTest::SetUp() {
  GlTest::SetUp();
  if (IsSkipped() || HasFatalFailure() || sharedPass) return;
  sharedPass = std::make_unique<TaaPass>();
}

TaaPass& ResolveTest::pass() {
  return *sharedPass;
}

History ResolveTest::resolve(const twin::Inputs& images, const FrameShape& shape, const Settings& settings,
                             ExposedRows* exposedRows) {
  const FrameInputs inputs = upload(images, shape);
  const History previous = uploadHistory(images, shape);
  History out;
  pass().resolve(inputs, previous.color ? &previous : nullptr, settings, out, exposedRows);
  return out;
}

Exposed ResolveTest::expose(const twin::Inputs& images, const FrameShape& shape, const Settings& settings,
                            TaaPass* other) {
  const FrameInputs inputs = upload(images, shape);
  const History previous = uploadHistory(images, shape);
  ExposedRows exposedRows(allRows(), whole(shape));
  History out;
  TaaPass& by = other ? *other : pass();
  by.resolve(inputs, previous.color ? &previous : nullptr, settings, out, &exposedRows);
  return test::images(exposedRows);
}

void ResolveTest::advance(twin::Inputs& images, const FrameShape& shape, const Settings& settings) {
  downloadHistory(resolve(images, shape, settings), images);
}

twin::Inputs ResolveTest::rested(const FrameShape& shape, const Settings& settings, std::uint32_t seed) {
  twin::Inputs out = stillFrame(shape, seed);
  for (std::uint32_t frame = 1; frame <= 4; ++frame) {
    advance(out, shape, settings);
    out.color = stillFrame(shape, seed + frame).color;
  }
  return out;
}

Settings bareSettings() {
  Settings settings;
  settings.dilate.method = DilateMethod::None;
  settings.history = {HistoryFilter::Bilinear, Switch::Off, Precision::Full};
  settings.current.filter = CurrentFilter::Center;
  settings.space = {ColorSpace::Rgb, ToneSpace::Linear};
  settings.neighborhood.includeFiltered = Switch::Off;
  settings.rectify.method = RectifyMethod::None;
  settings.validate.offScreen = OffScreen::Keep;
  settings.validate.depth = Switch::Off;
  settings.weight.source = AlphaSource::Constant;
  settings.blend.tone = ToneWeight::None;
  return settings;
}

} // namespace taa::test
