#include "TileRepair.h"

#include "TileBox.h"
#include "TileBuffer.h"
#include "TileFragments.h"
#include "TileTask.h"
#include "TileView.h"

#include <algorithm>
#include <numeric>
#include <tuple>

//------------------------------------------------------------------------------
int TileRepair::Find(const TileBuffer& tile)
{
  this->Fragments.clear();
  this->Taken = 0;
  if (!tile.HasWrong)
  {
    return 0;
  }
  this->Marked.assign(tile.Wrong, tile.Wrong + TileBuffer::Size);
  return std::accumulate(this->Marked.begin(), this->Marked.end(), 0);
}

//------------------------------------------------------------------------------
TileRectangle TileRepair::Box(const TileRectangle& tile) const
{
  TileRectangle box{ tile.Left, tile.Bottom, tile.LastX, tile.LastY, tile.FirstX, tile.FirstY };
  for (int pixel = 0; pixel < TileBuffer::Size; ++pixel)
  {
    if (this->Marked[pixel])
    {
      const int x = tile.Left + pixel % TileSize::Pixels;
      const int y = tile.Bottom + pixel / TileSize::Pixels;
      box.FirstX = std::min(box.FirstX, x);
      box.LastX = std::max(box.LastX, x);
      box.FirstY = std::min(box.FirstY, y);
      box.LastY = std::max(box.LastY, y);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
void TileRepair::KeepCells(std::vector<int>& cells, const std::vector<std::uint32_t>& boxes) const
{
  static_assert(TileSize::Pixels == 64, "a row of marks is one word");
  std::uint64_t rows[TileSize::MostRows] = {};
  std::uint64_t columns = 0;
  for (int pixel = 0; pixel < TileBuffer::Size; ++pixel)
  {
    const auto mark = std::uint64_t(this->Marked[pixel] != 0) << pixel % TileSize::Pixels;
    rows[pixel / TileSize::Pixels] |= mark;
    columns |= mark;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const TileBox box(boxes[i]);
    const std::uint64_t span =
      box.Width == 0 ? 0 : ~std::uint64_t(0) >> (64 - box.Width) << box.X;
    const std::uint64_t* row = rows + box.Y;
    cells[kept] = cells[i];
    kept += (span & columns) != 0 &&
      std::any_of(row, row + box.Height, [span](std::uint64_t marks) { return (marks & span) != 0; });
  }
  cells.resize(kept);
}

//------------------------------------------------------------------------------
void TileRepair::Collect(const TileFragments& q)
{
  for (int i = 0; i < q.Count; ++i)
  {
    if (this->Marked[q.Pixel[i]])
    {
      this->Fragments.push_back({ q.Entry[i], q.Extent[i], q.ScalarIn[i], q.ScalarOut[i],
        q.Pixel[i], q.Cell[i], 0.0f, static_cast<unsigned int>(this->Fragments.size()) });
    }
  }
}

//------------------------------------------------------------------------------
void TileRepair::Sort(const TileView& view)
{
  for (Fragment& fragment : this->Fragments)
  {
    const double in = fragment.Entry, out = in - fragment.Extent;
    // Twice the depth of the middle: in perspective u is 1 / depth.
    const double weightIn = view.WeightScale * in + view.WeightOffset;
    const double weightOut = view.WeightScale * out + view.WeightOffset;
    const double depth = view.WeightScale > 0.0 ? (weightIn + weightOut) / (weightIn * weightOut) -
                                                    2.0 / view.WeightOffset
                                                : -(in + out);
    fragment.Depth = static_cast<float>(depth);
  }
  std::sort(this->Fragments.begin(), this->Fragments.end(),
    [](const Fragment& a, const Fragment& b)
    { return std::tie(a.Pixel, a.Depth, a.Place) < std::tie(b.Pixel, b.Depth, b.Place); });
}

//------------------------------------------------------------------------------
void TileRepair::Clear(TileBuffer& tile) const
{
  for (int pixel = 0; pixel < TileBuffer::Size; ++pixel)
  {
    if (this->Marked[pixel])
    {
      tile.Pixels[pixel] = { 0.0f, 0.0f, 0.0f, 1.0f };
    }
  }
}

//------------------------------------------------------------------------------
bool TileRepair::Take(TileFragments& out)
{
  out.Count = 0;
  while (this->Taken < this->Fragments.size() && out.Count < out.Full)
  {
    const Fragment& fragment = this->Fragments[this->Taken++];
    const int at = out.Count++;
    out.Entry[at] = fragment.Entry;
    out.Extent[at] = fragment.Extent;
    out.ScalarIn[at] = fragment.ScalarIn;
    out.ScalarOut[at] = fragment.ScalarOut;
    out.Pixel[at] = fragment.Pixel;
    out.Cell[at] = fragment.Cell;
  }
  return out.Count > 0;
}
