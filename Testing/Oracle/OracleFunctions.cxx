#include "OracleFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
OracleFunctions::OracleFunctions(vtkVolumeProperty* property)
  : Opacity(property->GetScalarOpacity())
  , UnitDistance(property->GetScalarOpacityUnitDistance())
{
  if (property->HasGradientOpacity() && !property->GetDisableGradientOpacity())
  {
    this->GradientOpacity = property->GetGradientOpacity();
  }
  this->AddOpacityBreaks(this->Opacity);
  if (property->GetColorChannels() == 1)
  {
    this->Gray = property->GetGrayTransferFunction();
    this->AddOpacityBreaks(this->Gray);
  }
  else
  {
    this->Color = property->GetRGBTransferFunction();
    this->Color->Build();
    this->AddColorBreaks(this->Color);
  }
  std::sort(this->Breaks.begin(), this->Breaks.end());
  this->Breaks.erase(std::unique(this->Breaks.begin(), this->Breaks.end()), this->Breaks.end());
  // A first evaluation here lets the functions finish what they do lazily, before threads start.
  this->AskColor(this->Breaks.empty() ? 0.0 : this->Breaks.front());
  this->AskOpacity(this->Breaks.empty() ? 0.0 : this->Breaks.front());
  for (std::size_t i = 1; i < this->Breaks.size(); ++i)
  {
    this->Lines.push_back(this->MakeLine(this->Breaks[i - 1], this->Breaks[i]));
  }
}

//------------------------------------------------------------------------------
OracleFunctions::Line OracleFunctions::MakeLine(double first, double last) const
{
  // Inside: a step may lie at either end.
  const double start = first + 0.1 * (last - first), end = first + 0.9 * (last - first);
  Line line;
  line.Start = start;
  line.Values = this->AskValues(start);
  line.IsExact = start < end;
  const Values values = this->AskValues(end);
  for (int channel = 0; channel < 4; ++channel)
  {
    line.Slopes[channel] = (values[channel] - line.Values[channel]) / (end - start);
  }
  // Uneven places: no function with even steps is on the line at all of them.
  for (const double share :
    { 0.0013, 0.0717, 0.1931, 0.3347, 0.4129, 0.5381, 0.6673, 0.8219, 0.9411, 0.9987 })
  {
    const double scalar = first + share * (last - first);
    const Values found = this->AskValues(scalar);
    for (int channel = 0; channel < 4; ++channel)
    {
      const double error = std::abs(line.GetValue(channel, scalar) - found[channel]);
      line.IsExact = line.IsExact && error <= 1e-14 * std::max(1.0, std::abs(found[channel]));
    }
  }
  return line;
}

//------------------------------------------------------------------------------
const OracleFunctions::Line* OracleFunctions::FindLine(double scalar) const
{
  // At a break itself VTK says which side counts; nothing is found for what is no number.
  const auto next = std::upper_bound(this->Breaks.begin(), this->Breaks.end(), scalar);
  if (next == this->Breaks.begin() || next == this->Breaks.end() || !(*(next - 1) < scalar))
  {
    return nullptr;
  }
  const Line& line = this->Lines[next - this->Breaks.begin() - 1];
  return line.IsExact ? &line : nullptr;
}

//------------------------------------------------------------------------------
OracleFunctions::Values OracleFunctions::GetValues(double scalar) const
{
  const Line* line = this->FindLine(scalar);
  return line ? Values{ line->GetValue(0, scalar), line->GetValue(1, scalar),
                  line->GetValue(2, scalar), line->GetValue(3, scalar) }
              : this->AskValues(scalar);
}

//------------------------------------------------------------------------------
OracleFunctions::Values OracleFunctions::AskValues(double scalar) const
{
  const std::array<double, 3> color = this->AskColor(scalar);
  return { color[0], color[1], color[2], this->AskOpacity(scalar) };
}

//------------------------------------------------------------------------------
std::array<double, 3> OracleFunctions::GetColor(double scalar) const
{
  const Values values = this->GetValues(scalar);
  return { values[0], values[1], values[2] };
}

