#ifndef FramesInTurns_h
#define FramesInTurns_h

#include <functional>
#include <limits>
#include <vector>

/// Frames of several scenes, one of each in turn: a machine's clock changes from second to second, for neighbours in time alike.
/// Measured: a frame is no slower for coming after another mapper's seconds.
class FramesInTurns
{
public:
  /// Seconds of the frame of that number, a new eye each.
  using Timer = std::function<double(int frame)>;

  /// `frames` of each scene, numbered from 1.
  explicit FramesInTurns(int frames)
    : Frames(frames)
  {
  }

  /// The frames' seconds go to the end of `seconds`, which must outlive this; no more are drawn from `limit` seconds on.
  void Add(const Timer& time, std::vector<double>& seconds, double limit = std::numeric_limits<double>::infinity());

  void Draw();

private:
  struct Contender
  {
    Timer Time;
    std::vector<double>* Seconds;
    double Limit;
    double Spent = 0.0;
  };

  int Frames;
  std::vector<Contender> Contenders;
};

#endif
