// A pre-integration table that memory does not hold: exact instead, said once, and a smaller one is
// drawn again.

#include "PreIntegrationTable.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "TransferFunction.h"

#ifdef __linux__
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace
{
void CheckTable(TestChecks& checks)
{
  TransferFunction constant;
  const double range[2] = { 0.0, 1.0 };
  constant.Build({}, [](double) { return TransferFunction::Sample{ { 1.0, 1.0, 1.0, 1.0 } }; },
    range, range, 1.0);
  const float ends[2] = { 0.0f, 1.0f };
  for (const bool lit : { false, true })
  {
    PreIntegrationTable table;
    CHECK(table.Build(constant, ends, 32, lit));
    // No address space holds it.
    CHECK(!table.Build(constant, ends, 1 << 20, lit));
    CHECK(table.Texels.empty() && table.Front.empty() && table.Back.empty());
    CHECK(table.IsLit() == lit && table.Size == 1 << 20);
    CHECK(table.Build(constant, ends, 64, lit));
    CHECK(table.Texels.size() == 64u * 64u * 64u);
  }
}

#ifdef __linux__
/// Leaves the process so many bytes more than it has, as long as it lives.
class AddressLimit
{
public:
  explicit AddressLimit(rlim_t bytes)
  {
    getrlimit(RLIMIT_AS, &this->Before);
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = this->Before;
    limit.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~AddressLimit() { setrlimit(RLIMIT_AS, &this->Before); }
  AddressLimit(const AddressLimit&) = delete;
  void operator=(const AddressLimit&) = delete;

private:
  rlimit Before;
};

void CheckPicture(TestChecks& checks, bool lit)
{
  TestScene scene(64, 64);
  scene.SetGrid(TestMeshes::Delaunay(80));
  auto* mapper = scene.GetTetrahedraMapper();
  mapper->SetEngine(vtkConvexCellMapper::RASTER);
  scene.Property->SetShade(lit);
  scene.Render();
  auto exact = scene.CopyCaptured();
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  mapper->SetIntegrationToTable();
  mapper->SetTableSize(256);
  {
    // The texels alone are 64 MB.
    const AddressLimit limit(40 << 20);
    scene.Render();
    scene.Render();
  }
  CHECK(messages->Count() == 1 &&
    messages->CountOf("There is no room for a pre-integration table of size 256") == 1);
  CHECK(TestScene::Difference(exact, scene.Mapper->GetCapturedImage()) == 0.0);
  mapper->SetTableSize(64);
  const double error = scene.MaximumError("table of size 64");
  CHECK(messages->Count() == 1);
  CHECK(TestScene::Difference(exact, scene.Mapper->GetCapturedImage()) > 0.0);
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 2e-2);
}
#endif
}

int TestTableMemory(int, char*[])
{
  TestChecks checks;
  CheckTable(checks);
#ifdef __linux__
  CheckPicture(checks, false);
  CheckPicture(checks, true);
#endif
  return checks.Result();
}
