// What tests check and observe: apart from class TestScene, which needs the mappers.

#include "TestScene.h"

#include <algorithm>

//------------------------------------------------------------------------------
void TestChecks::Check(bool good, const char* text, int line, const std::string& found)
{
  if (!good)
  {
    ++this->Failures;
    std::cerr << "line " << line << ": failed: " << text << (found.empty() ? "" : "; found ")
              << found << "\n";
  }
}

//------------------------------------------------------------------------------
void MessageObserver::Execute(vtkObject*, unsigned long, void* data)
{
  this->Texts.emplace_back(data ? static_cast<const char*>(data) : "");
}

//------------------------------------------------------------------------------
void MessageObserver::Watch(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, this);
  object->AddObserver(vtkCommand::WarningEvent, this);
}

//------------------------------------------------------------------------------
int MessageObserver::CountOf(const std::string& text) const
{
  return static_cast<int>(std::count_if(this->Texts.begin(), this->Texts.end(),
    [&](const std::string& line) { return line.find(text) != std::string::npos; }));
}