//------------------------------------------------------------------------------
double OracleFunctions::GetOpacity(double scalar) const
{
  return this->GetValues(scalar)[3];
}

//------------------------------------------------------------------------------
std::array<double, 3> OracleFunctions::AskColor(double scalar) const
{
  std::array<double, 3> color;
  if (this->Gray)
  {
    color.fill(this->Gray->GetValue(scalar));
  }
  else
  {
    this->Color->GetColor(scalar, color.data());
  }
  return color;
}

//------------------------------------------------------------------------------
double OracleFunctions::AskOpacity(double scalar) const
{
  return std::max(this->Opacity->GetValue(scalar), 0.0);
}

//------------------------------------------------------------------------------
double OracleFunctions::GetGradientOpacity(double magnitude) const
{
  return this->GradientOpacity ? this->GradientOpacity->GetValue(magnitude) : 1.0;
}

//------------------------------------------------------------------------------
void OracleFunctions::AddNode(
  double position, double midpoint, bool logarithmic, double next, bool isLast)
{
  this->Breaks.push_back(position);
  if (!isLast)
  {
    this->Breaks.push_back(logarithmic && position > 0.0
                             ? position * std::pow(next / position, midpoint)
                             : position + midpoint * (next - position));
  }
}

//------------------------------------------------------------------------------
void OracleFunctions::AddOpacityBreaks(vtkPiecewiseFunction* function)
{
  const int size = function->GetSize();
  double node[4], next[4];
  for (int index = 0; index < size; ++index)
  {
    const bool isLast = index + 1 == size;
    function->GetNodeValue(index, node);
    function->GetNodeValue(isLast ? index : index + 1, next);
    this->AddNode(node[0], node[2], function->GetUseLogScale(), next[0], isLast);
  }
}

//------------------------------------------------------------------------------
void OracleFunctions::AddColorBreaks(vtkColorTransferFunction* function)
{
  const int size = function->GetSize();
  double node[6], next[6];
  for (int index = 0; index < size; ++index)
  {
    const bool isLast = index + 1 == size;
    function->GetNodeValue(index, node);
    function->GetNodeValue(isLast ? index : index + 1, next);
    const bool logarithmic = function->GetScale() == VTK_CTF_LOG10;
    this->AddNode(node[0], node[4], logarithmic, next[0], isLast);
    if (!isLast && function->GetColorSpace() != VTK_CTF_RGB)
    {
      this->AddKinks(node[0], next[0]);
    }
  }
}

//------------------------------------------------------------------------------
void OracleFunctions::AddKinks(double first, double last)
{
  const int count = 256;
  for (int i = 0; i < count; ++i)
  {
    // The ends stay out: a step at a node is no kink between the nodes.
    const double a = first + (last - first) * (i + 0.1) / (count + 0.2);
    const double b = first + (last - first) * (i + 1.1) / (count + 0.2);
    if (this->GetSector(a) != this->GetSector(b))
    {
      this->Breaks.push_back(this->FindKink(a, b));
    }
  }
}

//------------------------------------------------------------------------------
double OracleFunctions::FindKink(double first, double last) const
{
  const int sector = this->GetSector(first);
  for (int step = 0; step < 60; ++step)
  {
    const double middle = (first + last) / 2.0;
    (this->GetSector(middle) == sector ? first : last) = middle;
  }
  return (first + last) / 2.0;
}

//------------------------------------------------------------------------------
int OracleFunctions::GetSector(double scalar) const
{
  const std::array<double, 3> color = this->AskColor(scalar);
  int sector = 0;
  for (int channel = 0; channel < 3; ++channel)
  {
    const bool isBlack = color[channel]<1e-12, isFull = color[channel]> 1.0 - 1e-12;
    sector = 3 * sector + (isBlack ? 0 : (isFull ? 2 : 1));
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    sector = 2 * sector + (color[channel] > color[(channel + 1) % 3]);
  }
  return sector;
}
