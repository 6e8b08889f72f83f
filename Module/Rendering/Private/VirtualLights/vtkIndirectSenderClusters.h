// SPDX-License-Identifier: BSD-3-Clause
// A few virtual lights for the texels of many maps: places that several maps see are one sender
// with the light of all of them. The lights are nodes of a tree over the texels (Walter, Fernandez,
// Arbree, Bala, Donikian, Greenberg 2005, "Lightcuts"), and below each are two more generations of
// nodes, its branches, for receivers that are too near for a single light.
//
// Texels are divided, always those whose light lies farthest from its mean, by place and normal
// alike, until there are as many clusters as lights. A cluster's light is the sum of its texels',
// so no light is lost; it comes from a texel near its mean, a little before it.
//
// Which texels are together follows how much light each map has in steps only: a sky that changes a
// little moves no virtual light, so that what is kept by their places stays.
#ifndef vtkIndirectSenderClusters_h
#define vtkIndirectSenderClusters_h

#include <cstddef>     // for size_t
#include <cstdint>     // for numbers of senders
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
    float Smoothing = 1.0f; // the blunt area of a leaf that it is in, over its area
    // Of what it reflects specularly, where it does.
    glm::vec3 LobeDirection{ 0.0f, 0.0f, 1.0f };
    float LobeExponent = 0.0f;
    glm::vec3 LobeReflected{ 0.0f };
  };

  struct Light
  {
    glm::dvec3 Position{ 0.0 };
    /** The mean of what it stands for: shorter than one where that faces different ways. */
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
    double Area = 1.0;      // of the surface, or of a node the square that it sends light as
    double Stretched = 1.0; // that of a square whose variance is the light's
    double Shift = 0.0;     // how far before its place light comes from, in lengths of the normal
    /** By which it is blunt to nearby receivers (vtkiFindPatchLight): that of the leaves
     * around them, so that what is seen as whole farther off adds up with these. */
    double BluntArea = 1.0;
    glm::dvec3 DensityArea{ 0.0 };
    double Reach = 0.0; // nearer than this its branches are summed in its place
    /** One for the lobes of what it stands for, of the same flux, as wide as they are together. */
    glm::dvec3 LobeDirection{ 0.0, 0.0, 1.0 };
    double LobeExponent = 0.0;
    glm::dvec3 LobeDensityArea{ 0.0 };
  };

  /**
   * Leaves out the senders that no surface lies before: those on the outside of all places' convex
   * hull, such as the underside of a ground.
   */
  static void RemoveOutermost(std::vector<Sender>& senders, const std::vector<glm::vec3>& places);

  void SetSenders(std::vector<Sender> senders);
  const std::vector<Sender>& GetSenders() const { return this->Senders; }
  size_t GetNumberOfSenders() const { return this->Senders.size(); }

  struct Lights
  {
    std::vector<Light> Tops;
    /**
     * Those below each, vtkIndirectKernels::VTKI_BRANCHES of them a light: places that are left
     * over send nothing and have a reach below zero. Empty where no light has any.
     */
    std::vector<Light> Branches;
  };

  /**
   * At most so many lights of the senders under lights of these strengths, one for each map; where
   * `error` is not 0 as few as `least`, or half of them, once their light lies within `nearness` of
   * what they stand for, root mean square. No senders, no lights; as many as there are senders,
   * each of them is one. A light is divided where the error of having it whole is more than `error`
   * of the mean irradiance that the lights give each other; 0: never.
   */
  Lights MakeLights(const std::vector<glm::dvec3>& strengths, int count, double error,
    double nearness = StandardNearness, int least = 0);
  /** Enough along surfaces in one piece; many small objects take all lights. Scene units. */
  static constexpr double StandardNearness = 0.04;
  /** Enough where later bounces spread light over all surfaces, smoothly. */
  static constexpr double NearnessOfBounces = 0.05;

  /**
   * The error of a node for an error tolerance of the irradiance. A receiver sums several nodes
   * that are hardly farther than their reach, and most of their errors have one sign: a third of
   * the tolerance each keeps the mean within it.
   */
  static double FindError(double tolerance) { return 0.35 * tolerance; }

  size_t GetBytes() const;

private:
  // Three of place, three of normal.
  static constexpr int NumberOfAxes = 6;
  struct Entry
  {
    float Coordinates[NumberOfAxes];
    float Weight;
    uint32_t Sender;
  };
  struct Cluster
  {
    size_t Begin = 0; // of entries
    size_t End = 0;
    uint32_t Middle = 0; // the sender nearest to the mean, or to half a deviation before it
    double Mean[NumberOfAxes] = {};
    int Axis = 0;        // along which it is widest
    double Border = 0.0; // where it is divided along that
    double Order = 0.0;  // of its width: larger ones are divided first
    double Width = 0.0;  // light times squared distance from the mean
    double Spread = 0.0; // mean squared distance of the light's places from their mean
  };

  Cluster Measure(size_t begin, size_t end) const;
  uint32_t FindMiddle(const Cluster& cluster) const;
  std::vector<Cluster> Divide(size_t begin, size_t end, size_t least, size_t most);
  void DivideAll(const std::vector<double>& weights, int count, bool divides);
  Light MakeLight(const Cluster& cluster, const std::vector<glm::dvec3>& strengths) const;
  void CloseBowl(
    const Cluster& cluster, const std::vector<glm::dvec3>& strengths, Light& light) const;
  void AddLobe(
    const Cluster& cluster, const std::vector<glm::dvec3>& strengths, Light& light) const;
  static double FindReach(const Light& light, const Cluster& cluster, double limit);
  void MakeBranches(
    size_t top, const std::vector<glm::dvec3>& strengths, double limit, std::vector<Light>& all);

  std::vector<Sender> Senders;
  std::vector<double> Weights; // of maps
  int Count = 0;
  size_t Least = 1;
  double Nearness = 0.0;
  bool Divides = false; // into branches
  std::vector<Entry> Entries;
  std::vector<Cluster> Clusters;
};

/** Senders of other surfaces than those that maps show. */
struct vtkIndirectFurtherSenders
{
  /** Map: what covers each surface once, numbered from zero. */
  std::vector<vtkIndirectSenderClusters::Sender> Senders;
  size_t NumberOfMaps = 0;
  size_t Time = 0; // grows whenever they have changed
};

#endif
