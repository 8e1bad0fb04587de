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
        this->TakeTurn(frame, contender);
      }
    }
  }
}

//------------------------------------------------------------------------------
void FramesInTurns::TakeTurn(int frame, Contender& contender) const
{
  double spent = 0.0;
  int drawn = 0;
  do
  {
    contender.Seconds->push_back(contender.Time(1 + (frame - 1 + drawn) % this->Frames));
    spent += contender.Seconds->back();
    ++drawn;
  } while (drawn < this->Frames && spent < this->SecondsPerTurn);
  contender.Spent += spent;
}
