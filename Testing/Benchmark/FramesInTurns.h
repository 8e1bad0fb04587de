#ifndef FramesInTurns_h
#define FramesInTurns_h

#include <functional>
#include <limits>
#include <vector>

/// Frames of several scenes in turns: a machine's clock changes from second to second, for neighbours in time alike.
/// A turn is a frame, and more while it is short. Measured: frames of 40 ms one by one between some of 1 and 8 s of one
/// thread take 1.02 to 1.1 times as long as those that follow each other, as in use.
class FramesInTurns
{
public:
  /// Seconds of the frame of that number, a new eye each.
  using Timer = std::function<double(int frame)>;

  /// `frames` turns of each scene and as many eyes, numbered from 1; a turn goes on for so many seconds, unless no eye is
  /// left that it has not seen.
  explicit FramesInTurns(int frames, double secondsPerTurn = 0.25)
    : Frames(frames)
    , SecondsPerTurn(secondsPerTurn)
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

  void TakeTurn(int frame, Contender& contender) const;

  int Frames;
  double SecondsPerTurn;
  std::vector<Contender> Contenders;
};

#endif
