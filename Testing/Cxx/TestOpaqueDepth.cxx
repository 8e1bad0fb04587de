// Opaque depth as numbers: the same from any framebuffer that has depth, in the part that is asked
// for and 1 beside it.

#include "Framebuffer.h"
#include "OpaqueDepth.h"
#include "TestScene.h"

#include <algorithm>

namespace
{
constexpr int Width = 50, Height = 55;
const int Origin[2] = { 5, 3 };
// Of the framebuffer.
const int Surface[4] = { 20, 12, 10, 28 };
constexpr double Depth = 0.25;
const float Black[4] = { 0.0f, 0.0f, 0.0f, 1.0f };

bool IsOnSurface(int x, int y)
{
  return x >= Surface[0] && x < Surface[0] + Surface[2] && y >= Surface[1] &&
         y < Surface[1] + Surface[3];
}

bool IsWithin(int x, int y, const OpaqueDepth::Box& box)
{
  return x >= box[0] && x < box[0] + box[2] && y >= box[1] && y < box[1] + box[3];
}

// Of the depths of a viewport: the largest distance from what they are.
double ErrorOf(const std::vector<float>& depths, const OpaqueDepth::Box& box)
{
  double error = depths.size() == static_cast<size_t>(Width) * Height ? 0.0 : 1.0;
  for (size_t i = 0; error < 1.0 && i < depths.size(); ++i)
  {
    const int x = static_cast<int>(i) % Width, y = static_cast<int>(i) / Width;
    const bool isOpaque = IsWithin(x, y, box) && IsOnSurface(x + Origin[0], y + Origin[1]);
    error = std::max(error, std::abs(depths[i] - (isOpaque ? Depth : 1.0)));
  }
  return error;
}

void CheckPart(
  TestChecks& checks, vtkOpenGLRenderWindow* window, OpaqueDepth& depth, const OpaqueDepth::Box& box)
{
  CHECK(depth.Read(window, Origin, box));
  CHECK(!depth.GetPixels().AreClear());
  // What was there before does not shine through.
  std::vector<float> depths(7, 0.5f);
  depth.GetPixels().Expand(Width, Height, depths);
  // Half a step of 16 bits.
  CHECK_AT_MOST(ErrorOf(depths, box), 8e-6);
}

void CheckFramebuffer(TestChecks& checks, vtkRenderWindow* window, const Framebuffer::Kind& kind)
{
  std::cout << kind.Name << "\n";
  Framebuffer framebuffer(window, kind);
  CHECK(framebuffer.IsComplete);
  OpaqueDepth depth;
  framebuffer.Clear(Black, 1.0);
  CHECK(depth.Read(framebuffer.Window, Origin, { { 0, 0, Width, Height } }));
  CHECK(depth.GetPixels().AreClear());
  framebuffer.ClearPart(Surface, Black, Depth);
  CheckPart(checks, framebuffer.Window, depth, { { 0, 0, Width, Height } });
  CheckPart(checks, framebuffer.Window, depth, { { 8, 11, 20, 30 } });
  // Beside the surface, by a pixel, and no pixels at all.
  CHECK(depth.Read(framebuffer.Window, Origin, { { 25, 0, 25, Height } }));
  CHECK(depth.GetPixels().AreClear());
  CHECK(depth.Read(framebuffer.Window, Origin, { { 20, 20, 0, 0 } }));
  CHECK(depth.GetPixels().AreClear());
  // Nothing of it changes what is bound.
  framebuffer.Clear(Black, 1.0);
  CHECK(depth.Read(framebuffer.Window, Origin, { { 0, 0, Width, Height } }));
  CHECK(depth.GetPixels().AreClear());
  depth.ReleaseGraphicsResources(framebuffer.Window);
}

void CheckNoDepth(TestChecks& checks, vtkRenderWindow* window)
{
  Framebuffer framebuffer(window, { "no depth", true, VTK_UNSIGNED_CHAR, 1, 0 });
  OpaqueDepth depth;
  CHECK(!depth.Read(framebuffer.Window, Origin, { { 0, 0, Width, Height } }));
  CHECK(depth.GetPixels().AreClear());
}

// One pixel of many that is nearer than 1 by the smallest step, wherever it is.
void CheckOnePixel(TestChecks& checks, bool areFloats, std::uint32_t one)
{
  DepthPixels pixels;
  constexpr int Count = 9001;
  auto* bits = static_cast<std::uint32_t*>(pixels.Allocate({ { 0, 0, Count, 1 } }, areFloats));
  std::fill_n(bits, Count, one);
  CHECK(pixels.AreClear());
  for (const int at : { 0, 4095, 4096, 8999, 9000 })
  {
    bits[at] = one - 1;
    CHECK(!pixels.AreClear());
    bits[at] = 0;
    CHECK(!pixels.AreClear());
    bits[at] = one;
  }
  CHECK(pixels.AreClear());
}
}

int TestOpaqueDepth(int, char*[])
{
  TestChecks checks;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(64, 64);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->Render();
  const int bytes = VTK_UNSIGNED_CHAR;
  CheckFramebuffer(checks, window, { "textures, 16 bits", true, bytes, 1, 16 });
  CheckFramebuffer(checks, window, { "textures, 24 bits", true, bytes, 1, 24 });
  CheckFramebuffer(checks, window, { "textures, 32 bits", true, bytes, 1, 32 });
  CheckFramebuffer(checks, window, { "textures, stencil", true, bytes, 1, 24, 0, true });
  CheckFramebuffer(checks, window, { "renderbuffers", false, bytes, 1, 24 });
  CheckFramebuffer(checks, window, { "textures, 4 samples", true, bytes, 1, 24, 4 });
  CheckFramebuffer(checks, window, { "renderbuffers, 4 samples", false, bytes, 1, 24, 4 });
  CheckNoDepth(checks, window);
  CheckOnePixel(checks, false, 0xffffffffu);
  CheckOnePixel(checks, true, 0x3f800000u);
  return checks.Result();
}
