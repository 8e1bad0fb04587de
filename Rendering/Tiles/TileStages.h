/**
 * The stages of a frame by Tiles, and the seconds of each; of those within tiles the mean of all
 * threads.
 */
#ifndef TileStages_h
#define TileStages_h

#include <numeric>

struct TileStages
{
  enum Stage
  {
    Cull,      // clusters that are not seen
    Transform, // points to the screen
    Box,       // boxes of cells, signs of faces
    Bin,       // lists of tiles
    Order,     // within tiles, as all below
    SetUp,     // planes
    Cover,     // entry and exit of rays
    Shade,     // colour and opacity
    Composite, // and the proof of the order
    Repair,    // pieces of marked pixels found and sorted; projected again they count above
    Write,     // clearing tiles and writing them
    Wait,      // threads that have no tile
    Other,     // of no stage
    Count
  };

  static const char* GetName(int stage)
  {
    static const char* const names[Count] = { "Cull", "Transform", "Box", "Bin", "Order", "SetUp",
      "Cover", "Shade", "Composite", "Repair", "Write", "Wait", "Other" };
    return names[stage];
  }

  void Add(const TileStages& other, double share = 1.0)
  {
    for (int stage = 0; stage < Count; ++stage)
    {
      this->Seconds[stage] += share * other.Seconds[stage];
    }
  }
  double GetSum() const
  {
    return std::accumulate(this->Seconds, this->Seconds + Count, 0.0);
  }

  double Seconds[Count] = {};
};

#endif
