// The points of the jitter patterns that are lists, in px.
#include "core/render/JitterPoints.h"

namespace taa {

namespace {

constexpr glm::vec2 kOrigin[] = {{0.0f, 0.0f}};
constexpr glm::vec2 kCorner[] = {{0.5f, 0.5f}};                       // J0: Playdead's "still" is not 0
constexpr glm::vec2 kUniform2[] = {{-0.25f, -0.25f}, {0.25f, 0.25f}}; // J1
constexpr glm::vec2 kUniform4[] = {{-0.25f, -0.25f}, {0.25f, -0.25f}, {-0.25f, 0.25f}, {0.25f, 0.25f}}; // J2
constexpr glm::vec2 kHelix[] = {{-0.25f, -0.25f}, {0.25f, 0.25f}, {0.25f, -0.25f}, {-0.25f, 0.25f}};    // J3
// J4: one turn of the helix, then the same turn back.
constexpr glm::vec2 kDoubleHelix[] = {{-0.25f, -0.25f}, {0.25f, 0.25f},   {0.25f, -0.25f}, {-0.25f, 0.25f},
                                      {0.25f, 0.25f},   {-0.25f, -0.25f}, {-0.25f, 0.25f}, {0.25f, -0.25f}};
constexpr glm::vec2 kButterfly[] = {
    {-0.25f, -0.25f}, {0.25f, 0.25f}, {0.125f, -0.125f}, {-0.125f, 0.125f}}; // J5
constexpr glm::vec2 kRotatedGrid[] = {
    {-0.125f, -0.375f}, {0.375f, -0.125f}, {0.125f, 0.375f}, {-0.375f, 0.125f}}; // J6
// J7: ten points in a disc of radius ¼, far from each other and of mean 0. Playdead's are others.
constexpr glm::vec2 kPoisson10[] = {{-0.203125f, -0.140625f},     {0.19140625f, 0.1171875f},
                                    {-0.16796875f, 0.1640625f},   {0.12109375f, -0.14453125f},
                                    {-0.05859375f, -0.00390625f}, {0.015625f, 0.1953125f},
                                    {-0.03125f, -0.1796875f},     {-0.203125f, 0.00390625f},
                                    {0.08984375f, 0.015625f},     {0.24609375f, -0.02734375f}};
// J8: a regular pentagon of width ½, every other corner: sine and cosine of 144° times 0.2628656.
constexpr glm::vec2 kPentagram[] = {{0.0f, 0.2628656f},
                                    {0.1545085f, -0.2126627f},
                                    {-0.25f, 0.0812299f},
                                    {0.25f, 0.0812299f},
                                    {-0.1545085f, -0.2126627f}};
// J10, before it is turned across the camera's way.
constexpr glm::vec2 kPerpendicular[] = {{0.0f, -0.25f}, {0.0f, 0.25f}};
// J14: D3D's standard pattern in sixteenths.
constexpr glm::vec2 kMsaa8[] = {{0.0625f, -0.1875f},  {-0.0625f, 0.1875f}, {0.3125f, 0.0625f},
                                {-0.1875f, -0.3125f}, {-0.3125f, 0.3125f}, {-0.4375f, -0.0625f},
                                {0.1875f, 0.4375f},   {0.4375f, -0.4375f}};
// J15: one point in each of sixteen rows and columns, far from each other across the borders of the pixel
// too; each next one is the farthest from those before. Intel's table spans 2 × 2 px and has other points.
constexpr glm::vec2 kBlueNoise16[] = {
    {-0.46875f, 0.34375f},  {0.03125f, -0.15625f},  {0.46875f, -0.09375f},  {-0.03125f, 0.21875f},
    {0.09375f, -0.46875f},  {-0.28125f, -0.21875f}, {-0.34375f, 0.09375f},  {0.28125f, -0.28125f},
    {-0.21875f, 0.40625f},  {0.21875f, 0.28125f},   {-0.40625f, -0.40625f}, {-0.15625f, -0.03125f},
    {-0.09375f, -0.34375f}, {0.15625f, 0.03125f},   {0.34375f, 0.46875f},   {0.40625f, 0.15625f}};

} // namespace

std::span<const glm::vec2> pointsOf(JitterSequence sequence) {
  switch (sequence) {
  case JitterSequence::None:
    return kOrigin;
  case JitterSequence::Still:
    return kCorner;
  case JitterSequence::Uniform2:
    return kUniform2;
  case JitterSequence::Uniform4:
    return kUniform4;
  case JitterSequence::Helix:
    return kHelix;
  case JitterSequence::DoubleHelix:
    return kDoubleHelix;
  case JitterSequence::Butterfly:
    return kButterfly;
  case JitterSequence::RotatedGrid:
    return kRotatedGrid;
  case JitterSequence::Poisson10:
    return kPoisson10;
  case JitterSequence::Pentagram:
    return kPentagram;
  case JitterSequence::Perpendicular:
    return kPerpendicular;
  case JitterSequence::Msaa8:
    return kMsaa8;
  case JitterSequence::BlueNoise16:
    return kBlueNoise16;
  case JitterSequence::Halton:
  case JitterSequence::R2:
  case JitterSequence::Hammersley:
  case JitterSequence::GradientNoise:
  case JitterSequence::WhiteNoise:
    break;
  }
  return {};
}

} // namespace taa
