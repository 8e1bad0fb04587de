#include "BenchmarkMachine.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <fstream>
#include <iterator>

namespace
{
// What follows `key` and a colon, to the end of the line.
std::string FindValue(const std::string& text, const std::string& key)
{
  const std::size_t at = text.find(key);
  const std::size_t begin = at == std::string::npos ? at : text.find(':', at);
  if (begin == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t first = text.find_first_not_of(": \t", begin);
  const std::string value = text.substr(first, text.find('\n', first) - first);
  return value.empty() ? "unknown" : value;
}

std::string FindRenderer()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  return FindValue(window->ReportCapabilities(), "OpenGL renderer string");
}

std::string FindProcessor()
{
  std::ifstream file("/proc/cpuinfo");
  const std::string all{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  return FindValue(all, "model name");
}
}

//------------------------------------------------------------------------------
BenchmarkMachine BenchmarkMachine::Find()
{
  return { FindRenderer(), FindProcessor(), vtkSMPTools::GetBackend(),
    vtkSMPTools::GetEstimatedNumberOfThreads(), vtkVersion::GetVTKVersion() };
}

//------------------------------------------------------------------------------
std::string BenchmarkMachine::Describe() const
{
  return this->Processor + ", " + std::to_string(this->Threads) + " threads by vtkSMPTools (" +
         this->Backend + "), OpenGL by " + this->Renderer + ", VTK " + this->VTK;
}
