// SPDX-License-Identifier: BSD-3-Clause
// Spheres in groups of groups: from afar a group is summed as one sphere that transmits a share of
// the light. After the hierarchies of Ren, Wang, Snyder, Zhou, Liu, Sun, Hua, Guo, Shum 2006,
// "Real-time soft shadows in dynamic scenes using spherical harmonic exponentiation".
//
// A group's sphere has the second moment of its spheres' cross sections, taken as a ball's; it
// hides the share of its disk that the silhouette of its spheres covers, averaged over directions.
// Spheres of a group lie beside each other rather than at random, and overlap less than random ones
// would, or are half inside of each other. Sums of logarithms hide a part twice if spheres lie
// behind each other; a group does not.
//
// Every entry holds the region where it counts: within `Outer` of its parent's centre, where the
// parent is too near to represent it, and beyond `Inner` of its own. Both limits are smooth, and at
// any position the weights of all entries that represent a sphere add up to one. So each entry can
// be tested alone, in any order.
#pragma once

#include "Proxies/vtkIndirectProxySphere.h" // for spheres

#include <vector> // for lists

class vtkIndirectProxyTree
{
public:
  struct Entry
  {
    glm::vec3 Center;
    float Radius;
    glm::vec3 OuterCenter;
    float Outer; // radius in which it counts, fully within VTKI_PROXY_BAND of that
    glm::vec3 Albedo;
    float Share; // hidden share of the light through its disk
    float Inner; // radius deep inside which it counts nothing; 0: none, for a sphere that
                 // represents a surface; -1: none, for a drawn sphere
    // index of the sender of its light: among the senders, or from there on among the means
    int Sender;
    int Next;    // the entry after it and its descendants, which follow it; -1: none
    float Bound; // radius about its centre that bounds the entry and its descendants
  };
  /**
   * This is a sphere whose light represents that of its neighbours, too. Its position is on one
   * of them: between spheres that are far apart there is more light than on any of them.
   */
  struct Sender
  {
    glm::vec3 Center;
    float Radius;
  };
  /** This is a range of senders whose mean an entry sends. */
  struct Mean
  {
    int First;
    int Count;
  };
  /** This is a bounding box of the regions of VTKI_ROW_LENGTH entries. */
  struct Block
  {
    glm::vec3 Lower;
    glm::vec3 Upper;
  };

  /**
   * Makes entries of spheres whose lengths are of order one, all radii positive and finite. angle:
   * the largest radius over distance at which a group counts as one; 0: no groups, and a sphere
   * counts within `reach` times its radius, or everywhere if that is 0.
   */
  void Build(const std::vector<vtkIndirectProxySphere>& spheres, double angle, double reach);

  /** Returns true if there are groups: entries with children. */
  bool HasGroups() const { return !this->Nodes.empty(); }
  const std::vector<Entry>& GetEntries() const { return this->Entries; }
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }
  const std::vector<Sender>& GetSenders() const { return this->Senders; }
  const std::vector<Mean>& GetMeans() const { return this->Means; }

private:
  struct Node
  {
    glm::dvec3 Center;
    double Radius;
    double Bound;
    double Share;
    double Inner;
    glm::dvec3 Albedo;
    size_t Children[4];
    int NumberOfChildren;
    size_t NumberOfSpheres;
    bool Exact;
    int Sender;
  };

  size_t MakeNode(const std::vector<vtkIndirectProxySphere>& spheres, size_t first, size_t end,
    double angle, double* moments);
  size_t FindHolding(
    const std::vector<vtkIndirectProxySphere>& spheres, size_t first, size_t end) const;
  void Split(const std::vector<vtkIndirectProxySphere>& spheres, size_t first, size_t end);
  void AddSenders(size_t node, int own);
  void AddEntries(size_t node, const Node* parent);
  void MakeBlocks();

  std::vector<size_t> Order; // order of the spheres
  size_t SpheresOfSender = 4;
  std::vector<Node> Nodes;
  std::vector<Entry> Entries;
  std::vector<Block> Blocks;
  std::vector<Sender> Senders;
  std::vector<Mean> Means;
};
