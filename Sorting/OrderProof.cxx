#include "OrderProof.h"

#include "ExactOrientation.h"
#include "vtkSMPTools.h"

#include <atomic>

namespace OrderProof
{
//------------------------------------------------------------------------------
vtkIdType CountMisordered(
  const CellComplex& complex, const std::vector<vtkIdType>& order, const double eye[4])
{
  std::vector<vtkIdType> ranks(static_cast<size_t>(complex.NumberOfCells), -1);
  for (size_t rank = 0; rank < order.size(); ++rank)
  {
    ranks[order[rank]] = static_cast<vtkIdType>(rank);
  }
  const double* points = complex.Points.data();
  std::atomic<vtkIdType> misordered(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(complex.Contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType wrong = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const CellComplex::Contact& contact = complex.Contacts[i];
        const vtkIdType above = ranks[contact.Cells[0]];
        const vtkIdType below = ranks[contact.Cells[1]];
        if (above < 0 || below < 0)
        {
          continue;
        }
        const int side = ExactOrientation::SideOfEye(points, contact.Points, eye);
        // The cell on the eye's side has to come later.
        wrong += (side > 0 && above < below) || (side < 0 && below < above) ? 1 : 0;
      }
      misordered += wrong;
    });
  return misordered.load();
}
}
