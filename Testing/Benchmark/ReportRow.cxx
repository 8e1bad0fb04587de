#include "ReportRow.h"

#include "BenchmarkScene.h"

#include <cstdio>

namespace
{
std::string Quoted(const std::string& text)
{
  return '"' + text + '"';
}

std::string Number(double value, const char* format = "%.4g")
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string NotNegative(double value, const char* format)
{
  return value < 0.0 ? "" : Number(value, format);
}
}

//------------------------------------------------------------------------------
void ReportRow::WriteHeader(std::ostream& stream)
{
  stream << "scene,cells,transfer,light,method,setting,engine,sort,blend,frames,median_ms,first_ms,"
            "prepare_ms,mcells_per_s,ratio_to_vtk,rmse,p999,maximum,share_above_half_level,"
            "rmse_outside,maximum_inside,misordered_faces,levels_to_shirley_tuchman"
         << std::endl;
}

//------------------------------------------------------------------------------
void ReportRow::Write(std::ostream& stream) const
{
  const double median = Median(this->Frames);
  const std::string columns[] = { Quoted(this->Scene), std::to_string(this->Cells), this->Transfer,
    this->Light, Quoted(this->Curve), this->Setting, this->Engine, this->Sort, this->Blend,
    std::to_string(this->Frames.size()), Number(1e3 * median), Number(1e3 * this->First),
    Number(1e3 * this->Prepare), Number(1e-6 * static_cast<double>(this->Cells) / median),
    Number(this->Reference / median), Number(this->Errors.GetRootMeanSquare()),
    Number(this->Errors.GetPercentile()), Number(this->Errors.GetMaximum()),
    Number(this->Errors.GetShare()), Number(this->Errors.GetRootMeanSquareOutside()),
    NotNegative(this->Errors.GetMaximumInside(), "%.4g"),
    NotNegative(static_cast<double>(this->MisorderedFaces), "%.0f"),
    NotNegative(this->ToShirleyTuchman, "%.4g") };
  const char* separator = "";
  for (const std::string& column : columns)
  {
    stream << separator << column;
    separator = ",";
  }
  stream << std::endl;
}

//------------------------------------------------------------------------------
std::string ReportRow::GetSummary() const
{
  const std::string name = this->Curve + (this->Setting.empty() ? "" : " " + this->Setting);
  char text[256];
  std::snprintf(text, sizeof(text), "%-12s %-6s %-5s %-34s %8.1f ms  %6.2f x  RMSE %8.2e  max %8.2e",
    this->Scene.c_str(), this->Transfer.c_str(), this->Light.c_str(), name.c_str(),
    1e3 * Median(this->Frames), this->Reference / Median(this->Frames), this->Errors.GetRootMeanSquare(),
    this->Errors.GetMaximum());
  return text;
}
