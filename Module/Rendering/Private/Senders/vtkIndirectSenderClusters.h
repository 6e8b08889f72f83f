// SPDX-License-Identifier: BSD-3-Clause
// A few virtual lights for the texels of many maps. Places that several maps see are one sender
// with the light of all of them. The lights are nodes of a tree over the texels (Walter, Fernandez,
// Arbree, Bala, Donikian, Greenberg 2005, "Lightcuts"), and below each light are two more
// generations of nodes, its branches, for receivers that are too near for a single light.
//
// The texels whose light lies farthest from its mean, by place, normal and radiosity, are divided
// until there are as many clusters as lights. A cluster's light is the sum of its texels' light, so
// no light is lost; it comes from a place near its mean texel, a little before it.
//
// The clusters depend on the maps' light in coarse steps only. A sky that changes a little moves no
// virtual light, so data that are kept by the lights' places stay valid.
#pragma once

#include "Scene/vtkIndirectSeen.h" // for the part that is seen

#include <cstddef>     // for size_t
#include <cstdint>     // for numbers of senders
#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

struct vtkIndirectFrame;

class vtkIndirectSenderClusters
{
public:
  /** A texel of a map. */
  struct Sender
  {
    glm::vec3 Position; // scene units
    glm::vec3 Normal;
    float Area;
    glm::vec3 Reflected;    // density times area, under a light of strength one
    int Map;                // the number of its strength
    float Smoothing = 1.0f; // contact softening of its leaf over the leaf's area
    // This is the lobe of specular reflection, if there is one.
    glm::vec3 LobeDirection{ 0.0f, 0.0f, 1.0f };
    float LobeExponent = 0.0f;
    glm::vec3 LobeReflected{ 0.0f };
    int Cover = -1; // a set of senders that covers each surface once; below zero: its map's
  };

  struct Light
  {
    glm::dvec3 Position{ 0.0 };
    /** The mean normal of its senders: shorter than one if they face different ways. */
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
    double Area = 1.0; // area of the surface; for a node the area of the square that represents it
    double Stretched = 1.0; // area of a square whose variance is that of the light
    double Shift = 0.0;     // distance from its place to the origin of its light, in lengths of the
                            // normal
    /**
     * This is the area that softens contacts with nearby receivers (vtkiFindPatchLight): that of
     * the leaves around the receivers, so that nodes that are seen as a whole from farther off add
     * up with these leaves.
     */
    double ContactSoftening = 1.0;
    glm::dvec3 DensityArea{ 0.0 };
    double ChildDistance = 0.0; // receivers nearer than this sum its branches in its place
    /** One lobe in place of the lobes of its senders, with their flux and their total width. */
    glm::dvec3 LobeDirection{ 0.0, 0.0, 1.0 };
    double LobeExponent = 0.0;
    glm::dvec3 LobeDensityArea{ 0.0 };
    /** The senders that it represents are these, see GetSender. */
    size_t Begin = 0;
    size_t End = 0;
    double Spread = 0.0; // mean squared distance of their light's places from its mean
    double Share = 1.0;  // the share of their light that it sends
  };

  void SetSenders(std::vector<Sender> senders);
  /** Sets the part of the scene whose receivers count: lights near it are finer. */
  void SetSeen(const vtkIndirectSeenBox& seen);
  const vtkIndirectSeenBox& GetSeen() const { return this->Seen; }
  const std::vector<Sender>& GetSenders() const { return this->Senders; }
  size_t GetNumberOfSenders() const { return this->Senders.size(); }
  /** Returns a sender in the order of the last lights: those of a light follow each other. */
  const Sender& GetSender(size_t place) const { return this->Senders[this->Entries[place].Sender]; }

  struct LightTree
  {
    std::vector<Light> Lights;
    /**
     * The nodes below each light, vtkIndirectKernels::VTKI_BRANCHES for each: unused places send
     * nothing and have a child distance below zero. Empty if no light has branches.
     */
    std::vector<Light> Branches;
  };

  /**
   * Returns the senders in at most `count` groups of those that are near each other and face alike;
   * the first of each group is in its middle.
   */
  std::vector<std::vector<size_t>> FindGroups(int count);

  /**
   * Makes at most `count` lights of the senders, under lights of these strengths, one for each map.
   * If `error` is not 0, there may be as few as `least` lights, or half of them, once their light
   * lies within `nearness` of the senders, root mean square; and there may be as many as `narrow`,
   * until they look narrow from the senders. Without senders there are no lights; if there are no
   * more senders than lights, each sender is a light. A light is divided where the
   * error of the whole light exceeds `error` times the mean irradiance that the lights give each
   * other; 0: never.
   */
  LightTree MakeLights(const std::vector<glm::dvec3>& strengths, int count, double error,
    double nearness = StandardNearness, int least = 0, int narrow = 0);
  /**
   * This nearness suffices along connected surfaces; many small objects take all lights. Scene
   * units.
   */
  static constexpr double StandardNearness = 0.04;
  /**
   * Returns the number beyond which lights need not be narrower. Each depth map draws as many
   * triangles as the casters have; all of them together take a second, or four where the eye sees a
   * part of the scene, whose lights and receivers are near each other.
   */
  static int FindMostNarrow(const vtkIndirectFrame& frame, int most);
  /** This nearness suffices where later bounces spread light smoothly over all surfaces. */
  static constexpr double NearnessOfBounces = 0.05;

