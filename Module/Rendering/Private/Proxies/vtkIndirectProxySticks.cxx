// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxySticks.h"

#include "Scene/vtkIndirectImpostors.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
int vtkIndirectProxySticks::FindRow(double length, double radius, double& radiusOfSpheres)
{
  radiusOfSpheres = 0.0;
  if (!(length > 0.0) || !(radius > 0.0) || !std::isfinite(length) || !std::isfinite(radius))
  {
    return 0;
  }
  // Clamped before the conversion to an integer.
  const double touching =
    std::min(std::max(length / (2.0 * radius), 1.0), double(MostSpheresOfAStick));
  const int count = static_cast<int>(std::lround(touching));
  radiusOfSpheres = std::sqrt(0.5 * length * radius / count);
  return count;
}

//------------------------------------------------------------------------------
int vtkIndirectProxySticks::FindRowInside(double length, double radius)
{
  if (!(length > 0.0) || !(radius > 0.0) || !std::isfinite(length) || !std::isfinite(radius))
  {
    return 0;
  }
  return static_cast<int>(std::min(std::ceil(length / radius), double(MostSpheresInsideAStick)));
}

//------------------------------------------------------------------------------
// As vtkOpenGLStickMapper draws sticks: centred at their points, with length and radius in the
// first two components of their scales.
void vtkIndirectProxySticks::ForEach(vtkMapper* mapper, vtkDataSet* data, RowType type,
  const std::function<void(vtkIdType, const double[3], double)>& call)
{
  vtkDataArray* scales = vtkIndirectImpostors::FindStickScales(mapper, data);
  vtkDataArray* ways = vtkIndirectImpostors::FindStickDirections(mapper, data);
  if (!scales || !ways)
  {
    return;
  }
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double middle[3];
    double way[3];
    data->GetPoint(i, middle);
    ways->GetTuple(i, way);
    // The drawn length is the product of both.
    const double length = scales->GetComponent(i, 0) * vtkMath::Norm(way);
    double radius = scales->GetComponent(i, 1);
    const int count =
      type == INSIDE ? FindRowInside(length, radius) : FindRow(length, radius, radius);
    vtkMath::Normalize(way);
    for (int k = 0; k < count; ++k)
    {
      const double along = length * ((k + 0.5) / count - 0.5);
      const double place[3] = { middle[0] + along * way[0], middle[1] + along * way[1],
        middle[2] + along * way[2] };
      call(i, place, radius);
    }
  }
}
