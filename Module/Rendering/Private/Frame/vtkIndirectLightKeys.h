// SPDX-License-Identifier: BSD-3-Clause
// Properties of a light for which vtkLight has no method. They are kept in the light's information
// and vanish with the light. Users set them by static methods of vtkIndirectIlluminationPass, which
// document them.
#ifndef vtkIndirectLightKeys_h
#define vtkIndirectLightKeys_h

class vtkInformationDoubleKey;
class vtkLight;

namespace vtkIndirectLightKeys
{
vtkInformationDoubleKey* Radius(); // world units
vtkInformationDoubleKey* Angle();  // degrees
vtkInformationDoubleKey* Fill();   // share; 1: see vtkIndirectLight; set by presets alone

/** Returns a key's value for a light; 0 if it is not set. */
double Get(vtkLight* light, vtkInformationDoubleKey* key);
/** Sets a key's value, clamped to [0, most]; a value that is not a number becomes 0. */
void Set(vtkLight* light, vtkInformationDoubleKey* key, double value, double most);
}

#endif
