// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the C++ side of the image suite: a case is a name and a function that sets a picture
// up. ImageReference.h has the comparison and its tolerances.
#ifndef ImagePicture_h
#define ImagePicture_h

#include "vtkIndirectContractUtilities.h"

#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

#include <string>
#include <vector>

namespace images
{
/**
 * A window of 160 x 120 pixels with one renderer and a pass, which sums 256 virtual lights at each
 * pixel unless a case sets another method: not the automatic choice, which may change.
 */
struct Picture : contract::View
{
  /** A buffer of a pass, compared beside the picture; the label is its name in the file. */
  struct Buffer
  {
    std::string Label;
    vtkIndirectIlluminationPass* Pass;
    std::string Channel;
  };

  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkRSMGatherPass> Gather;
  vtkNew<vtkUniformLightSampler> Sampler;
  std::vector<Buffer> Buffers;

  explicit Picture(int width = 160, int height = 120);
  /** Shows a channel in place of the picture, and compares it in place of final and irradiance. */
  void ShowChannel(const std::string& channel);
  /** Adds `final` and `irradiance` of another renderer's pass. */
  void AddBuffers(const std::string& prefix, vtkIndirectIlluminationPass* pass);
};

/** An argument of VTK's harness: -T folder, -V baseline. Fails the test if it is missing. */
std::string GetArgument(const std::string& flag);

/** Sets the picture up, renders it, writes the results, and compares it with the baseline. */
void Run(const std::string& name, void (*draw)(Picture& picture));

///@{
/** Scenes: a room with coloured walls, a court without ceiling; a sphere in each. */
void AddRoom(Picture& picture);
void AddRoomSurfaces(Picture& picture);
/** Sets the intensity of the room's light. */
void SetIntensity(Picture& picture, double intensity);
void AddCourt(vtkRenderer* renderer);
/** The sun of the court. */
vtkSmartPointer<vtkLight> AddSun(vtkRenderer* renderer);
///@}
}

/** Defines a case. CMake finds it by this word at the beginning of a line. */
#define VTK_INDIRECT_IMAGE(name)                                                                   \
  static void Draw##name(images::Picture& picture);                                                \
  VTK_INDIRECT_TEST(name)                                                                          \
  {                                                                                                \
    images::Run(#name, Draw##name);                                                                \
  }                                                                                                \
  static void Draw##name(images::Picture& picture)

#endif
