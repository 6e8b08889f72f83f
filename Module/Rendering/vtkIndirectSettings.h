// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkIndirectSettings.h
 * @brief Properties that are fields of a struct
 *
 * A public class of this module holds its numbers and flags in one struct, `Settings`: each
 * property is declared there, once, with its default. These macros are vtkSetClampMacro and
 * vtkSetMacro, with vtkGetMacro, for its fields. Vectors, strings and objects have VTK's own
 * macros.
 */

#ifndef vtkIndirectSettings_h
#define vtkIndirectSettings_h

/** Set and get a number of `Settings`; values outside of the range are clamped to it. */
#define vtkIndirectClampMacro(name, type, low, high)                                               \
  virtual void Set##name(type value)                                                               \
  {                                                                                                \
    const type clamped = value >= (low) ? (value <= (high) ? value : (high)) : (low);              \
    if (this->Settings.name != clamped)                                                            \
    {                                                                                              \
      this->Settings.name = clamped;                                                               \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual type Get##name() const                                                                   \
  {                                                                                                \
    return this->Settings.name;                                                                    \
  }

/** Set, get and switch a flag of `Settings`. */
#define vtkIndirectFlagMacro(name)                                                                 \
  virtual void Set##name(bool on)                                                                  \
  {                                                                                                \
    if (this->Settings.name != on)                                                                 \
    {                                                                                              \
      this->Settings.name = on;                                                                    \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual bool Get##name() const                                                                   \
  {                                                                                                \
    return this->Settings.name;                                                                    \
  }                                                                                                \
  void name##On()                                                                                  \
  {                                                                                                \
    this->Set##name(true);                                                                         \
  }                                                                                                \
  void name##Off()                                                                                 \
  {                                                                                                \
    this->Set##name(false);                                                                        \
  }

/** Tests that hide senders from receivers, of vtkIndirectIlluminationPass. */
enum vtkIndirectVisibilityType
{
  vtkIndirectVisibilityAutomatic = 0,
  vtkIndirectVisibilityNone,
  vtkIndirectVisibilityVoxels,
  vtkIndirectVisibilityMaps
};

/** Lights of a frame, of vtkIndirectIlluminationPass. */
enum vtkIndirectLightingType
{
  vtkIndirectLightingScene = 0,
  vtkIndirectLightingSoft,
  vtkIndirectLightingFull,
  vtkIndirectLightingGentle,
  vtkIndirectLightingStudio
};

/** The properties of vtkIndirectIlluminationPass, by their names. */
struct vtkIndirectSettings
{
  int Lighting = vtkIndirectLightingScene;
  bool Shadows = true;
  int Visibility = vtkIndirectVisibilityAutomatic;
  bool Antialiasing = true;
  int NumberOfBounces = 0; // automatic
  double IndirectScale = 1.0;
  double ErrorTolerance = 0.0;
  bool Caching = true;
  bool MapsFirst = false;
  int NumberOfRefinements = -1; // automatic
  double TimeBudget = 0.0;
  bool IdleFrames = true;
  bool SpheresInMotion = true;
  bool RemainingGeometry = true;
};

#endif
