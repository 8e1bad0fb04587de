// Nodes of the transfer function that lie on one line, to 1e-6 of their values, are one piece of the
// tiles' function; any other bend, step or zero stays; and what is merged does not drift.

#include "TestScene.h"
#include "TileTransfer.h"
#include "TransferFunction.h"

#include <algorithm>
#include <cmath>

namespace
{
struct Node
{
  double Position;
  TransferFunction::Sample Value;
};
using Nodes = std::vector<Node>;

TransferFunction::Sample Evaluate(const Nodes& nodes, double at)
{
  std::size_t i = 1;
  while (i + 1 < nodes.size() && nodes[i].Position <= at)
  {
    ++i;
  }
  const Node &a = nodes[i - 1], &b = nodes[i];
  const double share = std::clamp((at - a.Position) / (b.Position - a.Position), 0.0, 1.0);
  TransferFunction::Sample value;
  for (int k = 0; k < 4; ++k)
  {
    value[k] = a.Value[k] + share * (b.Value[k] - a.Value[k]);
  }
  return value;
}

TransferFunction MakeFunction(const Nodes& nodes)
{
  std::vector<double> candidates;
  for (const Node& node : nodes)
  {
    candidates.push_back(node.Position);
  }
  const double range[2] = { 0.0, 1.0 };
  TransferFunction function;
  function.Build(
    candidates, [&](double at) { return Evaluate(nodes, at); }, range, range, 1.0);
  return function;
}

// Between the constants beyond both ends.
int CountPieces(const Nodes& nodes)
{
  TileTransfer transfer;
  transfer.Build(MakeFunction(nodes), 1.0);
  return transfer.NumberOfPieces - 2;
}

// The largest difference to the nodes' function, as a share of its value there.
double LargestError(const Nodes& nodes, const TileTransfer& transfer)
{
  double largest = 0.0;
  for (int i = 0; i <= 5000; ++i)
  {
    const auto at = static_cast<float>(i / 5000.0);
    const TransferFunction::Sample expected = Evaluate(nodes, at);
    int piece = 0;
    while (piece + 1 < transfer.NumberOfPieces && transfer.Bounds[piece + 1] <= at)
    {
      ++piece;
    }
    for (int k = 0; k < 4; ++k)
    {
      const double found = double(transfer.Slopes[k][piece]) * at + transfer.Offsets[k][piece];
      largest = std::max(largest, std::abs(found - expected[k]) / expected[k]);
    }
  }
  return largest;
}

// All four ramps, of ten nodes; one of them off the line by a share of its value.
Nodes Ramp(int component, double off)
{
  Nodes nodes;
  for (int i = 0; i < 10; ++i)
  {
    const double at = i / 9.0;
    nodes.push_back({ at, { 0.2 + 0.5 * at, 0.9 - 0.7 * at, 0.4, 3.0 + 5.0 * at } });
  }
  nodes[4].Value[component] *= 1.0 + off;
  return nodes;
}

void TestBends(TestChecks& checks)
{
  for (int component = 0; component < 4; ++component)
  {
    CHECK(CountPieces(Ramp(component, 0.0)) == 1);
    CHECK(CountPieces(Ramp(component, 3e-7)) == 1);
    for (const double off : { 2e-5, -2e-5, 1e-3, 0.1 })
    {
      CHECK(CountPieces(Ramp(component, off)) == 4); // before, up, down, after
    }
  }
}

// A bend from zero is one however small: what is transparent stays so.
void TestZero(TestChecks& checks)
{
  for (const double end : { 1.0, 1e-6, 1e-12 })
  {
    const Nodes nodes = { { 0.0, { 1, 1, 1, 0 } }, { 0.5, { 1, 1, 1, 0 } }, { 1.0, { 1, 1, 1, end } } };
    CHECK(CountPieces(nodes) == 1); // the first half goes on from the constant before it
  }
}

// Each node bends the line by less than the tolerance, all together by much more.
void TestDrift(TestChecks& checks)
{
  Nodes nodes;
  for (int i = 0; i <= 1000; ++i)
  {
    const double at = i / 1000.0, bent = 1.0 + 0.3 * at + 0.05 * at * at;
    nodes.push_back({ at, { 0.5 * bent, 0.4 * bent, 0.3 * bent, 2.0 * bent } });
  }
  TileTransfer transfer;
  transfer.Build(MakeFunction(nodes), 1.0);
  const double error = LargestError(nodes, transfer);
  std::cout << "1001 nodes, " << transfer.NumberOfPieces << " pieces, off by " << error << "\n";
  CHECK(transfer.NumberOfPieces < 500);
  CHECK(transfer.NumberOfPieces > 50);
  CHECK_AT_MOST(error, 2e-6);
}

// Nothing is seen below .2, between .4 and .6 (where a colour bends), and from .8 on.
void TestSeen(TestChecks& checks)
{
  const Nodes nodes = { { 0.0, { 1, 1, 1, 0 } }, { 0.2, { 1, 1, 1, 0 } }, { 0.3, { 1, 1, 1, 2 } },
    { 0.4, { 1, 1, 1, 0 } }, { 0.5, { 0, 1, 1, 0 } }, { 0.6, { 1, 1, 1, 0 } },
    { 0.7, { 1, 1, 1, 1e-9 } }, { 0.8, { 1, 1, 1, 0 } }, { 1.0, { 1, 1, 1, 0 } } };
  TileTransfer transfer;
  transfer.Build(MakeFunction(nodes), 1.0);
  CHECK(transfer.HasTransparent);
  const struct
  {
    double At, From, To;
  } expected[] = { { 0.1, 0.2, -1e30 }, { 0.25, -1e30, 1e30 }, { 0.35, -1e30, 1e30 },
    { 0.45, 0.6, 0.4 }, { 0.55, 0.6, 0.4 }, { 0.65, -1e30, 1e30 }, { 0.75, -1e30, 1e30 },
    { 0.9, 1e30, 0.8 } };
  for (const auto& place : expected)
  {
    const auto bound = std::upper_bound(transfer.Bounds.begin(),
      transfer.Bounds.begin() + transfer.NumberOfPieces, static_cast<float>(place.At));
    const auto piece = static_cast<std::size_t>(bound - transfer.Bounds.begin()) - 1;
    CHECK(transfer.SeenFrom[piece] == static_cast<float>(place.From));
    CHECK(transfer.SeenTo[piece] == static_cast<float>(place.To));
  }
  transfer.Build(MakeFunction(Ramp(3, 0.0)), 1.0);
  CHECK(!transfer.HasTransparent);
}
}

int TestTileTransfer(int, char*[])
{
  TestChecks checks;
  TestBends(checks);
  TestZero(checks);
  TestDrift(checks);
  TestSeen(checks);
  return checks.Result();
}
