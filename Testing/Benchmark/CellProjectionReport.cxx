// Speed against error: every method of ours and of VTK's on several meshes, each with a smooth and
// a spiky transfer function, unlit and lit. One CSV row per method and look, one line of progress.
//   CellProjectionReport FILE.csv [full|quick|tiny [NAME [MESH]]]; the data's folder is in
//   CELLPROJECTION_DATA; with a name VTK's projected tetrahedra and the methods that contain it,
//   with a mesh that alone

#include "ReportMeshes.h"
#include "ReportMethods.h"
#include "ReportRow.h"
#include "ReportScene.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
struct Plan
{
  std::vector<ReportMeshes::Mesh> Meshes;
  std::vector<ReportMethods::Method> Methods = ReportMethods::All();
  ReportScene::Settings Settings;
  // Of the methods.
  std::string Name;
  // Rows get their share of what is left of it.
  double Seconds = 2000.0;
};

Plan MakePlan(const std::string& kind)
{
  const char* variable = std::getenv("CELLPROJECTION_DATA");
  const std::string folder = variable ? variable : "";
  Plan plan;
  if (kind == "tiny")
  {
    plan.Meshes = { ReportMeshes::MakeLattice(4, { 20.0 }) };
    plan.Methods = ReportMethods::Few();
    plan.Settings = { 3, 64, 32, 1, 10.0 };
    plan.Seconds = 10.0;
  }
  else if (kind == "quick")
  {
    plan.Meshes = ReportMeshes::Read(folder, { "disk_out_ref" });
    plan.Meshes.push_back(ReportMeshes::MakeLattice(10, { 2.0, 5.0, 10.0 }));
    plan.Settings = { 9, 128, 32, 1, 10.0 };
    plan.Seconds = 220.0;
  }
  else
  {
    plan.Meshes =
      ReportMeshes::Read(folder, { "Blunt Fin", "Bucky ball", "disk_out_ref", "fire plume" });
    plan.Meshes.push_back(ReportMeshes::MakeLattice(24));
  }
  return plan;
}

// What every row is compared with stays.
void KeepMethods(const std::string& name, std::vector<ReportMethods::Method>& methods)
{
  methods.erase(std::remove_if(methods.begin() + 1, methods.end(),
                  [&](const ReportMethods::Method& method)
                  { return method.Curve.find(name) == std::string::npos; }),
    methods.end());
}

void KeepMesh(const std::string& name, std::vector<ReportMeshes::Mesh>& meshes)
{
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                 [&](const ReportMeshes::Mesh& mesh)
                 { return mesh.Name.find(name) == std::string::npos; }),
    meshes.end());
}

/// Tells how far it is, and how long the next row may take.
class Progress
{
public:
  explicit Progress(const Plan& plan)
    : Budget(plan.Seconds)
    // Two transfer functions, unlit and, of about a third of the methods, lit.
    , RowsLeft(2.6 * static_cast<double>(plan.Meshes.size() * plan.Methods.size()))
  {
  }

  double GetSecondsForNextRow()
  {
    this->RowsLeft -= 1.0;
    // Most rows need less than their share.
    return 2.0 * std::max(this->Budget - this->GetElapsed(), 0.0) / std::max(this->RowsLeft, 1.0);
  }
  void Print(const std::string& text) const
  {
    std::cout << static_cast<int>(this->GetElapsed()) << " s  " << text << std::endl;
  }

private:
  double GetElapsed() const
  {
    const auto elapsed = std::chrono::steady_clock::now() - this->Start;
    return std::chrono::duration<double>(elapsed).count();
  }

  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  double Budget;
  double RowsLeft;
};

void MeasureMesh(
  const ReportMeshes::Mesh& mesh, const Plan& plan, std::ostream& csv, Progress& progress)
{
  ReportScene scene(mesh, plan.Settings);
  std::vector<ReportMethods::Method> methods = plan.Methods;
  const std::vector<ReportMethods::Method> levels = ReportMethods::OfLevels(mesh.Levels);
  methods.insert(methods.end(), levels.begin(), levels.end());
  KeepMethods(plan.Name, methods);
  for (const char* transfer : { "smooth", "spiky" })
  {
    for (const char* light : { "unlit", "lit" })
    {
      scene.SetLook(transfer, light);
      for (const ReportMethods::Method& method : methods)
      {
        ReportRow row;
        if (scene.Measure(method, progress.GetSecondsForNextRow(), row))
        {
          row.Write(csv);
          progress.Print(row.GetSummary());
        }
      }
    }
  }
}
}

int main(int argc, char* argv[])
{
  std::ofstream csv(argc > 1 ? argv[1] : "");
  if (!csv)
  {
    std::cerr << "cannot write " << (argc > 1 ? argv[1] : "the table: name a file") << "\n";
    return EXIT_FAILURE;
  }
  Plan plan = MakePlan(argc > 2 ? argv[2] : "full");
  plan.Name = argc > 3 ? argv[3] : "";
  KeepMesh(argc > 4 ? argv[4] : "", plan.Meshes);
  ReportRow::WriteHeader(csv);
  Progress progress(plan);
  for (const ReportMeshes::Mesh& mesh : plan.Meshes)
  {
    MeasureMesh(mesh, plan, csv, progress);
  }
  return EXIT_SUCCESS;
}
