#ifndef ReportRow_h
#define ReportRow_h

#include "ReportErrors.h"

#include <fstream>
#include <string>
#include <vector>

/// One line of the report's CSV.
struct ReportRow
{
  std::string Scene;
  long long Cells = 0;
  std::string Transfer;
  std::string Light;
  std::string Curve;
  std::string Setting;
  std::string Engine;
  std::string Sort;
  std::string Blend;
  double First = 0.0;   // seconds, as the next
  double Prepare = 0.0; // of the first frame; 0 where the mapper does not say
  std::vector<double> Frames;
  double Reference = 0.0; // median of VTK's projected tetrahedra in the same run
  ReportErrors Errors;
  long long MisorderedFaces = -1; // most of the views; below zero where there is no order
  double ToShirleyTuchman = -1.0; // mean over covered pixels, in levels of 255; below zero: not asked

  static void WriteHeader(std::ostream& stream);
  void Write(std::ostream& stream) const;
  std::string GetSummary() const;
};

#endif
