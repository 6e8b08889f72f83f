// SPDX-License-Identifier: BSD-3-Clause
// Keys for properties of props and lights for which VTK has no method. A prop's keys are in
// vtkProp::SetPropertyKeys and set what the prop takes part in; a light's keys are in the light's
// information and vanish with the light. Users reach them by static methods of
// vtkIndirectIlluminationPass, which document them.
#pragma once

class vtkInformationDoubleKey;
class vtkInformationIntegerKey;
class vtkInformationStringKey;
class vtkLight;
class vtkProp;

namespace vtkIndirectInformationKeys
{
vtkInformationIntegerKey* CastsShadows();
vtkInformationIntegerKey* SendsLight();
vtkInformationIntegerKey* CatchesLight();
vtkInformationStringKey* Name();
vtkInformationDoubleKey* LightRadius(); // world units
vtkInformationDoubleKey* LightAngle();  // degrees
vtkInformationDoubleKey* LightFill();   // share; 1: see vtkIndirectLight; set by presets alone

/** Returns the value of a prop's key; `otherwise` if it is not set. */
bool IsSet(vtkProp* prop, vtkInformationIntegerKey* key, bool otherwise = true);
/** Returns a key's value for a light; 0 if it is not set. */
double Get(vtkLight* light, vtkInformationDoubleKey* key);
/**
 * Sets a key's value, clamped to [0, most]; a value that is not a number becomes 0. No light is an
 * error.
 */
void Set(vtkLight* light, vtkInformationDoubleKey* key, double value, double most);
}
