#include "TileRepair.h"

#include "TileBox.h"
#include "TileBuffer.h"
#include "TileFragments.h"
#include "TileTask.h"
#include "TileView.h"

#include <algorithm>
#include <numeric>

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
      this->Fragments.push_back(
        { q.Entry[i], q.Extent[i], q.ScalarIn[i], q.ScalarOut[i], q.Pixel[i], q.Cell[i] });
    }
  }
}

//------------------------------------------------------------------------------
float TileRepair::DepthOf(const Fragment& fragment, const TileView& view)
{
  const double in = fragment.Entry, out = in - fragment.Extent;
  // Twice the depth of the middle: in perspective u is 1 / depth.
  const double weightIn = view.WeightScale * in + view.WeightOffset;
  const double weightOut = view.WeightScale * out + view.WeightOffset;
  const double depth = view.WeightScale > 0.0
    ? (weightIn + weightOut) / (weightIn * weightOut) - 2.0 / view.WeightOffset
    : -(in + out);
  // What is not a number comes last: it would have no place in an order.
  return depth < 3e38 ? static_cast<float>(depth) : 3e38f;
}

//------------------------------------------------------------------------------
void TileRepair::SortPixel(Key* first, Key* last, Key* spare)
{
  // Pieces come in a few ascending runs: neighbouring ones are merged until one is left.
  auto isNearer = [](const Key& a, const Key& b) { return a.Depth < b.Depth; };
  while (!std::is_sorted(first, last, isNearer))
  {
    Key* merged = spare;
    for (Key* run = first; run != last;)
    {
      Key* const middle = std::is_sorted_until(run, last, isNearer);
      Key* const end = std::is_sorted_until(middle, last, isNearer);
      merged = std::merge(run, middle, middle, end, merged, isNearer);
      run = end;
    }
    std::copy(spare, merged, first);
  }
}

//------------------------------------------------------------------------------
void TileRepair::Sort(const TileView& view)
{
  this->Keys.resize(this->Fragments.size());
  this->Spare.resize(this->Fragments.size());
  this->Ends.assign(TileBuffer::Size + 1, 0);
  for (const Fragment& fragment : this->Fragments)
  {
    ++this->Ends[fragment.Pixel + 1];
  }
  std::partial_sum(this->Ends.begin(), this->Ends.end(), this->Ends.begin());
  // Where pixels begin; each moves to its end as its keys are placed.
  for (std::size_t i = 0; i < this->Fragments.size(); ++i)
  {
    const Fragment& fragment = this->Fragments[i];
    this->Keys[this->Ends[fragment.Pixel]++] = { DepthOf(fragment, view), static_cast<std::uint32_t>(i) };
  }
  std::uint32_t begin = 0;
  for (int pixel = 0; pixel < TileBuffer::Size; ++pixel)
  {
    const std::uint32_t end = this->Ends[pixel];
    SortPixel(this->Keys.data() + begin, this->Keys.data() + end, this->Spare.data());
    begin = end;
  }
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
  while (this->Taken < this->Keys.size() && out.Count < out.Full)
  {
    const Fragment& fragment = this->Fragments[this->Keys[this->Taken++].Fragment];
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

//------------------------------------------------------------------------------
std::size_t TileRepair::GetMemorySize() const
{
  return this->Fragments.capacity() * sizeof(Fragment) +
    (this->Keys.capacity() + this->Spare.capacity()) * sizeof(Key) +
    this->Ends.capacity() * sizeof(std::uint32_t) + this->Marked.capacity();
}
