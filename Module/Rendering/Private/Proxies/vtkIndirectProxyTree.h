// SPDX-License-Identifier: BSD-3-Clause
// Spheres in groups of groups: from afar a group is summed as one sphere that lets a share of the
// light through. After the hierarchies of Ren, Wang, Snyder, Zhou, Liu, Sun, Hua, Guo, Shum 2006,
// "Real-time soft shadows in dynamic scenes using spherical harmonic exponentiation".
//
// A group's sphere has the second moment of its spheres' cross sections, those of a ball; it hides
// the share of its disk that is the area of their silhouette, meaned over directions: spheres of a
// group lie beside each other rather than at random, and hide less of each other than those would,
// or are half inside of each other. Sums of logarithms hide twice what lies behind each other; a
// group does not.
//
// Every entry says itself where it counts: within `Outer` of its parent's centre, where the parent
// is too near to stand for it, and beyond `Inner` of its own. Both change over smoothly, and over
// any place the weights of all that stand for a sphere add up to one. So each entry can be tested
// alone, in any order.
#ifndef vtkIndirectProxyTree_h
#define vtkIndirectProxyTree_h

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
    float Outer; // it counts within; all of it within vtkiProxyBand of that
    glm::vec3 Albedo;
    float Share; // of the light that its disk hides
    float Inner; // the same the other way round: nothing of it counts well within; 0: it does, as
                 // a sphere that stands for a surface; -1: as one that is drawn
    int Sender; // whose light it sends: a place among the senders, or from there on among the means
    int Next;   // the entry after it and all below it, which follow it; -1: none
    float Bound; // radius about its centre that it and all below it are within
  };
  /**
   * A sphere whose light stands for that of those next to it, too. It is one of them: between
   * spheres that are far apart there is more light than at any of them.
   */
  struct Sender
  {
    glm::vec3 Center;
    float Radius;
  };
  /** Senders that are sent as one: so many from one on. */
  struct Mean
  {
    int First;
    int Count;
  };
  /** A box about the places where any of VTKI_ROW_LENGTH entries counts. */
  struct Block
  {
    glm::vec3 Lower;
    glm::vec3 Upper;
  };

  /**
   * Makes entries of spheres whose lengths are of order one, all radii positive and finite. angle:
   * the largest radius over distance under which a group is one; 0: no groups, and a sphere counts
   * within `reach` times its radius, or everywhere if that is 0.
   */
  void Build(const std::vector<vtkIndirectProxySphere>& spheres, double angle, double reach);

  /** Whether there are groups: entries with others below them. */
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

  std::vector<size_t> Order; // of the spheres
  size_t SpheresOfSender = 4;
  std::vector<Node> Nodes;
  std::vector<Entry> Entries;
  std::vector<Block> Blocks;
  std::vector<Sender> Senders;
  std::vector<Mean> Means;
};
#endif
