// Speed against error: every method of ours and of VTK's on several meshes, each with a smooth and
// a spiky transfer function, unlit and lit. One CSV row per method and look, one line of progress.
//   CellProjectionReport FILE.csv [full|quick|tiny]; the data's folder is in CELLPROJECTION_DATA

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
  // Rows get their share of what is left of it.
  double Seconds = 2100.0;
};

Plan MakePlan(const std::string& kind)
{
  const char* variable = std::getenv("CELLPROJECTION_DATA");
  const std::string folder = variable ? variable : "";
  Plan plan;
  if (kind == "tiny")
  {
    plan.Meshes = { ReportMeshes::MakeLattice(4) };
    plan.Methods = ReportMethods::Few();
    plan.Settings = { 3, 64, 32, 1 };
    plan.Seconds = 10.0;
  }
  else if (kind == "quick")
  {
    plan.Meshes = ReportMeshes::Read(folder, { "disk_out_ref" });
    plan.Meshes.push_back(ReportMeshes::MakeLattice(12));
    plan.Settings = { 3, 256, 48, 1 };
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

/// Tells how far it is, and how long the next row may take.
class Progress
{
public:
  explicit Progress(const Plan& plan)
    : Budget(plan.Seconds)
    // Two transfer functions, unlit and lit; a method that is not lit leaves its share to others.
    , RowsLeft(4.0 * static_cast<double>(plan.Meshes.size() * plan.Methods.size()))
  {
  }

  double GetSecondsForNextRow()
  {
    this->RowsLeft -= 1.0;
    return 1.5 * std::max(this->Budget - this->GetElapsed(), 0.0) / std::max(this->RowsLeft, 1.0);
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
  for (const char* transfer : { "smooth", "spiky" })
  {
    for (const char* light : { "unlit", "lit" })
    {
      scene.SetLook(transfer, light);
      for (const ReportMethods::Method& method : plan.Methods)
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
  const Plan plan = MakePlan(argc > 2 ? argv[2] : "full");
  ReportRow::WriteHeader(csv);
  Progress progress(plan);
  for (const ReportMeshes::Mesh& mesh : plan.Meshes)
  {
    MeasureMesh(mesh, plan, csv, progress);
  }
  return EXIT_SUCCESS;
}
