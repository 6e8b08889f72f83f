// SPDX-License-Identifier: BSD-3-Clause
// Mappers of spheres that stand in for points that look like spheres: splats of
// vtkPointGaussianMapper that shader code cuts off, and points that VTK draws as spheres
// (vtkProperty::RenderPointsAsSpheres). VTK's own drawing of both has no surface in space: splats
// are flat and unlit, and points have a size in pixels. While a Scope lives, actors have the
// stand-ins in place of their mappers, without events and modification times, and all stages of a
// frame see spheres.
#pragma once

#include "OpenGL/vtkIndirectKey.h" // for keys

#include <glm/glm.hpp>   // for transforms
#include <unordered_map> // for actors

class vtkActor;
class vtkMatrix4x4;
class vtkRenderer;

class vtkIndirectPointSpheres
{
public:
  vtkIndirectPointSpheres();
  ~vtkIndirectPointSpheres();

  /** Actors have stand-ins during the lifetime. */
  class Scope
  {
  public:
    /** mayRest: radii of sizes in pixels may become exact when the view has not changed. */
    Scope(vtkIndirectPointSpheres& spheres, vtkRenderer* renderer, bool mayRest)
      : Spheres(spheres)
    {
      spheres.Update(renderer, mayRest);
      spheres.Exchange(false);
    }
    ~Scope() { this->Spheres.Exchange(false); }
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    vtkIndirectPointSpheres& Spheres;
  };

  /** Within a Scope: points whose size is in pixels are VTK's own while the eye looks at them. */
  class EyeScope
  {
  public:
    explicit EyeScope(vtkIndirectPointSpheres& spheres)
      : Spheres(spheres)
    {
      spheres.Exchange(true);
    }
    ~EyeScope() { this->Spheres.Exchange(true); }
    EyeScope(const EyeScope&) = delete;
    void operator=(const EyeScope&) = delete;

  private:
    vtkIndirectPointSpheres& Spheres;
  };

  /** Counts the actors that the picture draws by VTK's own mappers. */
  int CountPixelSized() const;

  /** Releases all stand-ins; not while a Scope lives. */
  void Forget();

private:
  struct StandIn;
  struct View
  {
    glm::dvec4 ToDepth{ 0.0 };  // of a place in world coordinates
    double RadiusOfPixel = 0.0; // times depth in a perspective
    double Nearest = 0.0;
    bool Parallel = false;
  };

  void Update(vtkRenderer* renderer, bool mayRest);
  void SetUpEye(vtkRenderer* renderer, bool mayRest);
  void Exchange(bool pixelSizedAlone);
  void Take(vtkActor* actor, vtkMatrix4x4* matrix, StandIn known);
  void FitRadii(StandIn& standIn, const glm::dmat4& toWorld);

  std::unordered_map<vtkActor*, StandIn> StandIns;
  vtkIndirectKey Seen; // the view of the last frame
  View Eye;
  bool FitsExactly = true;
};
