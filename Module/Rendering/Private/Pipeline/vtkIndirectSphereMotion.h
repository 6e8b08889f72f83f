// SPDX-License-Identifier: BSD-3-Clause
// Whether spheres move, frame after frame, so that depth maps of the sky would have to be drawn
// anew each time, and whether spheres can take their place in this scene.
//
// Motion begins with the second frame on end whose spheres are elsewhere than in the one before. It
// ends with the first frame that nobody awaits another after (see vtkIndirectPlan::Interactive) and
// in which nothing has moved, else with the ninth of these on end: data often come more slowly than
// a camera turns, and the picture is not to change in between. Eyes and tiles of one picture have
// one answer.
//
// Splats that are cut off like spheres are in no depth map: with them all frames are as in motion,
// still ones too, so that what they hide does not come and go.
#ifndef vtkIndirectSphereMotion_h
#define vtkIndirectSphereMotion_h

#include "Proxies/vtkIndirectProxyKinds.h" // for a member
#include "vtkType.h"                       // for times

#include <string>        // for reasons
#include <unordered_map> // for what was before
#include <vector>        // for places

class vtkEnvironmentLight;
class vtkProp;
struct vtkIndirectFrame;

class vtkIndirectSphereMotion
{
public:
  /** Once a frame. */
  void Update(const vtkIndirectFrame& frame, vtkEnvironmentLight* environment, bool interactive);

  /** What moves; empty where nothing does. */
  const std::string& GetWhat() const { return this->What; }
  /** Why spheres cannot stand for what hides the sky; empty where they can, or nothing moves. */
  const std::string& GetWhyNot() const { return this->WhyNot; }
  /** Whether what is there now has moved once, and could be summed by spheres. */
  bool HasMoved() const { return this->Moved; }
  void Forget();

private:
  static double CountSplats(const vtkIndirectFrame& frame);
  double FindMovedSpheres(const vtkIndirectFrame& frame);
  std::string FindWhyNot(const vtkIndirectFrame& frame, double spheres);
  bool HasSun(vtkEnvironmentLight* environment);

  struct Before
  {
    vtkTypeUInt64 Revision = 0;
    std::vector<double> Places;
    double NumberOfSpheres = 0.0;
  };
  std::unordered_map<vtkProp*, Before> Props;
  vtkIndirectProxyKinds Kinds;
  int Changes = 0; // frames on end
  int Idle = 0;    // and then those without
  bool Moved = false;
  std::string What;
  std::string WhyNot;

  vtkEnvironmentLight* Environment = nullptr; // whose sun it is, and its time
  vtkMTimeType EnvironmentTime = 0;
  bool Sun = false;
};
#endif