  /**
   * Returns the error of a node for an error tolerance of the irradiance. A receiver sums several
   * nodes that are little farther than their child distance, and most of their errors have the same
   * sign. A third of the tolerance for each would keep the mean within it on smooth surfaces.
   * Horizons and folds that cut nodes need a twentieth: with it the relMSE to a path tracer is
   * 0.015 for a brain and 0.007 for a living room, with a third 0.025 and 0.010.
   */
  static double FindError(double tolerance) { return 0.05 * tolerance; }

  /**
   * Returns the distance within which the error of a node's irradiance exceeds the limit. strength:
   * density times area; spread: mean squared distance of the light's places from their mean.
   */
  static double FindChildDistance(double strength, double spread, double limit);
  /** Returns the same for a light; 0 for a single sender, or a limit of 0. */
  static double FindChildDistance(const Light& light, double limit);
  /**
   * Returns a scale of the scene's irradiance under the lights of such a flux, the sum of their
   * density times area, mean of the colours.
   */
  double FindMeanIrradiance(double flux) const;

  size_t GetBytes() const;

private:
  // A sender has three coordinates of its place, three of its normal, one of its brightness.
  static constexpr int NumberOfAxes = 7;
  // The length of a unit normal in scene units: surfaces that face each other are as far apart as
  // the ends of half a scene.
  static constexpr double NormalLength = 0.25;
  // A choice must be so much better to replace another one. Texels in rows have many choices that
  // are equal except for rounding; if rounding decided, lights would jump.
  static constexpr double Margin = 0.01;
  struct Entry
  {
    float Coordinates[NumberOfAxes];
    float Weight;
    uint32_t Sender;
  };
  struct Cluster
  {
    size_t Begin = 0; // first entry
    size_t End = 0;
    uint32_t Middle = 0; // sender nearest to the mean, or to half a deviation in front of it
    double Mean[NumberOfAxes] = {};
    int Axis = 0;        // axis along which it is widest
    double Border = 0.0; // place along Axis at which it is divided
    double Order = 0.0;  // rank of its width: larger ones are divided first
    double Width = 0.0;  // light times squared distance from the mean, times the importance
    double Weight = 0.0; // its light
    double Spread = 0.0; // mean squared distance of the light's places from their mean
  };

  /** Numbers of clusters. */
  struct Numbers
  {
    size_t Least = 1;
    size_t Near = 1;   // the number beyond which clusters need not be nearer
    size_t Narrow = 1; // the number beyond which clusters need not be narrower
    bool operator==(const Numbers& other) const
    {
      return this->Least == other.Least && this->Near == other.Near && this->Narrow == other.Narrow;
    }
  };

  Cluster Measure(size_t begin, size_t end) const;
  uint32_t FindMiddle(const Cluster& cluster) const;
  std::vector<size_t> FindAsked() const;
  bool AreNarrow(const std::vector<Cluster>& clusters, const std::vector<size_t>& asked) const;
  std::vector<Cluster> Divide(size_t begin, size_t end, Numbers numbers);
  void DivideAll(const std::vector<double>& weights, const Numbers& numbers, bool divides);
  double FindOverlap(size_t begin, size_t end, const std::vector<glm::dvec3>& strengths) const;
  std::vector<double> FindOverlaps(const std::vector<glm::dvec3>& strengths) const;
  Light MakeLight(
    const Cluster& cluster, const std::vector<glm::dvec3>& strengths, double overlap) const;
  void CloseBowl(
    const Cluster& cluster, const std::vector<glm::dvec3>& strengths, Light& light) const;
  void AddLobe(
    const Cluster& cluster, const std::vector<glm::dvec3>& strengths, Light& light) const;
  void MakeBranches(size_t top, const std::vector<glm::dvec3>& strengths, double limit,
    double overlap, std::vector<Light>& all);

  std::vector<Sender> Senders;
  vtkIndirectSeenBox Seen;
  std::vector<double> Weights; // weights of maps
  Numbers Wanted;
  double Nearness = 0.0;
  bool Divides = false; // true if lights are divided into branches
  double Sides = 0.0;   // area of the sides of the box around the senders
  std::vector<Entry> Entries;
  std::vector<Cluster> Clusters;
};

/** These are the senders of surfaces that are not in the maps. */
struct vtkIndirectFurtherSenders
{
  /** Map: the number, from zero, of a set of senders that covers each surface once. */
  std::vector<vtkIndirectSenderClusters::Sender> Senders;
  size_t NumberOfMaps = 0;
  size_t Time = 0; // grows whenever the senders change
};
