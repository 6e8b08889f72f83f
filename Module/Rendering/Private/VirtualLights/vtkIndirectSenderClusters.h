// SPDX-License-Identifier: BSD-3-Clause
// A few virtual lights for the texels of many maps: places that several maps see are one sender
// with the light of all of them.
//
// Texels are divided, always those whose light lies farthest from its mean, by place and normal
// alike, until there are as many clusters as lights. A cluster's light is the sum of its texels',
// so no light is lost; it comes from the texel nearest to its mean. Its area is that of the surface
// which its texels cover, not the sum over all maps that see it: each map's texels cover it once.
//
// Which texels are together follows how much light each map has in steps only: a sky that changes a
// little moves no virtual light, so that what is kept by their places stays.
#ifndef vtkIndirectSenderClusters_h
#define vtkIndirectSenderClusters_h

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkIndirectSenderClusters
{
public:
  /** A texel of a map. */
  struct Sender
  {
    glm::vec3 Position; // scene units
    glm::vec3 Normal;
    float Area;
    glm::vec3 Reflected; // density times area, of a light of strength one
    int Map;
  };

  struct Light
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
    double Area = 1.0;
    glm::dvec3 DensityArea{ 0.0 };
  };

  /**
   * Leaves out the senders that no surface lies before: those on the outside of all places' convex
   * hull, such as the underside of a ground.
   */
  static void RemoveOutermost(std::vector<Sender>& senders, const std::vector<glm::vec3>& places);

  void SetSenders(std::vector<Sender> senders);
  size_t GetNumberOfSenders() const { return this->Senders.size(); }

  /**
   * At most so many lights of the senders under lights of these strengths, one for each map. No
   * senders, no lights; as many as there are senders, each of them is one.
   */
  std::vector<Light> MakeLights(const std::vector<glm::dvec3>& strengths, int count);

  size_t GetBytes() const;

private:
  // Three of place, three of normal.
  static constexpr int NumberOfAxes = 6;
  struct Cluster
  {
    size_t Begin; // in Order
    size_t End;
    size_t Middle = 0; // the sender nearest to the mean
    double Mean[NumberOfAxes];
    int Axis = 0;       // along which it is widest
    double Width = 0.0; // light times squared distance from the mean
  };

  double GetCoordinate(size_t sender, int axis) const;
  double GetWeight(size_t sender) const;
  Cluster Measure(size_t begin, size_t end) const;
  size_t FindMiddle(const Cluster& cluster) const;
  void Divide(const std::vector<double>& weights, int count);

  std::vector<Sender> Senders;
  std::vector<double> Weights; // of maps
  int Count = 0;
  std::vector<size_t> Order;
  std::vector<Cluster> Clusters;
};

#endif
