// The image laid over a framebuffer in memory: its closed form with every instruction set that this
// machine has, the same as a rectangle that the GL draws, and left to the GL wherever that would
// draw something else.

#include "EngineChoice.h"
#include "FloatTarget.h"
#include "Framebuffer.h"
#include "OpaquePlane.h"
#include "PixelBlending.h"
#include "PremultipliedBlending.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "VTKVersions.h"
#include "WindowPixels.h"

#include "vtkOpenGLState.h"
#include "vtkUnsignedCharArray.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
// Of the framebuffer and of its viewport.
const int Origin[2] = { 5, 3 };
const int ViewportSize[2] = { 50, 55 };
const WindowPixels::Box Part{ { 8, 4, 31, 30 } };
const float Under[4] = { 0.2f, 0.4f, 0.6f, 0.8f };

double Cut(double value)
{
  return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

// Colours and alphas from below 0 to above 1, and one that is no number.
std::vector<float> MakeImage(int pixels)
{
  std::vector<float> image;
  for (int i = 0; i < 4 * pixels; ++i)
  {
    image.push_back(0.7f + 0.8f * std::sin(0.37f * static_cast<float>(i)));
  }
  image[1] = std::numeric_limits<float>::quiet_NaN();
  return image;
}

// The largest distance from the closed form, which rounding alone makes .5.
double ErrorOfBlending(int count)
{
  const std::vector<float> image = MakeImage(count);
  std::vector<unsigned char> window(4 * static_cast<size_t>(count) + 16);
  for (size_t i = 0; i < window.size(); ++i)
  {
    window[i] = static_cast<unsigned char>(37 * i % 256);
  }
  const std::vector<unsigned char> before = window;
  PixelBlending::LayOver(image.data(), count, window.data());
  double error = 0.0;
  for (size_t i = 0; i < image.size(); ++i)
  {
    const double alpha = Cut(image[i / 4 * 4 + 3]);
    const double sum = 255.0 * Cut(image[i]) + before[i] * (1.0 - alpha);
    error = std::max(error, std::abs(std::min(sum, 255.0) - window[i]));
  }
  const bool isBeyond = !std::equal(before.end() - 16, before.end(), window.end() - 16);
  return isBeyond ? 256.0 : error;
}

void CheckTargets(TestChecks& checks)
{
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    double error = 0.0;
    for (int count = 1; count < 40; ++count)
    {
      error = std::max(error, ErrorOfBlending(count));
    }
    std::cout << hwy::TargetName(target) << ": " << error << " levels\n";
    CHECK_AT_MOST(error, 0.5 + 1e-4);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void LayByGL(Framebuffer& framebuffer, const std::vector<float>& image)
{
  FloatTarget target;
  const PremultipliedBlending blending(framebuffer.State);
  target.Upload(framebuffer.Window, ViewportSize, Part, image.data());
  target.Blend(framebuffer.Window, Origin, ViewportSize, Part);
  target.ReleaseGraphicsResources(framebuffer.Window);
}

std::vector<unsigned char> DrawByGL(Framebuffer& framebuffer, const std::vector<float>& image)
{
  framebuffer.Clear(Under, 1.0);
  LayByGL(framebuffer, image);
  return framebuffer.ReadColors();
}

int DifferenceOf(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  int difference = a.size() == b.size() ? 0 : 256;
  for (size_t i = 0; difference < 256 && i < a.size(); ++i)
  {
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference;
}

bool Lays(vtkOpenGLRenderWindow* window, const int origin[2], const std::vector<float>& image)
{
  WindowPixels pixels;
  const bool isRead = pixels.Read(window, origin, Part);
  return pixels.LayOver(image.data(), ViewportSize[0]) && isRead;
}

bool Lays(Framebuffer& framebuffer, const std::vector<float>& image)
{
  return Lays(framebuffer.Window, Origin, image);
}

void CheckSameAsGL(TestChecks& checks, vtkRenderWindow* window)
{
  const std::vector<float> image = MakeImage(ViewportSize[0] * ViewportSize[1]);
  Framebuffer framebuffer(window, { "textures" });
  const std::vector<unsigned char> expected = DrawByGL(framebuffer, image);
  framebuffer.Clear(Under, 1.0);
  const std::vector<unsigned char> before = framebuffer.ReadColors();
  CHECK(Lays(framebuffer, image));
  CHECK_AT_MOST(DifferenceOf(expected, framebuffer.ReadColors()), 1);
  CHECK(DifferenceOf(expected, before) > 100);
  // What is not within the framebuffer is not for us.
  const int beside[2] = { 40, 3 };
  const std::vector<unsigned char> after = framebuffer.ReadColors();
  CHECK(!Lays(framebuffer.Window, beside, image));
  // A volume beside the viewport has rows and no columns there.
  WindowPixels none;
  CHECK(none.Read(framebuffer.Window, Origin, { { 0, 4, 0, 30 } }));
  CHECK(none.LayOver(image.data(), ViewportSize[0]));
  CHECK(framebuffer.ReadColors() == after);
}

// Strides and a buffer that others left set; they are still set at the end.
void SpoilPixelStore(TestChecks& checks, const std::function<void()>& work)
{
  const GLenum names[] = { GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_ROWS };
  const int strange[] = { 77, 3, 99, 2 };
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  for (int i = 0; i < 4; ++i)
  {
    glPixelStorei(names[i], strange[i]);
  }
  work();
  int found = 0;
  for (int i = 0; i < 4; ++i)
  {
    glGetIntegerv(names[i], &found);
    CHECK(found == strange[i]);
    glPixelStorei(names[i], 0);
  }
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &found);
  CHECK(found == static_cast<int>(buffer));
  glDeleteBuffers(1, &buffer);
}

void CheckPixelStore(TestChecks& checks, vtkRenderWindow* window)
{
  const std::vector<float> image = MakeImage(ViewportSize[0] * ViewportSize[1]);
  Framebuffer framebuffer(window, { "textures" });
  const std::vector<unsigned char> expected = DrawByGL(framebuffer, image);
  framebuffer.Clear(Under, 1.0);
  SpoilPixelStore(checks, [&] { LayByGL(framebuffer, image); });
  CHECK(framebuffer.ReadColors() == expected);
  framebuffer.Clear(Under, 1.0);
  SpoilPixelStore(checks, [&] { CHECK(Lays(framebuffer, image)); });
  CHECK_AT_MOST(DifferenceOf(expected, framebuffer.ReadColors()), 1);
}

void CheckLeftToGL(TestChecks& checks, vtkRenderWindow* window)
{
  const std::vector<float> image = MakeImage(ViewportSize[0] * ViewportSize[1]);
  const int bytes = VTK_UNSIGNED_CHAR;
  for (const Framebuffer::Kind& kind : { Framebuffer::Kind{ "floats", true, VTK_FLOAT },
         { "two colours", true, bytes, 2 }, { "4 samples", true, bytes, 1, 24, 4 },
         { "renderbuffers", false, bytes } })
  {
    std::cout << kind.Name << "\n";
    Framebuffer framebuffer(window, kind);
    CHECK(framebuffer.IsComplete);
    framebuffer.Clear(Under, 1.0);
    CHECK(!Lays(framebuffer, image));
  }
}

void CheckMasks(TestChecks& checks, vtkRenderWindow* window)
{
  const std::vector<float> image = MakeImage(ViewportSize[0] * ViewportSize[1]);
  Framebuffer framebuffer(window, { "masks" });
  framebuffer.Clear(Under, 1.0);
  const std::vector<unsigned char> before = framebuffer.ReadColors();
  for (int k = 0; k < 4; ++k)
  {
    framebuffer.State->vtkglColorMask(k != 0, k != 1, k != 2, k != 3);
    CHECK(!Lays(framebuffer, image));
  }
  framebuffer.State->vtkglColorMask(1, 1, 1, 1);
  constexpr unsigned int StencilTest = 0x0B90;
  framebuffer.State->vtkglEnable(StencilTest);
  CHECK(!Lays(framebuffer, image));
  framebuffer.State->vtkglDisable(StencilTest);
  CHECK(framebuffer.ReadColors() == before);
  CHECK(Lays(framebuffer, image));
}

// The window of a scene with two viewports, something opaque and a second layer.
std::vector<unsigned char> Show(bool captures, int samples)
{
  TestScene scene(128, 64);
  scene.Mapper->SetEngineToTiles();
  scene.Window->SetMultiSamples(samples);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.SetSmooth();
  OpaquePlane::AddSlanted(scene);
  scene.AddSecondViewport()->SetBackground(0.9, 0.5, 0.1);
  vtkNew<vtkRenderer> above;
  scene.Window->SetNumberOfLayers(2);
  above->SetLayer(1);
  above->SetActiveCamera(scene.Renderer->GetActiveCamera());
  above->AddVolume(scene.Volume);
  above->SetViewport(0.1, 0.1, 0.7, 0.8);
  scene.Window->AddRenderer(above);
  scene.Renderer->SetBackground(0.1, 0.2, 0.9);
  scene.LookFrom(0.5, 0.8, 4.0);
  scene.Mapper->SetCaptureImage(captures);
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetPixelData(0, 0, 127, 63, 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

// Volumes whose image is captured are blended by the GL.
void CheckScene(TestChecks& checks)
{
  const int samples[2] = { 0, 4 };
  for (const int count : samples)
  {
    const std::vector<unsigned char> expected = Show(true, count), shown = Show(false, count);
    // Two volumes lie over each other: rounded twice.
    CHECK_AT_MOST(DifferenceOf(expected, shown), 2);
  }
}

// The framebuffer that VTK draws to is one that we can lay over.
void CheckOwnWindow(TestChecks& checks, vtkRenderWindow* window)
{
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  vtkOpenGLState* state = glWindow->GetState();
  state->PushFramebufferBindings();
  glWindow->GetRenderFramebuffer()->Bind();
  const std::vector<float> image = MakeImage(ViewportSize[0] * ViewportSize[1]);
  CHECK(Lays(glWindow, Origin, image));
  state->PopFramebufferBindings();
}
}

int TestWindowPixels(int, char*[])
{
  TestChecks checks;
  CheckTargets(checks);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(64, 64);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->Render();
  CheckSameAsGL(checks, window);
  CheckPixelStore(checks, window);
  CheckLeftToGL(checks, window);
  CheckMasks(checks, window);
  CheckOwnWindow(checks, window);
  CheckScene(checks);
  return checks.Result();
}
