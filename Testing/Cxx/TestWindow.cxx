// Prints what the tests run on, and fails where that is not what VTK_DEFAULT_OPENGL_WINDOW asks
// for.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
// The rest of the line that begins with `name` in VTK's report on the GL.
std::string FindLine(const std::string& report, const std::string& name)
{
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, name.size(), name) == 0)
    {
      return line.substr(line.find_first_not_of(' ', name.size()));
    }
  }
  return "";
}

// Whether a library whose path has `name` in it is mapped into this process (Linux).
bool IsLoaded(const std::string& name)
{
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    if (line.find(name) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}
}

int TestWindow(int, char*[])
{
  TestChecks checks;
  TestScene scene(64, 64);
  scene.SetGrid(TestMeshes::Curvilinear(2));
  scene.Render();
  const std::string report = scene.Window->ReportCapabilities();
  const std::string found = scene.Window->GetClassName();
  std::cout << "VTK version: " << vtkVersion::GetVTKVersion() << "\nwindow class: " << found
            << "\nGL renderer: " << FindLine(report, "OpenGL renderer string:")
            << "\nGL version: " << FindLine(report, "OpenGL version string:")
            << "\nOSMesa: " << (IsLoaded("libOSMesa") ? "loaded" : "not loaded") << "\n";
  CHECK(!FindLine(report, "OpenGL renderer string:").empty());
  CHECK(vtkPreIntegratedTetrahedraMapper::IsSupported(scene.Window));
  const char* asked = std::getenv("VTK_DEFAULT_OPENGL_WINDOW");
  if (asked && *asked)
  {
    checks.Check(found == asked, "the window is of the class asked for", __LINE__, found);
    CHECK(IsLoaded("libOSMesa") == (found == "vtkOSOpenGLRenderWindow"));
  }
  return checks.Result();
}
