#include "FramesInTurns.h"

//------------------------------------------------------------------------------
void FramesInTurns::Add(const Timer& time, std::vector<double>& seconds, double limit)
{
  this->Contenders.push_back({ time, &seconds, limit });
}

//------------------------------------------------------------------------------
void FramesInTurns::Draw()
{
  for (int frame = 1; frame <= this->Frames; ++frame)
  {
    for (Contender& contender : this->Contenders)
    {
      if (contender.Spent < contender.Limit)
      {
        contender.Seconds->push_back(contender.Time(frame));
        contender.Spent += contender.Seconds->back();
      }
    }
  }
}
