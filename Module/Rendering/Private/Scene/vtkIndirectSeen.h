// SPDX-License-Identifier: BSD-3-Clause
// The part of the scene that the eye sees, where the scene reaches far beyond the picture: maps of
// lights and of the sky are fitted to this part, so that their texels are fine where the camera
// looks.
#pragma once

#include "OpenGL/vtkIndirectKey.h" // for keys

#include <glm/glm.hpp>

#include <algorithm> // for the larger number
#include <cmath>     // for floor
#include <cstddef>   // for places in a list
#include <limits>    // for the largest number
#include <vector>    // for places

/**
 * An interval of a map or of an axis, of half a length, a share of this, the same share of the
 * result, and so on, whose middle is a multiple of a quarter of its half width. A camera that moves
 * a little thus keeps the interval.
 */
struct vtkIndirectInterval
{
  double Middle = 0.0;
  double Half = 0.0;

  /**
   * Returns the shortest interval that holds two places, `most` long on either side of its middle,
   * or, around zero, if even this one does not hold them. least: of the half width; share: of each
   * length in the next longer one.
   */
  static vtkIndirectInterval Find(
    double lower, double upper, double most, double least = 0.0, double share = 0.5)
  {
    constexpr double parts = 4.0;
    constexpr double shortest = 1.0 / (1 << 24);
    // The middle moves by half a step at most.
    const double needed = std::max(0.5 * (upper - lower) / (1.0 - 0.5 / parts), least);
    double half = most;
    // The first comparison is false for an axis without length.
    for (double next = 0.5 * most; next > shortest * most && next >= needed; next *= share)
    {
      half = next;
    }
    const double step = half / parts;
    return half < most
      ? vtkIndirectInterval{ step * std::floor(0.5 * (lower + upper) / step + 0.5), half }
      : vtkIndirectInterval{ 0.0, most };
  }
};

/**
 * A box around what the eye sees. It counts where its largest side has an eighth of the area of the
 * scene's largest side, or less.
 */
struct vtkIndirectSeenBox
{
  double Share = 1.0;       // of its largest side in the scene's
  glm::dvec3 Middle{ 0.0 }; // along the world's axes, scene units
  glm::dvec3 Half{ 0.0 };
  // A larger part has its share of all lights and texels, and changes as the camera turns.
  static constexpr double MostOfPart = 0.125;

  /** Returns false if the eye sees most of the scene, and the box means nothing. */
  bool IsPart() const { return this->Share <= MostOfPart; }
  /**
   * Returns the weight of a squared error of light from a place, for receivers in the box: light
   * falls with the square of the distance, and so does the angle at which a deviation of its place
   * is seen. One in the box.
   */
  double FindImportance(const glm::dvec3& place) const
  {
    const glm::dvec3 beside =
      glm::max(glm::abs(place - this->Middle) - this->Half, glm::dvec3(0.0));
    const double ratio = glm::dot(beside, beside) / glm::dot(this->Half, this->Half);
    return this->IsPart() ? 1.0 / ((1.0 + ratio) * (1.0 + ratio)) : 1.0;
  }
  /** Returns how far the box reaches from its middle along a unit axis. */
  double FindReach(const glm::dvec3& axis) const { return glm::dot(glm::abs(axis), this->Half); }
  void AppendTo(vtkIndirectKey& key) const
  {
    if (this->IsPart())
    {
      key.Add("seen part", this->Middle).Add("seen part", this->Half);
    }
  }
  bool operator==(const vtkIndirectSeenBox& other) const
  {
    return this->IsPart() == other.IsPart() &&
      (!this->IsPart() || (this->Middle == other.Middle && this->Half == other.Half));
  }
};

struct vtkIndirectSeen
{
  struct Place
  {
    glm::dvec3 At{ 0.0 }; // scene units
    double Pixel = 0.0;   // width of a pixel of the picture there, scene units
  };
  std::vector<Place> Places; // at the pixels of a small picture
  vtkIndirectSeenBox Box;    // around all of them
  /**
   * Around the nearer half: a view of the horizon does not make this box as large as the scene.
   * Lights and maps of the sky are finer near it. Around three quarters, a town of 500 m before the
   * horizon had 8 % of its near pixels off by more than 32 levels, around the half none.
   */
  vtkIndirectSeenBox Near;
  bool BoxesAreKept = false; // a moving frame has those of a still one

  /** Returns true if the nearer box is so much smaller that maps of it alone are finer. */
  bool IsNearFiner() const
  {
    return this->Near.IsPart() &&
      this->Near.Share <=
      vtkIndirectSeenBox::MostOfPart * (this->Box.IsPart() ? this->Box.Share : 1.0);
  }

  /** Returns a quarter of the area of a box's largest side. */
  static double FindArea(const glm::dvec3& half)
  {
    return std::max({ half.x * half.y, half.y * half.z, half.z * half.x });
  }

  /** Finds the boxes. reach: the greatest coordinates of the scene, scene units. */
  void FindBoxes(const glm::dvec3& reach)
  {
    this->Box = {};
    this->Near = {};
    if (this->Places.empty())
    {
      return;
    }
    std::vector<double> pixels;
    for (const Place& place : this->Places)
    {
      pixels.push_back(place.Pixel);
    }
    // Pixels are wider where they are farther.
    const auto widest = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2);
    std::nth_element(pixels.begin(), widest, pixels.end());
    this->Near = this->FindBox(*widest, reach);
    this->Box = this->FindBox(std::numeric_limits<double>::max(), reach);
  }

private:
  // Finds a box around the places whose pixels are no wider.
  vtkIndirectSeenBox FindBox(double widest, const glm::dvec3& reach) const
  {
    glm::dvec3 lower(std::numeric_limits<double>::max());
    glm::dvec3 upper = -lower;
    for (const Place& place : this->Places)
    {
      lower = place.Pixel <= widest ? glm::min(lower, place.At) : lower;
      upper = place.Pixel <= widest ? glm::max(upper, place.At) : upper;
    }
    // Surfaces between the places may lie a little beside all of them.
    const glm::dvec3 margin = 0.0625 * (upper - lower);
    vtkIndirectSeenBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIndirectInterval held = vtkIndirectInterval::Find(
        lower[axis] - margin[axis], upper[axis] + margin[axis], reach[axis]);
      box.Middle[axis] = held.Middle;
      box.Half[axis] = held.Half;
    }
    box.Share = FindArea(box.Half) / FindArea(reach);
    return box;
  }
};
