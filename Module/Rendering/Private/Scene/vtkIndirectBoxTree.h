// SPDX-License-Identifier: BSD-3-Clause
// A tree of boxes, split by the surface-area heuristic in bins (Wald 2007, "On fast construction of
// SAH-based bounding volume hierarchies").
#pragma once

#include <cstdint>     // for numbers
#include <glm/glm.hpp> // for places
#include <limits>      // for empty boxes
#include <vector>      // for lists

class vtkIndirectBoxTree
{
public:
  struct Box
  {
    glm::dvec3 Lower{ std::numeric_limits<double>::infinity() };
    glm::dvec3 Upper{ -std::numeric_limits<double>::infinity() };

    void Add(const glm::dvec3& point)
    {
      this->Lower = glm::min(this->Lower, point);
      this->Upper = glm::max(this->Upper, point);
    }
    void Add(const Box& other)
    {
      this->Lower = glm::min(this->Lower, other.Lower);
      this->Upper = glm::max(this->Upper, other.Upper);
    }
    double HalfArea() const
    {
      const glm::dvec3 e = glm::max(this->Upper - this->Lower, glm::dvec3(0.0));
      return e.x * e.y + e.y * e.z + e.z * e.x;
    }
  };
  /** This is a node; two children lie side by side. */
  struct Part
  {
    Box Bounds;
    uint32_t First = 0; // child, or place of a leaf's first box in the order
    uint32_t Count = 0; // number of a leaf's boxes; 0: not a leaf
  };

  /** This is the largest number of levels. */
  static constexpr int Deepest = 64;

  explicit vtkIndirectBoxTree(const std::vector<Box>& boxes);

  /** Returns all nodes; the first one is the root. */
  const std::vector<Part>& GetParts() const { return this->Parts; }
  /** Returns the numbers of the boxes, leaf by leaf. */
  const std::vector<uint32_t>& GetOrder() const { return this->Order; }
  const Box& GetAll() const { return this->All; }
  /** Returns a place among most boxes: the median of their centres on each axis. */
  const glm::dvec3& GetMiddle() const { return this->Middle; }

private:
  // Splits are chosen by boxes of floats about the middle, as shares of the longest edge of all, in
  // vectors' lanes; the fourth lane is not used.
  struct alignas(16) Range
  {
    float Lower[4];
    float Upper[4];

    Range();
    void Add(const Range& other);
    float HalfArea() const;
  };
  struct Item
  {
    Range Bounds;
    uint32_t Number;
  };
  struct Job
  {
    uint32_t Node;
    uint32_t Begin;
    uint32_t End;
    int Depth;
  };
  struct Split;

  static Range FindCentre(const Item& item);
  Split FindSplit(uint32_t begin, uint32_t end, const Range& centres) const;
  uint32_t Divide(const Job& job);
  void MakeParts();
  void FindBounds(const std::vector<Box>& boxes);

  std::vector<Item> Items; // in the order; empty when the tree is there
  std::vector<uint32_t> Order;
  std::vector<Part> Parts;
  Box All;
  glm::dvec3 Middle{ 0.0 };
};
