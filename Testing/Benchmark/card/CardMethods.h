// SPDX-License-Identifier: BSD-3-Clause
// The methods that are measured: the rows of each table.
#ifndef CardMethods_h
#define CardMethods_h

#include <functional> // for the settings
#include <string>     // for names
#include <vector>     // for the table

class vtkIndirectIlluminationPass;

namespace card
{
class Scene;

struct Method
{
  const char* Name;
  const char* Meaning;
  /** Sets a new pass up; empty for the yardsticks, which are without it. */
  std::function<void(vtkIndirectIlluminationPass*)> SetUp;
  /**
   * Share of places whose irradiance another OpenGL may change by any amount: where edges fall, and
   * whether a sample or a ray that grazes the face of a texel or a voxel is on this or that side of
   * it. Between Mesa's two software renderers 4.8 % were seen in a room whose walls lie along both.
   * Everything where a random walk finds the senders: rounding sends some paths elsewhere, and
   * clusters are others. There the error against the path tracer is compared.
   */
  double Share;

  bool IsWalked() const { return this->Share >= 1.0; }
};

const std::vector<Method>& GetMethods();

/** Throws std::runtime_error with the names that there are. */
const Method& FindMethod(const std::string& name);

/** Puts the method on the scene's renderer; returns its pass, which the renderer owns, or nullptr.
 */
vtkIndirectIlluminationPass* Enable(Scene& scene, const Method& method);
}

#endif
