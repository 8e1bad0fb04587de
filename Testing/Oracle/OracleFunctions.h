/**
 * The colour and opacity functions of a volume property, evaluated in double by VTK itself.
 *
 * Colour is the RGB or the gray function, by the property's colour channels, linear 0..1 per
 * channel. Component 0 of the property is read, the interpolation type is not. Between two breaks where
 * VTK's values lie on a line the line is taken, which is the same to the last places and takes no
 * search in VTK's lists. Evaluation is thread-safe after construction, while nobody modifies the
 * property.
 */

#ifndef OracleFunctions_h
#define OracleFunctions_h

#include <array>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

class OracleFunctions
{
public:
  /** The property must outlive this object; its unit distance must be positive. */
  explicit OracleFunctions(vtkVolumeProperty* property);

  /** RGB and opacity. */
  using Values = std::array<double, 4>;
  Values GetValues(double scalar) const;

  std::array<double, 3> GetColor(double scalar) const;

  /** What is below 0 counts as 0. */
  double GetOpacity(double scalar) const;

  /** 1 where the property has none, or it is disabled. */
  double GetGradientOpacity(double magnitude) const;
  bool HasGradientOpacity() const { return this->GradientOpacity != nullptr; }

  /** Opacity per world length. */
  double GetExtinction(const Values& values) const { return values[3] / this->UnitDistance; }

  /**
   * Ascending scalars between which both functions are smooth: their nodes, the midpoints between
   * nodes, where a sharp function steps, and the kinks of colour spaces that are not linear (a new
   * sector of the hue, a channel that is clamped), which are searched for. Steps anywhere else (a
   * discretised function) are left to the integration.
   */
  const std::vector<double>& GetBreaks() const { return this->Breaks; }

private:
  // What both functions are between two breaks: `Values` at `Start` (RGB, opacity), then `Slopes`.
  struct Line
  {
    double Start = 0.0;
    std::array<double, 4> Values = {};
    std::array<double, 4> Slopes = {};
    bool IsExact = false;

    double GetValue(int channel, double scalar) const
    {
      return this->Values[channel] + this->Slopes[channel] * (scalar - this->Start);
    }
  };

  void AddNode(double position, double midpoint, bool logarithmic, double next, bool isLast);
  void AddOpacityBreaks(vtkPiecewiseFunction* function);
  void AddColorBreaks(vtkColorTransferFunction* function);
  void AddKinks(double first, double last);
  double FindKink(double first, double last) const;
  int GetSector(double scalar) const;
  Line MakeLine(double first, double last) const;
  const Line* FindLine(double scalar) const;
  Values AskValues(double scalar) const;
  std::array<double, 3> AskColor(double scalar) const;
  double AskOpacity(double scalar) const;

  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Gray = nullptr;
  vtkPiecewiseFunction* Opacity = nullptr;
  vtkPiecewiseFunction* GradientOpacity = nullptr;
  double UnitDistance = 1.0;
  std::vector<double> Breaks;
  std::vector<Line> Lines; // one from each break to the next
};

#endif
