// SPDX-License-Identifier: BSD-3-Clause
// Tests whether two points on surfaces see each other. All classes have the same form: a type End,
// FindEnd(position, normal) and IsVisible(End, End). vtkIndirectSightLines tests the surfaces
// themselves, vtkIndirectVoxelLines the voxels.
#ifndef vtkIndirectSegmentTests_h
#define vtkIndirectSegmentTests_h

#include "Visibility/vtkIndirectSphereGrid.h" // for spheres

#include <glm/glm.hpp> // for vectors

// vtkIndirectSphereLines tests the lists of spheres, as shaders do.
struct vtkIndirectSphereLines
{
  using End = glm::dvec3;
  const vtkIndirectSphereGrid& Grid;

  End FindEnd(const glm::dvec3& position, const glm::dvec3&) const { return position; }
  bool IsVisible(const End& a, const End& b) const { return this->Grid.IsFree(a, b); }
};

// vtkIndirectBothLines combines two tests, either of which hides.
template <typename First, typename Second>
struct vtkIndirectBothLines
{
  struct End
  {
    typename First::End OfFirst;
    typename Second::End OfSecond;
  };
  First One;
  Second Other;

  End FindEnd(const glm::dvec3& position, const glm::dvec3& normal) const
  {
    return { this->One.FindEnd(position, normal), this->Other.FindEnd(position, normal) };
  }
  bool IsVisible(const End& a, const End& b) const
  {
    return this->One.IsVisible(a.OfFirst, b.OfFirst) &&
      this->Other.IsVisible(a.OfSecond, b.OfSecond);
  }
};

// vtkIndirectOpenLines hides nothing.
struct vtkIndirectOpenLines
{
  struct End
  {
  };
  End FindEnd(const glm::dvec3&, const glm::dvec3&) const { return {}; }
  bool IsVisible(const End&, const End&) const { return true; }
};

#endif
